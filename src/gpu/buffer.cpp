#include "gpu/buffer.h"

#include <algorithm>
#include <cassert>
#include <cstring>

#include "gpu/commands.h"
#include "gpu/device.h"
#include "gpu/result.h"

namespace dsphere::gpu {
namespace {

VkBufferUsageFlags usageFlags(Buffer::Usage usage) {
    const VkBufferUsageFlags copies = VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT;
    switch (usage) {
        case Buffer::Usage::Storage:
            return copies | VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT;
        case Buffer::Usage::Uniform:
            return copies | VK_BUFFER_USAGE_UNIFORM_BUFFER_BIT;
        case Buffer::Usage::Vertices:
            return copies | VK_BUFFER_USAGE_VERTEX_BUFFER_BIT | VK_BUFFER_USAGE_INDEX_BUFFER_BIT;
        case Buffer::Usage::Staging:
            break;
    }
    return copies;
}

void checkSize(const Device& device, Buffer::Usage usage, std::uint64_t bytes, const std::string& name) {
    const Limits& limits = device.limits();
    if (usage == Buffer::Usage::Storage) {
        checkLimit(bytes, limits.max_storage_buffer_range, "maxStorageBufferRange", name);
    }
    if (usage == Buffer::Usage::Uniform) {
        checkLimit(bytes, limits.max_uniform_buffer_range, "maxUniformBufferRange", name);
    }
    checkLimit(bytes, limits.max_allocation_size, "maxMemoryAllocationSize", name);
}

}  // namespace

Buffer::Buffer(Device& device, Usage usage, Place place, std::uint64_t bytes, const std::string& name)
    : device_(&device), size_(bytes), usage_(usage) {
    assert(bytes > 0);
    checkSize(device, usage, bytes, name);
    const VolkDeviceTable& vk = device.vk();
    VkBufferCreateInfo create = {VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
    create.size = bytes;
    create.usage = usageFlags(usage);
    create.sharingMode = VK_SHARING_MODE_EXCLUSIVE;
    VkBuffer made = VK_NULL_HANDLE;
    check(vk.vkCreateBuffer(device.handle(), &create, nullptr, &made), "vkCreateBuffer");
    buffer_ = Handle<VkBuffer>(device.handle(), made, vk.vkDestroyBuffer);
    device.setName(VK_OBJECT_TYPE_BUFFER, made, name);

    VkMemoryRequirements need;
    vk.vkGetBufferMemoryRequirements(device.handle(), made, &need);
    const bool host = place == Place::Host;
    VkMemoryPropertyFlags flags = 0;
    // Uncached memory is fine to write but some hundred times slower to read, so cached is preferred for all.
    memory_ = device.allocate(need, host ? VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT : 0,
                              host ? VK_MEMORY_PROPERTY_HOST_CACHED_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT
                                   : VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT,
                              name, &flags);
    check(vk.vkBindBufferMemory(device.handle(), made, memory_.get(), 0), "vkBindBufferMemory");
    if (host) {
        void* mapped = nullptr;
        check(vk.vkMapMemory(device.handle(), memory_.get(), 0, VK_WHOLE_SIZE, 0, &mapped), "vkMapMemory");
        mapped_ = static_cast<std::byte*>(mapped);
        coherent_ = flags & VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
    }
}

std::span<std::byte> Buffer::mapped() const {
    assert(mapped_);
    return {mapped_, std::size_t(size_)};
}

void Buffer::flush() const {
    if (coherent_) return;
    const VkMappedMemoryRange all = {VK_STRUCTURE_TYPE_MAPPED_MEMORY_RANGE, nullptr, memory_.get(), 0, VK_WHOLE_SIZE};
    check(device_->vk().vkFlushMappedMemoryRanges(device_->handle(), 1, &all), "vkFlushMappedMemoryRanges");
}

void Buffer::invalidate() const {
    if (coherent_) return;
    const VkMappedMemoryRange all = {VK_STRUCTURE_TYPE_MAPPED_MEMORY_RANGE, nullptr, memory_.get(), 0, VK_WHOLE_SIZE};
    check(device_->vk().vkInvalidateMappedMemoryRanges(device_->handle(), 1, &all), "vkInvalidateMappedMemoryRanges");
}

void Buffer::upload(std::uint64_t offset, std::uint64_t bytes, const void* source) {
    assert(offset <= size_ && bytes <= size_ - offset);
    if (bytes == 0) return;
    if (mapped_) {
        std::memcpy(mapped_ + offset, source, std::size_t(bytes));
        flush();
        return;
    }
    const Buffer staging(*device_, Usage::Staging, Place::Host, std::min(bytes, kStagingBytes), "upload staging");
    CommandBuffer commands(*device_, "buffer upload");
    for (std::uint64_t done = 0; done < bytes; done += staging.size()) {
        const std::uint64_t part = std::min(staging.size(), bytes - done);
        std::memcpy(staging.mapped_, static_cast<const std::byte*>(source) + done, std::size_t(part));
        staging.flush();
        commands.begin();
        // Earlier writes of the same bytes come first; earlier reads need the order alone.
        commands.barrier(VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_TRANSFER_BIT,
                         VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_WRITE_BIT, VK_PIPELINE_STAGE_TRANSFER_BIT,
                         VK_ACCESS_TRANSFER_WRITE_BIT);
        const VkBufferCopy region = {0, offset + done, part};
        device_->vk().vkCmdCopyBuffer(commands.handle(), staging.handle(), handle(), 1, &region);
        commands.submit();
    }
}

void Buffer::download(std::uint64_t offset, std::uint64_t bytes, void* target) const {
    assert(offset <= size_ && bytes <= size_ - offset);
    if (bytes == 0) return;
    if (mapped_) {
        invalidate();
        std::memcpy(target, mapped_ + offset, std::size_t(bytes));
        return;
    }
    const Buffer staging(*device_, Usage::Staging, Place::Host, std::min(bytes, kStagingBytes), "download staging");
    CommandBuffer commands(*device_, "buffer download");
    for (std::uint64_t done = 0; done < bytes; done += staging.size()) {
        const std::uint64_t part = std::min(staging.size(), bytes - done);
        commands.begin();
        commands.barrier(VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_TRANSFER_BIT,
                         VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_WRITE_BIT, VK_PIPELINE_STAGE_TRANSFER_BIT,
                         VK_ACCESS_TRANSFER_READ_BIT | VK_ACCESS_TRANSFER_WRITE_BIT);
        const VkBufferCopy region = {offset + done, 0, part};
        device_->vk().vkCmdCopyBuffer(commands.handle(), handle(), staging.handle(), 1, &region);
        commands.barrier(VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT, VK_PIPELINE_STAGE_HOST_BIT,
                         VK_ACCESS_HOST_READ_BIT);
        commands.submit();
        staging.invalidate();
        std::memcpy(static_cast<std::byte*>(target) + done, staging.mapped_, std::size_t(part));
    }
}

}  // namespace dsphere::gpu
