#pragma once

#include "gpu/commands.h"
#include "gpu/pipeline.h"
#include "render/devicescene.h"
#include "render/leftovers.h"
#include "render/marchpipeline.h"

#include <future>
#include <optional>
#include <span>

namespace dsphere {

/// The pipelines that fill a film with the planes of one mask: search_filter, and search_full for the pixels that it
/// leaves; or search_baseline, which leaves none, as a filter without a displaced sphere leaves none.
class FilmPipelines {
  public:
    /// `stride`: safeStride(). Returns once first() is made.
    FilmPipelines(gpu::Device& device, const SceneTraits& traits, float stride, const MarchMethod& method,
                  std::uint32_t mask);

    const gpu::ComputePipeline& first() const { return *first_; }
    /// Null: there is none. Waits until it is made; throws what its making threw.
    const gpu::ComputePipeline* full() const { return full_.valid() ? &full_.get() : nullptr; }
    /// Of pixels, that a workgroup of first() fills; GROUP_SIZE_Y rows.
    int columns() const { return columns_; }

    /// What a pixel of the last sample took, of whatever picture: the first round of the next is sized by it. 0:
    /// unknown.
    double pixel_seconds = 0.0;

  private:
    std::optional<gpu::ComputePipeline> first_;
    std::shared_future<gpu::ComputePipeline> full_;  ///< without a state: there is none
    int columns_ = GROUP_SIZE_X;
};

/// Makes those of an exact marcher for the device to find when they are asked for: on a thread of their own, while
/// others use the device, and before the scene's maps are read. The device must outlive the future, which has no state
/// for a baseline: its stride may depend on the maps.
std::future<void> makeAhead(gpu::Device& device, const SceneTraits& traits, const MarchMethod& method,
                            std::uint32_t mask);
/// Does what makeAhead does, and has the driver compile what it leaves for the first dispatch. Nobody else may use the
/// device meanwhile.
std::future<void> warmAhead(gpu::Device& device, const SceneTraits& traits, const MarchMethod& method,
                            std::uint32_t mask);

/// One film, filled in two steps: tiles by the one pipeline, then the pixels that it left by the other.
class FilmTracer {
  public:
    /// Film pixels that one run() can take: a list of 64 MiB if it must hold them all.
    static constexpr std::uint64_t kMostPixels = 1u << 23;

    /// Warms the pipelines up. All that is given must outlive the tracer.
    FilmTracer(gpu::Device& device, FilmPipelines& pipelines, const DeviceScene& device_scene,
               const gpu::StorageImage& film);

    /// Renders the tiles, one RenderParams each, of at most kMostPixels together; returns the device's seconds.
    double run(std::span<const layout::RenderParams> tiles);
    /// Pixels that were done again, so far.
    std::uint64_t retried() const { return leftovers_.retried(); }
    /// Pixels for which a search was given up, so far.
    std::uint64_t givenUp() const { return leftovers_.givenUp(); }
    /// FilmPipelines::columns().
    int columns() const { return pipelines_.columns(); }
    /// FilmPipelines::pixel_seconds.
    double& pixelSeconds() { return pipelines_.pixel_seconds; }

  private:
    void warmUp();

    FilmPipelines& pipelines_;
    Leftovers leftovers_;
    std::uint32_t threads_;  ///< that a dispatch is shared out to; 1 on a device that needs no help with that
    gpu::BindingSet set_;
    gpu::Batch batch_;
};

}  // namespace dsphere
