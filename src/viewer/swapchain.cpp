#include "viewer/swapchain.h"

#include "gpu/result.h"

#include <algorithm>
#include <array>

namespace dsphere::viewer {

using gpu::check;
using gpu::Handle;

Handle<VkSemaphore> makeSemaphore(const gpu::Device& device, const char* name) {
    const VkSemaphoreCreateInfo create = {VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO, nullptr, 0};
    VkSemaphore made = VK_NULL_HANDLE;
    check(device.vk().vkCreateSemaphore(device.handle(), &create, nullptr, &made), "vkCreateSemaphore");
    device.setName(VK_OBJECT_TYPE_SEMAPHORE, made, name);
    return {device.handle(), made, device.vk().vkDestroySemaphore};
}

Swapchain::Swapchain(gpu::Device& device, const ChainCalls& calls)
    : device_(device), calls_(calls), surface_(device.presentation()->surface) {
    chooseFormat();
    makePass();
}

Swapchain::~Swapchain() {
    targets_.clear();
    if (ready()) device_.vk().vkDestroySwapchainKHR(device_.handle(), chain_, nullptr);
}

// Codes go to the screen as they are, so no format that encodes once more, if there is a choice.
void Swapchain::chooseFormat() {
    std::uint32_t count = 0;
    check(vkGetPhysicalDeviceSurfaceFormatsKHR(device_.physical(), surface_, &count, nullptr),
          "vkGetPhysicalDeviceSurfaceFormatsKHR");
    std::vector<VkSurfaceFormatKHR> formats(count);
    check(vkGetPhysicalDeviceSurfaceFormatsKHR(device_.physical(), surface_, &count, formats.data()),
          "vkGetPhysicalDeviceSurfaceFormatsKHR");
    auto plain = std::ranges::find_if(formats, [](const VkSurfaceFormatKHR& one) {
        return (one.format == VK_FORMAT_B8G8R8A8_UNORM || one.format == VK_FORMAT_R8G8B8A8_UNORM) &&
               one.colorSpace == VK_COLOR_SPACE_SRGB_NONLINEAR_KHR;
    });
    format_ = plain == formats.end() ? formats.at(0) : *plain;
}

// Mailbox never makes the renderer wait for the screen; FIFO is there always.
VkPresentModeKHR Swapchain::chooseMode() const {
    std::uint32_t count = 0;
    check(vkGetPhysicalDeviceSurfacePresentModesKHR(device_.physical(), surface_, &count, nullptr),
          "vkGetPhysicalDeviceSurfacePresentModesKHR");
    std::vector<VkPresentModeKHR> modes(count);
    check(vkGetPhysicalDeviceSurfacePresentModesKHR(device_.physical(), surface_, &count, modes.data()),
          "vkGetPhysicalDeviceSurfacePresentModesKHR");
    bool mailbox = std::ranges::find(modes, VK_PRESENT_MODE_MAILBOX_KHR) != modes.end();
    return mailbox ? VK_PRESENT_MODE_MAILBOX_KHR : VK_PRESENT_MODE_FIFO_KHR;
}

void Swapchain::makePass() {
    VkAttachmentDescription colour = {};
    colour.format = format_.format;
    colour.samples = VK_SAMPLE_COUNT_1_BIT;
    colour.loadOp = VK_ATTACHMENT_LOAD_OP_CLEAR;
    colour.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
    colour.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
    colour.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
    colour.initialLayout = VK_IMAGE_LAYOUT_UNDEFINED;
    colour.finalLayout = VK_IMAGE_LAYOUT_PRESENT_SRC_KHR;
    const VkAttachmentReference reference = {0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
    VkSubpassDescription subpass = {};
    subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
    subpass.colorAttachmentCount = 1;
    subpass.pColorAttachments = &reference;
    // The layout changes only once the picture is acquired, which the drawing waits for at this stage.
    VkSubpassDependency before = {};
    before.srcSubpass = VK_SUBPASS_EXTERNAL;
    before.srcStageMask = before.dstStageMask = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT;
    before.dstAccessMask = VK_ACCESS_COLOR_ATTACHMENT_WRITE_BIT;
    VkRenderPassCreateInfo create = {VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO};
    create.attachmentCount = 1;
    create.pAttachments = &colour;
    create.subpassCount = 1;
    create.pSubpasses = &subpass;
    create.dependencyCount = 1;
    create.pDependencies = &before;
    VkRenderPass made = VK_NULL_HANDLE;
    check(device_.vk().vkCreateRenderPass(device_.handle(), &create, nullptr, &made), "vkCreateRenderPass");
    pass_ = {device_.handle(), made, device_.vk().vkDestroyRenderPass};
}

Swapchain::Target Swapchain::makeTarget(VkImage image) const {
    Target target;
    VkImageViewCreateInfo view = {VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
    view.image = image;
    view.viewType = VK_IMAGE_VIEW_TYPE_2D;
    view.format = format_.format;
    view.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
    VkImageView made_view = VK_NULL_HANDLE;
    check(device_.vk().vkCreateImageView(device_.handle(), &view, nullptr, &made_view), "vkCreateImageView");
    target.view = {device_.handle(), made_view, device_.vk().vkDestroyImageView};
    VkFramebufferCreateInfo frame = {VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO};
    frame.renderPass = pass_.get();
    frame.attachmentCount = 1;
    frame.pAttachments = &made_view;
    frame.width = extent_.width;
    frame.height = extent_.height;
    frame.layers = 1;
    VkFramebuffer made = VK_NULL_HANDLE;
    check(device_.vk().vkCreateFramebuffer(device_.handle(), &frame, nullptr, &made), "vkCreateFramebuffer");
    target.framebuffer = {device_.handle(), made, device_.vk().vkDestroyFramebuffer};
    target.drawn = makeSemaphore(device_, "picture is drawn");
    return target;
}

bool Swapchain::resize(int width, int height) {
    VkSurfaceCapabilitiesKHR surface = {};
    check(vkGetPhysicalDeviceSurfaceCapabilitiesKHR(device_.physical(), surface_, &surface),
          "vkGetPhysicalDeviceSurfaceCapabilitiesKHR");
    extent_ = surface.currentExtent;
    if (extent_.width == 0xffffffffu)  // the surface takes the size of its pictures
        extent_ = {std::clamp(std::uint32_t(width), surface.minImageExtent.width, surface.maxImageExtent.width),
                   std::clamp(std::uint32_t(height), surface.minImageExtent.height, surface.maxImageExtent.height)};
    targets_.clear();
    VkSwapchainKHR old = std::exchange(chain_, VK_NULL_HANDLE);
    VkSwapchainCreateInfoKHR create = {VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR};
    create.surface = surface_;
    create.minImageCount = std::max(3u, surface.minImageCount);
    if (surface.maxImageCount > 0) create.minImageCount = std::min(create.minImageCount, surface.maxImageCount);
    create.imageFormat = format_.format;
    create.imageColorSpace = format_.colorSpace;
    create.imageExtent = extent_;
    create.imageArrayLayers = 1;
    create.imageUsage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT;
    create.imageSharingMode = VK_SHARING_MODE_EXCLUSIVE;
    create.preTransform = surface.currentTransform;
    create.compositeAlpha = (surface.supportedCompositeAlpha & VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR)
                                ? VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR
                                : VK_COMPOSITE_ALPHA_INHERIT_BIT_KHR;
    create.presentMode = chooseMode();
    create.clipped = VK_TRUE;
    create.oldSwapchain = old;
    VkResult result = VK_SUCCESS;
    const bool empty = extent_.width == 0 || extent_.height == 0;
    if (!empty) result = device_.vk().vkCreateSwapchainKHR(device_.handle(), &create, nullptr, &chain_);
    if (old != VK_NULL_HANDLE) device_.vk().vkDestroySwapchainKHR(device_.handle(), old, nullptr);
    if (empty) return false;
    check(result, "vkCreateSwapchainKHR");

    std::uint32_t count = 0;
    check(device_.vk().vkGetSwapchainImagesKHR(device_.handle(), chain_, &count, nullptr), "vkGetSwapchainImagesKHR");
    std::vector<VkImage> images(count);
    check(device_.vk().vkGetSwapchainImagesKHR(device_.handle(), chain_, &count, images.data()),
          "vkGetSwapchainImagesKHR");
    for (VkImage image : images) targets_.push_back(makeTarget(image));
    return true;
}

std::optional<std::uint32_t> Swapchain::acquire(VkSemaphore drawable) {
    std::uint32_t index = 0;
    VkResult result = calls_.acquire(device_.handle(), chain_, UINT64_MAX, drawable, VK_NULL_HANDLE, &index);
    if (result == VK_ERROR_OUT_OF_DATE_KHR) return {};
    if (result != VK_SUBOPTIMAL_KHR) check(result, "vkAcquireNextImageKHR");
    return index;
}

bool Swapchain::present(std::uint32_t index) {
    const VkSemaphore wait = drawn(index);
    VkPresentInfoKHR info = {VK_STRUCTURE_TYPE_PRESENT_INFO_KHR};
    info.waitSemaphoreCount = 1;
    info.pWaitSemaphores = &wait;
    info.swapchainCount = 1;
    info.pSwapchains = &chain_;
    info.pImageIndices = &index;
    VkResult result = calls_.present(device_.presentation()->queue, &info);
    if (result == VK_ERROR_OUT_OF_DATE_KHR || result == VK_SUBOPTIMAL_KHR) return false;
    check(result, "vkQueuePresentKHR");
    return true;
}

}  // namespace dsphere::viewer
