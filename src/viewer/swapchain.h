#pragma once

#include "gpu/device.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace dsphere::viewer {

/// The two calls whose results tell that the window has changed, or the device is gone.
struct ChainCalls {
    PFN_vkAcquireNextImageKHR acquire;
    PFN_vkQueuePresentKHR present;

    static ChainCalls of(const gpu::Device& device) {
        return {device.vk().vkAcquireNextImageKHR, device.vk().vkQueuePresentKHR};
    }
};

/// The window's pictures in turn, and the pass that draws into them. Made anew whenever the window changes.
class Swapchain {
  public:
    /// The device presents; `calls` are its own, or stand in for them.
    Swapchain(gpu::Device& device, const ChainCalls& calls);
    ~Swapchain();
    Swapchain(const Swapchain&) = delete;
    Swapchain& operator=(const Swapchain&) = delete;

    /// For a window of so many pixels; nothing of the old one may be in use. False while the window has none.
    bool resize(int width, int height);
    bool ready() const { return chain_ != VK_NULL_HANDLE; }
    VkExtent2D extent() const { return extent_; }
    VkRenderPass pass() const { return pass_.get(); }
    VkFramebuffer framebuffer(std::uint32_t index) const { return targets_[index].framebuffer.get(); }

    /// The next picture to draw, for which `drawable` is signalled; unset if the chain is out of date.
    std::optional<std::uint32_t> acquire(VkSemaphore drawable);
    /// Signalled when the drawing of a picture is done: what present() waits for.
    VkSemaphore drawn(std::uint32_t index) const { return targets_[index].drawn.get(); }
    /// False if the chain is out of date or no longer the best.
    bool present(std::uint32_t index);

  private:
    struct Target {
        gpu::Handle<VkImageView> view;
        gpu::Handle<VkFramebuffer> framebuffer;
        gpu::Handle<VkSemaphore> drawn;
    };

    void chooseFormat();
    VkPresentModeKHR chooseMode() const;
    void makePass();
    Target makeTarget(VkImage image) const;

    gpu::Device& device_;
    ChainCalls calls_;
    VkSurfaceKHR surface_;
    VkSurfaceFormatKHR format_ = {};
    gpu::Handle<VkRenderPass> pass_;
    VkSwapchainKHR chain_ = VK_NULL_HANDLE;
    VkExtent2D extent_ = {};
    std::vector<Target> targets_;
};

/// An unsignalled semaphore of the device.
gpu::Handle<VkSemaphore> makeSemaphore(const gpu::Device& device, const char* name);

}  // namespace dsphere::viewer
