#include "viewer/presenter.h"

#include <imgui.h>

#include "gpu/result.h"

namespace dsphere::viewer {

using gpu::check;

Presenter::Presenter(gpu::Device& presents, gpu::Device& renders, const ChainCalls& calls)
    : device_(presents),
      direct_(&presents == &renders && presents.presentation()->family == presents.queueFamily()),
      chain_(presents, calls),
      overlay_(presents, chain_.pass()),
      drawable_(makeSemaphore(presents, "picture is drawable")) {
    makeCommands();
}

Presenter::~Presenter() {
    // Presentation itself has no fence.
    device_.vk().vkDeviceWaitIdle(device_.handle());
}

void Presenter::makeCommands() {
    const VolkDeviceTable& vk = device_.vk();
    const VkFenceCreateInfo fence = {VK_STRUCTURE_TYPE_FENCE_CREATE_INFO, nullptr, 0};
    VkFence made_fence = VK_NULL_HANDLE;
    check(vk.vkCreateFence(device_.handle(), &fence, nullptr, &made_fence), "vkCreateFence");
    fence_ = {device_.handle(), made_fence, vk.vkDestroyFence};
    VkCommandPoolCreateInfo pool = {VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO};
    pool.flags = VK_COMMAND_POOL_CREATE_RESET_COMMAND_BUFFER_BIT;
    pool.queueFamilyIndex = device_.presentation()->family;
    VkCommandPool made_pool = VK_NULL_HANDLE;
    check(vk.vkCreateCommandPool(device_.handle(), &pool, nullptr, &made_pool), "vkCreateCommandPool");
    pool_ = {device_.handle(), made_pool, vk.vkDestroyCommandPool};
    VkCommandBufferAllocateInfo allocate = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
    allocate.commandPool = made_pool;
    allocate.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    allocate.commandBufferCount = 1;
    check(vk.vkAllocateCommandBuffers(device_.handle(), &allocate, &commands_), "vkAllocateCommandBuffers");
}

void Presenter::resize(int width, int height) {
    width_ = width;
    height_ = height;
    stale_ = true;
}

void Presenter::setPicture(const gpu::Buffer& pixels, int width, int height) {
    finish();
    if (!picture_ || picture_->width() < width || picture_->height() < height)
        picture_.emplace(device_, std::max(width, width_), std::max(height, height_), "picture");
    picture_width_ = width;
    picture_height_ = height;
    fresh_ = &pixels;
    overlay_.setPicture(*picture_, width, height);
    if (direct_) return;
    const std::uint64_t bytes = 4 * std::uint64_t(width) * std::uint64_t(height);
    if (!copy_ || copy_->size() < bytes)
        copy_.emplace(device_, gpu::Buffer::Usage::Staging, gpu::Buffer::Place::Host, bytes, "picture on its way");
    pixels.download(0, bytes, copy_->mapped().data());
    copy_->flush();
    fresh_ = &*copy_;
}

void Presenter::finish() {
    if (!running_) return;
    const VkFence fence = fence_.get();
    check(device_.vk().vkWaitForFences(device_.handle(), 1, &fence, VK_TRUE, UINT64_MAX), "vkWaitForFences");
    check(device_.vk().vkResetFences(device_.handle(), 1, &fence), "vkResetFences");
    running_ = false;
}

void Presenter::begin() {
    VkCommandBufferBeginInfo info = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    check(device_.vk().vkBeginCommandBuffer(commands_, &info), "vkBeginCommandBuffer");
    if (!fresh_) return;
    // What the shader, or a copy, left in the buffer is seen by this copy.
    const VkMemoryBarrier memory = {VK_STRUCTURE_TYPE_MEMORY_BARRIER, nullptr,
                                    VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_WRITE_BIT,
                                    VK_ACCESS_TRANSFER_READ_BIT};
    device_.vk().vkCmdPipelineBarrier(
        commands_,
        VK_PIPELINE_STAGE_TRANSFER_BIT |
            (direct_ ? VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT : VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT),
        VK_PIPELINE_STAGE_TRANSFER_BIT, 0, 1, &memory, 0, nullptr, 0, nullptr);
    picture_->fill(commands_, *fresh_, picture_width_, picture_height_);
    fresh_ = nullptr;
}

void Presenter::submit(std::uint32_t index) {
    check(device_.vk().vkEndCommandBuffer(commands_), "vkEndCommandBuffer");
    const VkSemaphore wait = drawable_.get(), signal = chain_.drawn(index);
    const VkPipelineStageFlags stage = VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT;
    VkSubmitInfo info = {VK_STRUCTURE_TYPE_SUBMIT_INFO};
    info.waitSemaphoreCount = 1;
    info.pWaitSemaphores = &wait;
    info.pWaitDstStageMask = &stage;
    info.commandBufferCount = 1;
    info.pCommandBuffers = &commands_;
    info.signalSemaphoreCount = 1;
    info.pSignalSemaphores = &signal;
    check(device_.vk().vkQueueSubmit(device_.presentation()->queue, 1, &info, fence_.get()), "vkQueueSubmit");
    running_ = true;
}

bool Presenter::draw(const ImDrawData& data) {
    finish();
    if (stale_) {
        check(device_.vk().vkDeviceWaitIdle(device_.handle()), "vkDeviceWaitIdle");
        if (!chain_.resize(width_, height_)) return false;
        stale_ = false;
    }
    std::optional<std::uint32_t> index = chain_.acquire(drawable_.get());
    if (!index) {
        stale_ = true;
        return false;
    }
    begin();
    overlay_.upload(commands_, data);
    const VkClearValue dark = {{{0.0f, 0.0f, 0.0f, 1.0f}}};
    VkRenderPassBeginInfo pass = {VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO};
    pass.renderPass = chain_.pass();
    pass.framebuffer = chain_.framebuffer(*index);
    pass.renderArea = {{0, 0}, chain_.extent()};
    pass.clearValueCount = 1;
    pass.pClearValues = &dark;
    device_.vk().vkCmdBeginRenderPass(commands_, &pass, VK_SUBPASS_CONTENTS_INLINE);
    overlay_.record(commands_, data, chain_.extent());
    device_.vk().vkCmdEndRenderPass(commands_);
    submit(*index);
    if (!chain_.present(*index)) stale_ = true;
    return !stale_;
}

}  // namespace dsphere::viewer
