#pragma once

#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "gpu/pipeline.h"
#include "render/devicescene.h"
#include "render/marchpipeline.h"

#include <optional>
#include <span>

namespace dsphere {

/// The two pipelines that fill a film: PRECISION_FILTER on tiles, then PRECISION_FULL on the pixels that it left.
class Pass {
  public:
    /// Film pixels that one run() can take.
    static constexpr std::uint64_t kMostPixels = 1u << 20;

    /// Compiles and warms up the first pipeline; the second one follows when a pixel needs it. The scene, the film and
    /// all else must outlive the pass. `mask`: the film's planes.
    Pass(gpu::Device& device, const PackedScene& packed, const DeviceScene& device_scene, const gpu::StorageImage& film,
         Marcher marcher, std::uint32_t mask);

    /// Renders the tiles, one RenderParams each, of at most kMostPixels together; returns the device's seconds.
    double run(std::span<const layout::RenderParams> tiles);
    /// Pixels that were done again, so far.
    std::uint64_t retried() const { return retried_; }

  private:
    gpu::ComputePipeline makePipeline(Precision precision) const;
    void warmUp(const gpu::ComputePipeline& pipeline);
    double retry(layout::RenderParams params);

    gpu::Device& device_;
    const PackedScene& packed_;
    Marcher marcher_;
    std::uint32_t mask_;
    gpu::Buffer retry_list_;  ///< RetryHead, then pixels
    gpu::ComputePipeline filter_;
    std::optional<gpu::ComputePipeline> full_;
    gpu::BindingSet set_;
    gpu::Batch batch_;
    std::uint64_t retried_ = 0;
};

}  // namespace dsphere
