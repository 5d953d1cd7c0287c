#pragma once

#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "gpu/pipeline.h"
#include "render/devicescene.h"
#include "render/marchpipeline.h"

#include <optional>
#include <span>

namespace dsphere {

/// The pipelines that fill a film with the planes of one mask: MARCH_FILTER, and MARCH_FULL for the pixels that it
/// leaves; or MARCH_BASELINE, which leaves none. The second is made when a pixel needs it.
class PassPipelines {
  public:
    /// `stride`: safeStride().
    PassPipelines(gpu::Device& device, const SceneTraits& traits, float stride, const MarchMethod& method,
                  std::uint32_t mask);

    const gpu::ComputePipeline& first() const { return first_; }
    const gpu::ComputePipeline& full();
    /// Whether full() was dispatched: the first time drivers may compile.
    bool full_is_warm = false;

  private:
    gpu::ComputePipeline make(std::span<const std::uint32_t> spirv) const;

    gpu::Device* device_;
    SceneTraits traits_;
    float stride_;
    MarchMethod method_;
    std::uint32_t mask_;
    gpu::ComputePipeline first_;
    std::optional<gpu::ComputePipeline> full_;
};

/// Makes those of an exact marcher, all at once, for the device to find when they are asked for: on a thread of the
/// caller's, while others use the device, and before the scene's maps are read.
void makeAhead(gpu::Device& device, const SceneTraits& traits, const MarchMethod& method, std::uint32_t mask);

/// One film, filled in two steps: tiles by the one pipeline, then the pixels that it left by the other.
class Pass {
  public:
    /// Film pixels that one run() can take.
    static constexpr std::uint64_t kMostPixels = 1u << 20;

    /// Warms the pipeline up. All that is given must outlive the pass.
    Pass(gpu::Device& device, PassPipelines& pipelines, const DeviceScene& device_scene, const gpu::StorageImage& film);

    /// Renders the tiles, one RenderParams each, of at most kMostPixels together; returns the device's seconds.
    double run(std::span<const layout::RenderParams> tiles);
    /// Pixels that were done again, so far.
    std::uint64_t retried() const { return retried_; }

  private:
    void warmUp(const gpu::ComputePipeline& pipeline);
    void warmUpFull(const layout::RetryHead& head);
    double retry(const layout::RetryHead& head, const layout::RenderParams& params);

    PassPipelines& pipelines_;
    gpu::Buffer retry_list_;  ///< RetryHead, then pixels
    gpu::Buffer head_;        ///< the head, for the host
    gpu::BindingSet set_;
    gpu::Batch batch_;
    std::uint64_t retried_ = 0;
};

}  // namespace dsphere
