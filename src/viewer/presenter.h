#pragma once

#include "viewer/overlay.h"
#include "viewer/swapchain.h"

#include <memory>

namespace dsphere::viewer {

/// Shows a picture and Dear ImGui's panels over it in the window. The picture comes from a buffer of the device that
/// renders: directly if that device also presents from the same queue family, else through the host.
class Presenter {
  public:
    /// `presents` shows, `calls` being its own; `renders` may be the same.
    Presenter(gpu::Device& presents, gpu::Device& renders) : Presenter(presents, renders, ChainCalls::of(presents)) {}
    Presenter(gpu::Device& presents, gpu::Device& renders, const ChainCalls& calls);
    ~Presenter();
    Presenter(const Presenter&) = delete;
    Presenter& operator=(const Presenter&) = delete;

    void setFont(const unsigned char* rgba, int width, int height) { overlay_.setFont(rgba, width, height); }
    /// The picture from now on: width x height pixels of four bytes at the start of `pixels`, which stays as it is
    /// until the next finish().
    void setPicture(const gpu::Buffer& pixels, int width, int height);
    /// The window has so many pixels now.
    void resize(int width, int height);

    /// Draws and hands it to the window; false if nothing could be shown this time: draw again.
    bool draw(const ImDrawData& data);
    /// Waits until the last picture is drawn: its buffers may change.
    void finish();

    bool direct() const { return direct_; }
    /// The part of the picture's texture that is in use.
    float u() const { return picture_ ? float(picture_width_) / float(picture_->width()) : 1.0f; }
    float v() const { return picture_ ? float(picture_height_) / float(picture_->height()) : 1.0f; }
    bool hasPicture() const { return picture_.has_value(); }

  private:
    void makeCommands();
    void begin();
    void submit(std::uint32_t index);

    gpu::Device& device_;
    bool direct_;
    Swapchain chain_;
    Overlay overlay_;
    gpu::Handle<VkSemaphore> drawable_;
    gpu::Handle<VkFence> fence_;
    gpu::Handle<VkCommandPool> pool_;
    VkCommandBuffer commands_ = VK_NULL_HANDLE;
    std::optional<SampledImage> picture_;
    std::optional<gpu::Buffer> copy_;     ///< on its way through the host
    const gpu::Buffer* fresh_ = nullptr;  ///< not yet in picture_
    int picture_width_ = 0, picture_height_ = 0, width_ = 0, height_ = 0;
    bool running_ = false, stale_ = true;
};

}  // namespace dsphere::viewer
