#pragma once

#include <cstdint>
#include <string>
#include <type_traits>

#include "gpu/handle.h"

namespace dsphere::gpu {

class BindingSet;
class Buffer;
class ComputePipeline;
class Device;

/// A command buffer with its fence: records, then submits and waits. Used by Batch and the transfers.
class CommandBuffer {
  public:
    CommandBuffer(Device& device, const std::string& name);
    ~CommandBuffer();
    CommandBuffer(const CommandBuffer&) = delete;
    CommandBuffer& operator=(const CommandBuffer&) = delete;

    /// Discards what was recorded and starts anew.
    void begin();
    /// Ends, submits and waits; returns the seconds from submit to fence on the host's clock.
    double submit();
    VkCommandBuffer handle() const { return commands_; }

    /// A global memory barrier; stages and accesses are the caller's.
    void barrier(VkPipelineStageFlags from_stage, VkAccessFlags from_access, VkPipelineStageFlags to_stage,
                 VkAccessFlags to_access) const;

  private:
    Device* device_;
    Handle<VkFence> fence_;
    VkCommandBuffer commands_ = VK_NULL_HANDLE;
};

/// Dispatches recorded in order and run by one submit(). After it the batch is empty and may be filled again, so one
/// Batch serves a whole render. What batches and transfers submitted earlier wrote is visible to the first dispatch.
class Batch {
  public:
    explicit Batch(Device& device, const std::string& name = "batch");

    /// The pipeline and set of the dispatches that follow. Both must live until submit() returns.
    void bind(const ComputePipeline& pipeline, const BindingSet& set);
    /// All push constants of the bound pipeline; `bytes` must be what the pipeline declared.
    void push(const void* data, std::uint32_t bytes);
    template <typename T>
    void push(const T& constants) {
        static_assert(std::is_trivially_copyable_v<T> && !std::is_pointer_v<T>);
        push(&constants, sizeof(T));
    }
    /// Counts of workgroups, each > 0; Error(Failure) beyond max_workgroup_count. Dispatches without a barrier()
    /// between them may overlap.
    void dispatch(std::uint32_t x, std::uint32_t y, std::uint32_t z);
    /// As many workgroups as the first three 32-bit numbers of a Storage buffer say, each at most 65,535, as all before
    /// leaves them: a barrier() is included.
    void dispatchIndirect(const Buffer& counts);
    /// All writes of the dispatches before are seen by all reads and writes of those after.
    void barrier();

    /// Writes the buffer's first bytes, a multiple of 4 of at most 65,536: after all before, before all that follows.
    void write(const Buffer& buffer, const void* data, std::uint64_t bytes);
    /// Copies the first bytes of `from`, as the dispatches before leave them, to `to`: for the host after submit().
    void copy(const Buffer& from, const Buffer& to, std::uint64_t bytes);

    /// Runs what was recorded, waits, and returns the seconds it took on the device (from submit to fence on the host's
    /// clock if the device has no timestamps). Results are then visible to the host and to later batches and transfers.
    double submit();

  private:
    void begin();

    Device* device_;
    Handle<VkQueryPool> queries_;  ///< two timestamps; empty without them
    CommandBuffer commands_;
    const ComputePipeline* bound_ = nullptr;
};

}  // namespace dsphere::gpu
