#pragma once

#include "gpu/buffer.h"
#include "viewer/sampledimage.h"

#include <optional>

struct ImDrawData;

namespace dsphere::viewer {

/// Draws what Dear ImGui laid out, and behind it the picture, which is a texture like the font.
class Overlay {
  public:
    /// What ImDrawCmd::TextureId says.
    static constexpr std::uintptr_t kFont = 1, kPicture = 2;

    /// The device presents; `pass` is what record() is called within.
    Overlay(gpu::Device& device, VkRenderPass pass);

    /// Sets the font's pixels, which the next upload() copies.
    void setFont(const unsigned char* rgba, int width, int height);
    /// The texture of the picture, of which the corner of width x height is in use.
    void setPicture(const SampledImage& texture, int width, int height);

    /// Before the pass: copies the font, if it is new, and the triangles. Nothing recorded before may still run.
    void upload(VkCommandBuffer commands, const ImDrawData& data);
    /// Within the pass, whose area is `extent`.
    void record(VkCommandBuffer commands, const ImDrawData& data, VkExtent2D extent) const;

  private:
    void makeSets();
    void makePipeline(VkRenderPass pass);
    void bindTexture(VkDescriptorSet set, const SampledImage& texture) const;
    void pushPlacement(VkCommandBuffer commands, const ImDrawData& data, bool picture) const;

    gpu::Device& device_;
    gpu::Handle<VkSampler> sampler_;
    gpu::Handle<VkDescriptorSetLayout> set_layout_;
    gpu::Handle<VkDescriptorPool> pool_;
    VkDescriptorSet font_set_ = VK_NULL_HANDLE, picture_set_ = VK_NULL_HANDLE;
    gpu::Handle<VkPipelineLayout> layout_;
    gpu::Handle<VkPipeline> pipeline_;
    std::optional<SampledImage> font_;
    std::optional<gpu::Buffer> font_pixels_, vertices_, indices_;
    bool font_is_new_ = false;
    float picture_u_ = 1.0f, picture_v_ = 1.0f;
};

}  // namespace dsphere::viewer
