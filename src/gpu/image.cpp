#include "gpu/image.h"

#include <algorithm>
#include <bit>
#include <cassert>
#include <cstring>

#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "gpu/device.h"
#include "gpu/result.h"

namespace dsphere::gpu {
namespace {

VkFormat vulkanFormat(Format format) {
    switch (format) {
        case Format::R32Float:
            return VK_FORMAT_R32_SFLOAT;
        case Format::R32Uint:
            return VK_FORMAT_R32_UINT;
        case Format::Rgba32Float:
            break;
    }
    return VK_FORMAT_R32G32B32A32_SFLOAT;
}

void checkSize(const Device& device, const VkImageCreateInfo& create, std::uint64_t bytes, const std::string& name) {
    const Limits& limits = device.limits();
    checkLimit(create.extent.width, limits.max_image_dimension_2d, "maxImageDimension2D (width)", name);
    checkLimit(create.extent.height, limits.max_image_dimension_2d, "maxImageDimension2D (height)", name);
    checkLimit(create.arrayLayers, limits.max_image_array_layers, "maxImageArrayLayers", name);
    checkLimit(bytes, limits.max_allocation_size, "maxMemoryAllocationSize", name);
    VkImageFormatProperties format = {};
    check(vkGetPhysicalDeviceImageFormatProperties(device.physical(), create.format, create.imageType, create.tiling,
                                                   create.usage, create.flags, &format),
          "vkGetPhysicalDeviceImageFormatProperties");
    checkLimit(create.extent.width, format.maxExtent.width, "the format's maxExtent.width", name);
    checkLimit(create.extent.height, format.maxExtent.height, "the format's maxExtent.height", name);
    checkLimit(create.arrayLayers, format.maxArrayLayers, "the format's maxArrayLayers", name);
    checkLimit(bytes, format.maxResourceSize, "the format's maxResourceSize", name);
}

// lavapipe compiles a shader once for images with sides that are powers of two and once more for others (rule L5). No
// side is one but the greatest there can be, and what was compiled for some images serves all.
std::uint32_t unevenSide(std::uint32_t side, const Limits& limits) {
    while (std::has_single_bit(side) && side < limits.max_image_dimension_2d) ++side;
    return side;
}

VkImageCreateInfo imageInfo(Format format, std::uint32_t width, std::uint32_t height, std::uint32_t layers) {
    VkImageCreateInfo create = {VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
    create.imageType = VK_IMAGE_TYPE_2D;
    create.format = vulkanFormat(format);
    create.extent = {width, height, 1};
    create.mipLevels = 1;
    create.arrayLayers = layers;
    create.samples = VK_SAMPLE_COUNT_1_BIT;
    create.tiling = VK_IMAGE_TILING_OPTIMAL;
    create.usage = VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
    create.sharingMode = VK_SHARING_MODE_EXCLUSIVE;
    create.initialLayout = VK_IMAGE_LAYOUT_UNDEFINED;
    return create;
}

VkImageSubresourceRange wholeImage(std::uint32_t layers) {
    return {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, layers};
}

/// Nothing has used the image yet, so nothing is waited for; transfers and shaders come after.
void toGeneralLayout(Device& device, VkImage image, std::uint32_t layers) {
    CommandBuffer commands(device, "image layout");
    commands.begin();
    VkImageMemoryBarrier barrier = {VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER};
    barrier.srcAccessMask = 0;
    barrier.dstAccessMask = VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_READ_BIT |
                            VK_ACCESS_TRANSFER_WRITE_BIT;
    barrier.oldLayout = VK_IMAGE_LAYOUT_UNDEFINED;
    barrier.newLayout = VK_IMAGE_LAYOUT_GENERAL;
    barrier.srcQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
    barrier.image = image;
    barrier.subresourceRange = wholeImage(layers);
    device.vk().vkCmdPipelineBarrier(commands.handle(), VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT,
                                     VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_TRANSFER_BIT, 0, 0,
                                     nullptr, 0, nullptr, 1, &barrier);
    commands.submit();
}

VkBufferImageCopy copyRegion(std::uint32_t layer, std::uint32_t x, std::uint32_t y, std::uint32_t width,
                             std::uint32_t height) {
    VkBufferImageCopy region = {};
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, layer, 1};
    region.imageOffset = {std::int32_t(x), std::int32_t(y), 0};
    region.imageExtent = {width, height, 1};
    return region;
}

/// Whole rows that fit the staging buffer; one row always does (32,768 texels of 16 bytes are 512 KiB).
std::uint32_t rowsPerChunk(std::uint64_t row_bytes, std::uint32_t rows) {
    assert(row_bytes <= kStagingBytes);
    return std::uint32_t(std::min<std::uint64_t>(rows, kStagingBytes / row_bytes));
}

}  // namespace

std::uint32_t texelBytes(Format format) {
    return format == Format::Rgba32Float ? 16 : 4;
}

StorageImage::StorageImage(Device& device, Format format, std::uint32_t width, std::uint32_t height,
                           std::uint32_t layers, const std::string& name)
    : device_(&device), format_(format), width_(width), height_(height), layers_(layers) {
    assert(width > 0 && height > 0 && layers > 0);
    const VolkDeviceTable& vk = device.vk();
    const Limits& limits = device.limits();
    const VkImageCreateInfo create = imageInfo(format, unevenSide(width, limits), unevenSide(height, limits), layers);
    // Each side is under 2^32, but the product need not fit 64 bits before the sides are checked: hence in double
    // first.
    const double bytes =
        double(create.extent.width) * double(create.extent.height) * double(layers) * texelBytes(format);
    checkSize(device, create, bytes < 1e18 ? std::uint64_t(bytes) : UINT64_MAX, name);
    VkImage image = VK_NULL_HANDLE;
    check(vk.vkCreateImage(device.handle(), &create, nullptr, &image), "vkCreateImage");
    image_ = Handle<VkImage>(device.handle(), image, vk.vkDestroyImage);
    device.setName(VK_OBJECT_TYPE_IMAGE, image, name);

    VkMemoryRequirements need;
    vk.vkGetImageMemoryRequirements(device.handle(), image, &need);
    memory_ = device.allocate(need, 0, VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT, name);
    check(vk.vkBindImageMemory(device.handle(), image, memory_.get(), 0), "vkBindImageMemory");

    VkImageViewCreateInfo view_info = {VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
    view_info.image = image;
    view_info.viewType = VK_IMAGE_VIEW_TYPE_2D_ARRAY;
    view_info.format = create.format;
    view_info.subresourceRange = wholeImage(layers);
    VkImageView view = VK_NULL_HANDLE;
    check(vk.vkCreateImageView(device.handle(), &view_info, nullptr, &view), "vkCreateImageView");
    view_ = Handle<VkImageView>(device.handle(), view, vk.vkDestroyImageView);
    device.setName(VK_OBJECT_TYPE_IMAGE_VIEW, view, name + " view");
    toGeneralLayout(device, image, layers);
}

void StorageImage::upload(std::uint32_t layer, std::uint32_t x, std::uint32_t y, std::uint32_t width,
                          std::uint32_t height, const void* pixels) {
    const std::uint64_t row_bytes = std::uint64_t(width) * texelBytes(format_);
    uploadRows(layer, x, y, width, height, [&](std::uint32_t first, std::uint32_t count, std::byte* target) {
        std::memcpy(target, static_cast<const std::byte*>(pixels) + first * row_bytes, count * row_bytes);
    });
}

void StorageImage::uploadRows(std::uint32_t layer, std::uint32_t x, std::uint32_t y, std::uint32_t width,
                              std::uint32_t height, const FillRows& fill) {
    assert(layer < layers_ && x <= width_ && width <= width_ - x && y <= height_ && height <= height_ - y);
    if (width == 0 || height == 0) return;
    const std::uint64_t row_bytes = std::uint64_t(width) * texelBytes(format_);
    const std::uint32_t chunk = rowsPerChunk(row_bytes, height);
    const Buffer staging(*device_, Buffer::Usage::Staging, Buffer::Place::Host, chunk * row_bytes, "upload staging");
    CommandBuffer commands(*device_, "image upload");
    for (std::uint32_t row = 0; row < height; row += chunk) {
        const std::uint32_t rows = std::min(chunk, height - row);
        fill(row, rows, staging.mapped().data());
        staging.flush();
        commands.begin();
        // Earlier writes of the same texels come first; earlier reads need the order alone.
        commands.barrier(VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_TRANSFER_BIT,
                         VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_WRITE_BIT, VK_PIPELINE_STAGE_TRANSFER_BIT,
                         VK_ACCESS_TRANSFER_WRITE_BIT);
        const VkBufferImageCopy region = copyRegion(layer, x, y + row, width, rows);
        device_->vk().vkCmdCopyBufferToImage(commands.handle(), staging.handle(), handle(), VK_IMAGE_LAYOUT_GENERAL, 1,
                                             &region);
        commands.submit();
    }
}

void StorageImage::download(std::uint32_t layer, std::uint32_t x, std::uint32_t y, std::uint32_t width,
                            std::uint32_t height, void* pixels) const {
    assert(layer < layers_ && x <= width_ && width <= width_ - x && y <= height_ && height <= height_ - y);
    if (width == 0 || height == 0) return;
    const std::uint64_t row_bytes = std::uint64_t(width) * texelBytes(format_);
    const std::uint32_t chunk = rowsPerChunk(row_bytes, height);
    const Buffer staging(*device_, Buffer::Usage::Staging, Buffer::Place::Host, chunk * row_bytes, "download staging");
    CommandBuffer commands(*device_, "image download");
    for (std::uint32_t row = 0; row < height; row += chunk) {
        const std::uint32_t rows = std::min(chunk, height - row);
        commands.begin();
        commands.barrier(VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_TRANSFER_BIT,
                         VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_WRITE_BIT, VK_PIPELINE_STAGE_TRANSFER_BIT,
                         VK_ACCESS_TRANSFER_READ_BIT | VK_ACCESS_TRANSFER_WRITE_BIT);
        const VkBufferImageCopy region = copyRegion(layer, x, y + row, width, rows);
        device_->vk().vkCmdCopyImageToBuffer(commands.handle(), handle(), VK_IMAGE_LAYOUT_GENERAL, staging.handle(), 1,
                                             &region);
        commands.barrier(VK_PIPELINE_STAGE_TRANSFER_BIT, VK_ACCESS_TRANSFER_WRITE_BIT, VK_PIPELINE_STAGE_HOST_BIT,
                         VK_ACCESS_HOST_READ_BIT);
        commands.submit();
        staging.invalidate();
        std::memcpy(static_cast<std::byte*>(pixels) + row * row_bytes, staging.mapped().data(), rows * row_bytes);
    }
}

void StorageImage::clear() {
    CommandBuffer commands(*device_, "image clear");
    commands.begin();
    commands.barrier(VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_TRANSFER_BIT,
                     VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_WRITE_BIT, VK_PIPELINE_STAGE_TRANSFER_BIT,
                     VK_ACCESS_TRANSFER_WRITE_BIT);
    const VkClearColorValue zero = {};
    const VkImageSubresourceRange all = wholeImage(layers_);
    device_->vk().vkCmdClearColorImage(commands.handle(), handle(), VK_IMAGE_LAYOUT_GENERAL, &zero, 1, &all);
    commands.submit();
}

}  // namespace dsphere::gpu
