#pragma once

#include "gpu/buffer.h"
#include "gpu/device.h"

namespace dsphere::viewer {

/// An RGBA image of 8 bits that fragment shaders sample linearly. Filled from a buffer by commands of the caller's.
class SampledImage {
  public:
    SampledImage(gpu::Device& device, int width, int height, const char* name);

    int width() const { return width_; }
    int height() const { return height_; }
    VkImageView view() const { return view_.get(); }

    /// Records the copy of width x height pixels, four bytes each without gaps, to the image's corner.
    void fill(VkCommandBuffer commands, const gpu::Buffer& pixels, int width, int height);

  private:
    void transition(VkCommandBuffer commands, VkImageLayout from, VkImageLayout to) const;

    gpu::Device* device_;
    int width_, height_;
    bool filled_ = false;
    gpu::Handle<VkDeviceMemory> memory_;  ///< before image_: freed after it
    gpu::Handle<VkImage> image_;
    gpu::Handle<VkImageView> view_;
};

}  // namespace dsphere::viewer
