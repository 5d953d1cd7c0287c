#include "viewer/sampledimage.h"

#include "gpu/result.h"

namespace dsphere::viewer {

using gpu::check;

SampledImage::SampledImage(gpu::Device& device, int width, int height, const char* name)
    : device_(&device), width_(width), height_(height) {
    const VolkDeviceTable& vk = device.vk();
    VkImageCreateInfo create = {VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
    create.imageType = VK_IMAGE_TYPE_2D;
    create.format = VK_FORMAT_R8G8B8A8_UNORM;
    create.extent = {std::uint32_t(width), std::uint32_t(height), 1};
    create.mipLevels = create.arrayLayers = 1;
    create.samples = VK_SAMPLE_COUNT_1_BIT;
    create.tiling = VK_IMAGE_TILING_OPTIMAL;
    create.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    VkImage made = VK_NULL_HANDLE;
    check(vk.vkCreateImage(device.handle(), &create, nullptr, &made), "vkCreateImage");
    image_ = {device.handle(), made, vk.vkDestroyImage};
    device.setName(VK_OBJECT_TYPE_IMAGE, made, name);
    VkMemoryRequirements need;
    vk.vkGetImageMemoryRequirements(device.handle(), made, &need);
    memory_ = device.allocate(need, 0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, name);
    check(vk.vkBindImageMemory(device.handle(), made, memory_.get(), 0), "vkBindImageMemory");
    VkImageViewCreateInfo view = {VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
    view.image = made;
    view.viewType = VK_IMAGE_VIEW_TYPE_2D;
    view.format = create.format;
    view.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    VkImageView made_view = VK_NULL_HANDLE;
    check(vk.vkCreateImageView(device.handle(), &view, nullptr, &made_view), "vkCreateImageView");
    view_ = {device.handle(), made_view, vk.vkDestroyImageView};
}

void SampledImage::transition(VkCommandBuffer commands, VkImageLayout from, VkImageLayout to) const {
    const bool writing = to == VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
    VkImageMemoryBarrier barrier = {VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER};
    barrier.srcAccessMask = writing ? 0 : VK_ACCESS_TRANSFER_WRITE_BIT;
    barrier.dstAccessMask = writing ? VK_ACCESS_TRANSFER_WRITE_BIT : VK_ACCESS_SHADER_READ_BIT;
    barrier.oldLayout = from;
    barrier.newLayout = to;
    barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image_.get();
    barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    const VkPipelineStageFlags sampling = VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT;
    const VkPipelineStageFlags copying = VK_PIPELINE_STAGE_TRANSFER_BIT;
    device_->vk().vkCmdPipelineBarrier(commands, writing ? sampling : copying, writing ? copying : sampling, 0, 0,
                                       nullptr, 0, nullptr, 1, &barrier);
}

void SampledImage::fill(VkCommandBuffer commands, const gpu::Buffer& pixels, int width, int height) {
    // A part may be written: what else the image holds stays, once it holds anything.
    const VkImageLayout old = filled_ ? VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL : VK_IMAGE_LAYOUT_UNDEFINED;
    transition(commands, old, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
    VkBufferImageCopy region = {};
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.imageExtent = {std::uint32_t(width), std::uint32_t(height), 1};
    device_->vk().vkCmdCopyBufferToImage(commands, pixels.handle(), image_.get(), VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                                         1, &region);
    transition(commands, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL);
    filled_ = true;
}

}  // namespace dsphere::viewer
