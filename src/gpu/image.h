#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "gpu/handle.h"

namespace dsphere::gpu {

class Device;

enum class Format {
    R32Float,     ///< GLSL r32f, 4 bytes a texel
    R32Uint,      ///< GLSL r32ui, 4 bytes
    Rgba32Float,  ///< GLSL rgba32f, 16 bytes
};

/// Bytes of one texel.
std::uint32_t texelBytes(Format format);

/// A 2D array storage image in device-local memory, always in VK_IMAGE_LAYOUT_GENERAL, bound as one image2DArray of all
/// its layers; of sides a texel longer where they would be powers of two. Transfers wait until they are done, in chunks
/// of at most kStagingBytes.
class StorageImage {
  public:
    /// Sizes > 0. Contents are undefined. Error(Failure) beyond max_image_dimension_2d, max_image_array_layers or the
    /// memory limits. `name` appears in messages.
    StorageImage(Device& device, Format format, std::uint32_t width, std::uint32_t height, std::uint32_t layers,
                 const std::string& name);

    std::uint32_t width() const { return width_; }
    std::uint32_t height() const { return height_; }
    std::uint32_t layers() const { return layers_; }
    Format format() const { return format_; }
    VkImage handle() const { return image_.get(); }
    VkImageView view() const { return view_.get(); }

    /// Writes the rectangle at (x, y) of one layer, which must lie inside; `pixels` holds width * height texels row by
    /// row without gaps.
    void upload(std::uint32_t layer, std::uint32_t x, std::uint32_t y, std::uint32_t width, std::uint32_t height,
                const void* pixels);
    /// upload() without a copy of the whole: `fill` writes rows `first` to `first + count` of the rectangle to
    /// `target`, without gaps, and is called from the top down.
    using FillRows = std::function<void(std::uint32_t first, std::uint32_t count, std::byte* target)>;
    void uploadRows(std::uint32_t layer, std::uint32_t x, std::uint32_t y, std::uint32_t width, std::uint32_t height,
                    const FillRows& fill);
    /// Reads such a rectangle; sees all writes of batches submitted before.
    void download(std::uint32_t layer, std::uint32_t x, std::uint32_t y, std::uint32_t width, std::uint32_t height,
                  void* pixels) const;
    /// Sets every texel of every layer to zero.
    void clear();

  private:
    Device* device_;
    Format format_;
    std::uint32_t width_, height_, layers_;
    Handle<VkDeviceMemory> memory_;  ///< before image_: freed after it
    Handle<VkImage> image_;
    Handle<VkImageView> view_;
};

}  // namespace dsphere::gpu
