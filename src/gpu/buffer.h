#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "gpu/handle.h"

namespace dsphere::gpu {

class Device;

/// Copies larger than this go in several rounds through a staging buffer of this many bytes.
inline constexpr std::uint64_t kStagingBytes = 16u << 20;

/// A buffer with memory of its own. Transfers wait until they are done; nothing of the device may be running meanwhile
/// (Batch::submit() waits, so nothing is).
class Buffer {
  public:
    enum class Usage {
        Storage,   ///< bound as Binding::StorageBuffer
        Uniform,   ///< bound as Binding::UniformBuffer
        Staging,   ///< only copied from and to
        Vertices,  ///< vertices and indices
    };
    enum class Place {
        Host,    ///< mapped for its whole life; cached where the device offers it
        Device,  ///< device-local; upload() and download() go through a staging buffer
    };

    /// `bytes` > 0. Contents are undefined. Error(Failure) beyond max_storage_buffer_range, max_uniform_buffer_range or
    /// the memory limits. `name` appears in messages.
    Buffer(Device& device, Usage usage, Place place, std::uint64_t bytes, const std::string& name);

    std::uint64_t size() const { return size_; }
    Usage usage() const { return usage_; }
    VkBuffer handle() const { return buffer_.get(); }

    /// Copies host bytes to [offset, offset + bytes), which must lie inside.
    void upload(std::uint64_t offset, std::uint64_t bytes, const void* source);
    /// Copies [offset, offset + bytes) to the host; sees all writes of batches submitted before.
    void download(std::uint64_t offset, std::uint64_t bytes, void* target) const;

    /// The mapped bytes of a Place::Host buffer. Call flush() after writing and invalidate() before reading; both cost
    /// nothing on coherent memory.
    std::span<std::byte> mapped() const;
    void flush() const;
    void invalidate() const;

  private:
    Device* device_;
    std::uint64_t size_;
    Usage usage_;
    bool coherent_ = true;
    std::byte* mapped_ = nullptr;
    Handle<VkDeviceMemory> memory_;  ///< before buffer_: freed after it
    Handle<VkBuffer> buffer_;
};

}  // namespace dsphere::gpu
