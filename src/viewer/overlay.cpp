#include "viewer/overlay.h"

#include <imgui.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "gpu/result.h"

namespace dsphere::viewer {

using gpu::Buffer;
using gpu::check;

namespace {

struct Placement {
    float scale[2], shift[2], greatest_uv[2];
};

Buffer hostBuffer(gpu::Device& device, Buffer::Usage usage, std::uint64_t bytes, const char* name) {
    return Buffer(device, usage, Buffer::Place::Host, bytes, name);
}

// Grows in powers of two, so that a panel that opens costs one allocation.
void makeRoom(gpu::Device& device, std::optional<Buffer>& buffer, std::uint64_t bytes, const char* name) {
    if (buffer && buffer->size() >= bytes) return;
    std::uint64_t size = 1u << 16;
    while (size < bytes) size *= 2;
    buffer.emplace(hostBuffer(device, Buffer::Usage::Vertices, size, name));
}

}  // namespace

Overlay::Overlay(gpu::Device& device, VkRenderPass pass) : device_(device) {
    VkSamplerCreateInfo create = {VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
    create.magFilter = create.minFilter = VK_FILTER_LINEAR;
    create.addressModeU = create.addressModeV = create.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
    VkSampler made = VK_NULL_HANDLE;
    check(device.vk().vkCreateSampler(device.handle(), &create, nullptr, &made), "vkCreateSampler");
    sampler_ = {device.handle(), made, device.vk().vkDestroySampler};
    makeSets();
    makePipeline(pass);
}

void Overlay::makeSets() {
    const VolkDeviceTable& vk = device_.vk();
    const VkDescriptorSetLayoutBinding binding = {0, VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 1,
                                                  VK_SHADER_STAGE_FRAGMENT_BIT, nullptr};
    VkDescriptorSetLayoutCreateInfo layout = {VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
    layout.bindingCount = 1;
    layout.pBindings = &binding;
    VkDescriptorSetLayout made_layout = VK_NULL_HANDLE;
    check(vk.vkCreateDescriptorSetLayout(device_.handle(), &layout, nullptr, &made_layout),
          "vkCreateDescriptorSetLayout");
    set_layout_ = {device_.handle(), made_layout, vk.vkDestroyDescriptorSetLayout};
    const VkDescriptorPoolSize size = {VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, 2};
    VkDescriptorPoolCreateInfo pool = {VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
    pool.maxSets = 2;
    pool.poolSizeCount = 1;
    pool.pPoolSizes = &size;
    VkDescriptorPool made_pool = VK_NULL_HANDLE;
    check(vk.vkCreateDescriptorPool(device_.handle(), &pool, nullptr, &made_pool), "vkCreateDescriptorPool");
    pool_ = {device_.handle(), made_pool, vk.vkDestroyDescriptorPool};
    const VkDescriptorSetLayout layouts[] = {made_layout, made_layout};
    VkDescriptorSetAllocateInfo allocate = {VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
    allocate.descriptorPool = made_pool;
    allocate.descriptorSetCount = 2;
    allocate.pSetLayouts = layouts;
    VkDescriptorSet sets[2] = {};
    check(vk.vkAllocateDescriptorSets(device_.handle(), &allocate, sets), "vkAllocateDescriptorSets");
    font_set_ = sets[0];
    picture_set_ = sets[1];

    const VkPushConstantRange range = {VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT, 0, sizeof(Placement)};
    VkPipelineLayoutCreateInfo create = {VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
    create.setLayoutCount = 1;
    create.pSetLayouts = &made_layout;
    create.pushConstantRangeCount = 1;
    create.pPushConstantRanges = &range;
    VkPipelineLayout made = VK_NULL_HANDLE;
    check(vk.vkCreatePipelineLayout(device_.handle(), &create, nullptr, &made), "vkCreatePipelineLayout");
    layout_ = {device_.handle(), made, vk.vkDestroyPipelineLayout};
}

void Overlay::bindTexture(VkDescriptorSet set, const SampledImage& texture) const {
    const VkDescriptorImageInfo image = {sampler_.get(), texture.view(), VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
    VkWriteDescriptorSet write = {VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    write.dstSet = set;
    write.descriptorCount = 1;
    write.descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
    write.pImageInfo = &image;
    device_.vk().vkUpdateDescriptorSets(device_.handle(), 1, &write, 0, nullptr);
}

void Overlay::setFont(const unsigned char* rgba, int width, int height) {
    const std::uint64_t bytes = 4 * std::uint64_t(width) * std::uint64_t(height);
    font_.emplace(device_, width, height, "font");
    font_pixels_.emplace(hostBuffer(device_, Buffer::Usage::Staging, bytes, "font pixels"));
    font_pixels_->upload(0, bytes, rgba);
    bindTexture(font_set_, *font_);
    font_is_new_ = true;
}

void Overlay::setPicture(const SampledImage& texture, int width, int height) {
    bindTexture(picture_set_, texture);
    picture_u_ = (float(width) - 0.5f) / float(texture.width());
    picture_v_ = (float(height) - 0.5f) / float(texture.height());
}

void Overlay::upload(VkCommandBuffer commands, const ImDrawData& data) {
    if (font_is_new_) font_->fill(commands, *font_pixels_, font_->width(), font_->height());
    font_is_new_ = false;
    if (data.TotalVtxCount == 0) return;
    makeRoom(device_, vertices_, std::uint64_t(data.TotalVtxCount) * sizeof(ImDrawVert), "overlay vertices");
    makeRoom(device_, indices_, std::uint64_t(data.TotalIdxCount) * sizeof(ImDrawIdx), "overlay indices");
    std::byte *vertex = vertices_->mapped().data(), *index = indices_->mapped().data();
    for (int i = 0; i < data.CmdListsCount; ++i) {
        const ImDrawList& list = *data.CmdLists[i];
        if (list.VtxBuffer.empty()) continue;  // its pointers may be null, which memcpy must not be given
        std::memcpy(vertex, list.VtxBuffer.Data, std::size_t(list.VtxBuffer.size_in_bytes()));
        std::memcpy(index, list.IdxBuffer.Data, std::size_t(list.IdxBuffer.size_in_bytes()));
        vertex += list.VtxBuffer.size_in_bytes();
        index += list.IdxBuffer.size_in_bytes();
    }
    vertices_->flush();
    indices_->flush();
}

void Overlay::pushPlacement(VkCommandBuffer commands, const ImDrawData& data, bool picture) const {
    const float x = 2.0f / data.DisplaySize.x, y = 2.0f / data.DisplaySize.y;
    const Placement placement = {{x, y},
                                 {-1.0f - data.DisplayPos.x * x, -1.0f - data.DisplayPos.y * y},
                                 {picture ? picture_u_ : 1.0f, picture ? picture_v_ : 1.0f}};
    device_.vk().vkCmdPushConstants(commands, layout_.get(), VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT,
                                    0, sizeof(placement), &placement);
}

void Overlay::record(VkCommandBuffer commands, const ImDrawData& data, VkExtent2D extent) const {
    if (data.TotalVtxCount == 0) return;
    const VolkDeviceTable& vk = device_.vk();
    const ImVec2 scale = data.FramebufferScale;
    const float width = float(extent.width), height = float(extent.height);
    const VkViewport viewport = {0.0f, 0.0f, width, height, 0.0f, 1.0f};
    const VkBuffer vertices = vertices_->handle();
    const VkDeviceSize start = 0;
    vk.vkCmdBindPipeline(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, pipeline_.get());
    vk.vkCmdSetViewport(commands, 0, 1, &viewport);
    vk.vkCmdBindVertexBuffers(commands, 0, 1, &vertices, &start);
    vk.vkCmdBindIndexBuffer(commands, indices_->handle(), 0,
                            sizeof(ImDrawIdx) == 2 ? VK_INDEX_TYPE_UINT16 : VK_INDEX_TYPE_UINT32);
    std::uint32_t first_index = 0;
    std::int32_t first_vertex = 0;
    for (int i = 0; i < data.CmdListsCount; ++i) {
        const ImDrawList& list = *data.CmdLists[i];
        for (const ImDrawCmd& command : list.CmdBuffer) {
            const float x0 = std::max((command.ClipRect.x - data.DisplayPos.x) * scale.x, 0.0f);
            const float y0 = std::max((command.ClipRect.y - data.DisplayPos.y) * scale.y, 0.0f);
            const float x1 = std::min((command.ClipRect.z - data.DisplayPos.x) * scale.x, width);
            const float y1 = std::min((command.ClipRect.w - data.DisplayPos.y) * scale.y, height);
            if (x1 <= x0 || y1 <= y0) continue;
            const VkRect2D scissor = {{std::int32_t(x0), std::int32_t(y0)},
                                      {std::uint32_t(x1 - x0), std::uint32_t(y1 - y0)}};
            const bool picture = reinterpret_cast<std::uintptr_t>(command.TextureId) == kPicture;
            const VkDescriptorSet set = picture ? picture_set_ : font_set_;
            vk.vkCmdSetScissor(commands, 0, 1, &scissor);
            vk.vkCmdBindDescriptorSets(commands, VK_PIPELINE_BIND_POINT_GRAPHICS, layout_.get(), 0, 1, &set, 0,
                                       nullptr);
            pushPlacement(commands, data, picture);
            vk.vkCmdDrawIndexed(commands, command.ElemCount, 1, first_index + command.IdxOffset,
                                first_vertex + std::int32_t(command.VtxOffset), 0);
        }
        first_index += std::uint32_t(list.IdxBuffer.Size);
        first_vertex += list.VtxBuffer.Size;
    }
}

}  // namespace dsphere::viewer
