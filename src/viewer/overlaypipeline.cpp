#include "viewer/overlay.h"

#include <imgui.h>

#include <array>
#include <cstddef>

#include "gpu/result.h"
#include "shaders/overlay_frag.spv.h"
#include "shaders/overlay_vert.spv.h"

namespace dsphere::viewer {

using gpu::check;
using gpu::Handle;

namespace {

template <std::size_t Count>
Handle<VkShaderModule> makeShader(const gpu::Device& device, const std::uint32_t (&spirv)[Count]) {
    VkShaderModuleCreateInfo create = {VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
    create.codeSize = sizeof(spirv);
    create.pCode = spirv;
    VkShaderModule made = VK_NULL_HANDLE;
    check(device.vk().vkCreateShaderModule(device.handle(), &create, nullptr, &made), "vkCreateShaderModule");
    return {device.handle(), made, device.vk().vkDestroyShaderModule};
}

VkPipelineShaderStageCreateInfo stage(VkShaderStageFlagBits which, VkShaderModule module) {
    VkPipelineShaderStageCreateInfo info = {VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO};
    info.stage = which;
    info.module = module;
    info.pName = "main";
    return info;
}

VkPipelineColorBlendAttachmentState blending() {
    VkPipelineColorBlendAttachmentState blend = {};
    blend.blendEnable = VK_TRUE;
    blend.srcColorBlendFactor = VK_BLEND_FACTOR_SRC_ALPHA;
    blend.dstColorBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
    blend.srcAlphaBlendFactor = VK_BLEND_FACTOR_ONE;
    blend.dstAlphaBlendFactor = VK_BLEND_FACTOR_ONE_MINUS_SRC_ALPHA;
    blend.colorWriteMask =
        VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
    return blend;
}

const VkVertexInputBindingDescription kBinding = {0, sizeof(ImDrawVert), VK_VERTEX_INPUT_RATE_VERTEX};
const std::array<VkVertexInputAttributeDescription, 3> kAttributes = {{
    {0, 0, VK_FORMAT_R32G32_SFLOAT, offsetof(ImDrawVert, pos)},
    {1, 0, VK_FORMAT_R32G32_SFLOAT, offsetof(ImDrawVert, uv)},
    {2, 0, VK_FORMAT_R8G8B8A8_UNORM, offsetof(ImDrawVert, col)},
}};

}  // namespace

void Overlay::makePipeline(VkRenderPass pass) {
    const Handle<VkShaderModule> vertex = makeShader(device_, kSpirv_overlay_vert);
    const Handle<VkShaderModule> fragment = makeShader(device_, kSpirv_overlay_frag);
    const VkPipelineShaderStageCreateInfo stages[] = {stage(VK_SHADER_STAGE_VERTEX_BIT, vertex.get()),
                                                      stage(VK_SHADER_STAGE_FRAGMENT_BIT, fragment.get())};
    VkPipelineVertexInputStateCreateInfo input = {VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
    input.vertexBindingDescriptionCount = 1;
    input.pVertexBindingDescriptions = &kBinding;
    input.vertexAttributeDescriptionCount = std::uint32_t(kAttributes.size());
    input.pVertexAttributeDescriptions = kAttributes.data();
    VkPipelineInputAssemblyStateCreateInfo assembly = {VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
    assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    VkPipelineViewportStateCreateInfo viewport = {VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
    viewport.viewportCount = viewport.scissorCount = 1;
    VkPipelineRasterizationStateCreateInfo raster = {VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
    raster.lineWidth = 1.0f;
    VkPipelineMultisampleStateCreateInfo multisample = {VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
    multisample.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
    const VkPipelineColorBlendAttachmentState blend = blending();
    VkPipelineColorBlendStateCreateInfo colour = {VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
    colour.attachmentCount = 1;
    colour.pAttachments = &blend;
    const VkDynamicState states[] = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};
    VkPipelineDynamicStateCreateInfo dynamic = {VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO};
    dynamic.dynamicStateCount = 2;
    dynamic.pDynamicStates = states;
    VkGraphicsPipelineCreateInfo create = {VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO};
    create.stageCount = 2;
    create.pStages = stages;
    create.pVertexInputState = &input;
    create.pInputAssemblyState = &assembly;
    create.pViewportState = &viewport;
    create.pRasterizationState = &raster;
    create.pMultisampleState = &multisample;
    create.pColorBlendState = &colour;
    create.pDynamicState = &dynamic;
    create.layout = layout_.get();
    create.renderPass = pass;
    VkPipeline made = VK_NULL_HANDLE;
    check(device_.vk().vkCreateGraphicsPipelines(device_.handle(), device_.pipelineCache(), 1, &create, nullptr, &made),
          "vkCreateGraphicsPipelines");
    device_.setName(VK_OBJECT_TYPE_PIPELINE, made, "overlay");
    pipeline_ = {device_.handle(), made, device_.vk().vkDestroyPipeline};
}

}  // namespace dsphere::viewer
