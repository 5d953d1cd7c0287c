#include "gpu/commands.h"

#include <cassert>
#include <chrono>

#include "gpu/buffer.h"
#include "gpu/device.h"
#include "gpu/pipeline.h"
#include "gpu/result.h"

namespace dsphere::gpu {

CommandBuffer::CommandBuffer(Device& device, const std::string& name) : device_(&device) {
    const VkFenceCreateInfo create = {VK_STRUCTURE_TYPE_FENCE_CREATE_INFO, nullptr, 0};
    VkFence fence = VK_NULL_HANDLE;
    check(device.vk().vkCreateFence(device.handle(), &create, nullptr, &fence), "vkCreateFence");
    fence_ = Handle<VkFence>(device.handle(), fence, device.vk().vkDestroyFence);
    device.setName(VK_OBJECT_TYPE_FENCE, fence, name + " fence");

    VkCommandBufferAllocateInfo allocate = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO};
    allocate.commandPool = device.commandPool();
    allocate.level = VK_COMMAND_BUFFER_LEVEL_PRIMARY;
    allocate.commandBufferCount = 1;
    check(device.vk().vkAllocateCommandBuffers(device.handle(), &allocate, &commands_), "vkAllocateCommandBuffers");
    device.setName(VK_OBJECT_TYPE_COMMAND_BUFFER, commands_, name);
}

CommandBuffer::~CommandBuffer() {
    device_->vk().vkFreeCommandBuffers(device_->handle(), device_->commandPool(), 1, &commands_);
}

void CommandBuffer::begin() {
    VkCommandBufferBeginInfo info = {VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO};
    info.flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT;
    check(device_->vk().vkBeginCommandBuffer(commands_, &info), "vkBeginCommandBuffer");
}

double CommandBuffer::submit() {
    const VolkDeviceTable& vk = device_->vk();
    check(vk.vkEndCommandBuffer(commands_), "vkEndCommandBuffer");
    VkSubmitInfo info = {VK_STRUCTURE_TYPE_SUBMIT_INFO};
    info.commandBufferCount = 1;
    info.pCommandBuffers = &commands_;
    const VkFence fence = fence_.get();
    const auto start = std::chrono::steady_clock::now();
    check(vk.vkQueueSubmit(device_->queue(), 1, &info, fence), "vkQueueSubmit");
    const VkResult waited = vk.vkWaitForFences(device_->handle(), 1, &fence, VK_TRUE, UINT64_MAX);
    // A driver may give the device up as lost while that still works, and what it works on is about to be destroyed.
    if (waited != VK_SUCCESS) vk.vkDeviceWaitIdle(device_->handle());
    check(waited, "vkWaitForFences");
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    check(vk.vkResetFences(device_->handle(), 1, &fence), "vkResetFences");
    return seconds.count();
}

void CommandBuffer::barrier(VkPipelineStageFlags from_stage, VkAccessFlags from_access, VkPipelineStageFlags to_stage,
                            VkAccessFlags to_access) const {
    const VkMemoryBarrier memory = {VK_STRUCTURE_TYPE_MEMORY_BARRIER, nullptr, from_access, to_access};
    device_->vk().vkCmdPipelineBarrier(commands_, from_stage, to_stage, 0, 1, &memory, 0, nullptr, 0, nullptr);
}

