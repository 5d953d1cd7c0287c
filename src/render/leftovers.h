#pragma once

#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "gpu/pipeline.h"
#include "render/absentlist.h"

#include <cstdint>

namespace dsphere {

namespace gpu {
class Device;
}

/// What the first pipeline of a submission leaves of its pixels or rays: those that full precision must decide
/// (BINDING_RETRY), and those that wait for a tile of heights (BINDING_ABSENT).
class Leftovers {
  public:
    /// The pipelines that take them.
    struct Pipelines {
        const gpu::ComputePipeline& first;  ///< for those that waited
        const gpu::ComputePipeline* full;   ///< search_full, for the others; null: there are none
    };

    /// For submissions of at most `capacity` pixels or rays. The pool must outlive it.
    Leftovers(gpu::Device& device, TilePool& pool, std::uint64_t capacity);

    const gpu::Buffer& retryList() const { return retry_list_; }
    const gpu::Buffer& absentList() const { return absent_.buffer(); }
    /// Empties the lists: before the first dispatch of a submission.
    void reset(gpu::Batch& batch) const;
    /// Runs the dispatches that `batch` has, and those of what they leave, until nothing is left; returns the device's
    /// seconds. `params` are pushed with each.
    template <typename Params>
    double run(gpu::Batch& batch, const gpu::BindingSet& set, const Pipelines& pipelines, const Params& params) {
        return run(batch, set, pipelines, &params, sizeof(params));
    }
    /// How many full precision has decided, so far.
    std::uint64_t retried() const { return retried_; }
    /// Of how many MAX_STEPS has ended a search, so far.
    std::uint64_t givenUp() const { return given_up_; }

  private:
    double run(gpu::Batch& batch, const gpu::BindingSet& set, const Pipelines& pipelines, const void* params,
               std::uint32_t bytes);

    gpu::Buffer retry_list_;  ///< RetryHead, then RetryPixels
    gpu::Buffer head_;        ///< the head, for the host
    AbsentList absent_;
    std::uint64_t retried_ = 0, given_up_ = 0;
};

}  // namespace dsphere