Batch::Batch(Device& device, const std::string& name) : device_(&device), commands_(device, name) {
    if (device.hasTimestamps()) {
        VkQueryPoolCreateInfo create = {VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
        create.queryType = VK_QUERY_TYPE_TIMESTAMP;
        create.queryCount = 2;
        VkQueryPool pool = VK_NULL_HANDLE;
        check(device.vk().vkCreateQueryPool(device.handle(), &create, nullptr, &pool), "vkCreateQueryPool");
        queries_ = Handle<VkQueryPool>(device.handle(), pool, device.vk().vkDestroyQueryPool);
        device.setName(VK_OBJECT_TYPE_QUERY_POOL, pool, name + " timestamps");
    }
    begin();
}

void Batch::begin() {
    bound_ = nullptr;
    commands_.begin();
    if (queries_.get()) {
        device_->vk().vkCmdResetQueryPool(commands_.handle(), queries_.get(), 0, 2);
        device_->vk().vkCmdWriteTimestamp(commands_.handle(), VK_PIPELINE_STAGE_TOP_OF_PIPE_BIT, queries_.get(), 0);
    }
    // A fence makes earlier writes available, not visible: what batches and transfers left is made so here.
    commands_.barrier(VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_TRANSFER_BIT,
                      VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_WRITE_BIT, VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT,
                      VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_UNIFORM_READ_BIT);
}

void Batch::bind(const ComputePipeline& pipeline, const BindingSet& set) {
    assert(pipeline.bindings() == set.bindings());
    const VkDescriptorSet sets[] = {set.handle()};
    device_->vk().vkCmdBindPipeline(commands_.handle(), VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.handle());
    device_->vk().vkCmdBindDescriptorSets(commands_.handle(), VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.layout(), 0, 1,
                                          sets, 0, nullptr);
    bound_ = &pipeline;
}

void Batch::push(const void* data, std::uint32_t bytes) {
    assert(bound_ && bytes == bound_->pushConstantBytes());
    device_->vk().vkCmdPushConstants(commands_.handle(), bound_->layout(), VK_SHADER_STAGE_COMPUTE_BIT, 0, bytes, data);
}

void Batch::dispatch(std::uint32_t x, std::uint32_t y, std::uint32_t z) {
    assert(bound_ && x > 0 && y > 0 && z > 0);
    const auto& most = device_->limits().max_workgroup_count;
    checkLimit(x, most[0], "maxComputeWorkGroupCount[0]", "dispatch");
    checkLimit(y, most[1], "maxComputeWorkGroupCount[1]", "dispatch");
    checkLimit(z, most[2], "maxComputeWorkGroupCount[2]", "dispatch");
    device_->vk().vkCmdDispatch(commands_.handle(), x, y, z);
}

void Batch::barrier() {
    commands_.barrier(VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_WRITE_BIT,
                      VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT);
}

void Batch::dispatchIndirect(const Buffer& counts) {
    assert(bound_ && counts.usage() == Buffer::Usage::Storage && counts.size() >= 12);
    commands_.barrier(VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_WRITE_BIT,
                      VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | VK_PIPELINE_STAGE_DRAW_INDIRECT_BIT,
                      VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_INDIRECT_COMMAND_READ_BIT);
    device_->vk().vkCmdDispatchIndirect(commands_.handle(), counts.handle(), 0);
}

void Batch::write(const Buffer& buffer, const void* data, std::uint64_t bytes) {
    assert(bytes % 4 == 0 && bytes <= buffer.size() && bytes <= 65536);
    constexpr VkPipelineStageFlags transfer = VK_PIPELINE_STAGE_TRANSFER_BIT;
    constexpr VkPipelineStageFlags compute = VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT;
    commands_.barrier(compute | transfer | VK_PIPELINE_STAGE_DRAW_INDIRECT_BIT,
                      VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_WRITE_BIT, transfer,
                      VK_ACCESS_TRANSFER_WRITE_BIT);
    device_->vk().vkCmdUpdateBuffer(commands_.handle(), buffer.handle(), 0, bytes, data);
    commands_.barrier(transfer, VK_ACCESS_TRANSFER_WRITE_BIT, compute | transfer,
                      VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_READ_BIT);
}

void Batch::copy(const Buffer& from, const Buffer& to, std::uint64_t bytes) {
    assert(bytes <= from.size() && bytes <= to.size());
    constexpr VkPipelineStageFlags transfer = VK_PIPELINE_STAGE_TRANSFER_BIT;
    commands_.barrier(VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT | transfer,
                      VK_ACCESS_SHADER_WRITE_BIT | VK_ACCESS_TRANSFER_WRITE_BIT, transfer,
                      VK_ACCESS_TRANSFER_READ_BIT | VK_ACCESS_TRANSFER_WRITE_BIT);
    const VkBufferCopy region = {0, 0, bytes};
    device_->vk().vkCmdCopyBuffer(commands_.handle(), from.handle(), to.handle(), 1, &region);
    commands_.barrier(transfer, VK_ACCESS_TRANSFER_WRITE_BIT, VK_PIPELINE_STAGE_HOST_BIT, VK_ACCESS_HOST_READ_BIT);
}

double Batch::submit() {
    commands_.barrier(VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT, VK_ACCESS_SHADER_WRITE_BIT, VK_PIPELINE_STAGE_HOST_BIT,
                      VK_ACCESS_HOST_READ_BIT);
    if (queries_.get()) {
        device_->vk().vkCmdWriteTimestamp(commands_.handle(), VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, queries_.get(), 1);
    }
    double seconds = commands_.submit();
    if (queries_.get()) {
        std::uint64_t ticks[2] = {};
        check(device_->vk().vkGetQueryPoolResults(device_->handle(), queries_.get(), 0, 2, sizeof(ticks), ticks,
                                                  sizeof(ticks[0]), VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
              "vkGetQueryPoolResults");
        seconds = device_->timestampSeconds(ticks[0], ticks[1]);
    }
    begin();
    return seconds;
}

}  // namespace dsphere::gpu
