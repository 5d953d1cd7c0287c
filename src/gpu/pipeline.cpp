#include "gpu/pipeline.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <functional>
#include <string_view>
#include <utility>

#include "gpu/buffer.h"
#include "gpu/device.h"
#include "gpu/image.h"
#include "gpu/result.h"

namespace dsphere::gpu {
namespace {

VkDescriptorType descriptorType(Binding::Kind kind) {
    switch (kind) {
        case Binding::StorageBuffer:
            return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
        case Binding::UniformBuffer:
            return VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
        case Binding::StorageImage:
            break;
    }
    return VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
}

void checkBindings(const Limits& limits, std::span<const Binding::Kind> bindings, const std::string& name) {
    const auto count = [&](Binding::Kind kind) { return std::uint64_t(std::ranges::count(bindings, kind)); };
    checkLimit(count(Binding::StorageBuffer), limits.max_storage_buffers, "maxPerStageDescriptorStorageBuffers", name);
    checkLimit(count(Binding::UniformBuffer), limits.max_uniform_buffers, "maxPerStageDescriptorUniformBuffers", name);
    checkLimit(count(Binding::StorageImage), limits.max_storage_images, "maxPerStageDescriptorStorageImages", name);
}

Handle<VkDescriptorSetLayout> makeSetLayout(const Device& device, std::span<const Binding::Kind> kinds,
                                            const std::string& name) {
    std::vector<VkDescriptorSetLayoutBinding> bindings;
    for (Binding::Kind kind : kinds) {
        const auto number = std::uint32_t(bindings.size());
        bindings.push_back({number, descriptorType(kind), 1, VK_SHADER_STAGE_COMPUTE_BIT, nullptr});
    }
    VkDescriptorSetLayoutCreateInfo create = {VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
    create.bindingCount = std::uint32_t(bindings.size());
    create.pBindings = bindings.data();
    VkDescriptorSetLayout made = VK_NULL_HANDLE;
    check(device.vk().vkCreateDescriptorSetLayout(device.handle(), &create, nullptr, &made),
          "vkCreateDescriptorSetLayout");
    device.setName(VK_OBJECT_TYPE_DESCRIPTOR_SET_LAYOUT, made, name + " set layout");
    return {device.handle(), made, device.vk().vkDestroyDescriptorSetLayout};
}

Handle<VkPipelineLayout> makeLayout(const Device& device, VkDescriptorSetLayout set_layout, std::uint32_t push_bytes,
                                    const std::string& name) {
    const VkPushConstantRange range = {VK_SHADER_STAGE_COMPUTE_BIT, 0, push_bytes};
    VkPipelineLayoutCreateInfo create = {VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
    create.setLayoutCount = 1;
    create.pSetLayouts = &set_layout;
    create.pushConstantRangeCount = push_bytes ? 1 : 0;
    create.pPushConstantRanges = &range;
    VkPipelineLayout made = VK_NULL_HANDLE;
    check(device.vk().vkCreatePipelineLayout(device.handle(), &create, nullptr, &made), "vkCreatePipelineLayout");
    device.setName(VK_OBJECT_TYPE_PIPELINE_LAYOUT, made, name + " layout");
    return {device.handle(), made, device.vk().vkDestroyPipelineLayout};
}

Handle<VkShaderModule> makeShader(const Device& device, std::span<const std::uint32_t> spirv, const std::string& name) {
    VkShaderModuleCreateInfo create = {VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
    create.codeSize = spirv.size_bytes();
    create.pCode = spirv.data();
    VkShaderModule made = VK_NULL_HANDLE;
    check(device.vk().vkCreateShaderModule(device.handle(), &create, nullptr, &made), "vkCreateShaderModule");
    device.setName(VK_OBJECT_TYPE_SHADER_MODULE, made, name + " shader");
    return {device.handle(), made, device.vk().vkDestroyShaderModule};
}

Handle<VkPipeline> makePipeline(const Device& device, VkShaderModule shader, VkPipelineLayout layout,
                                std::span<const std::uint32_t> specialization, const std::string& name) {
    std::vector<VkSpecializationMapEntry> entries;
    for (std::uint32_t id = 0; id < specialization.size(); ++id) entries.push_back({id, id * 4, 4});
    const VkSpecializationInfo constants = {std::uint32_t(entries.size()), entries.data(), specialization.size_bytes(),
                                            specialization.data()};
    VkComputePipelineCreateInfo create = {VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
    create.stage.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO;
    create.stage.stage = VK_SHADER_STAGE_COMPUTE_BIT;
    create.stage.module = shader;
    create.stage.pName = "main";
    create.stage.pSpecializationInfo = &constants;
    create.layout = layout;
    VkPipeline made = VK_NULL_HANDLE;
    check(device.vk().vkCreateComputePipelines(device.handle(), device.pipelineCache(), 1, &create, nullptr, &made),
          "vkCreateComputePipelines");
    device.setName(VK_OBJECT_TYPE_PIPELINE, made, name);
    return {device.handle(), made, device.vk().vkDestroyPipeline};
}

template <typename T>
std::string_view bytesOf(std::span<const T> values) {
    return {reinterpret_cast<const char*>(values.data()), values.size_bytes()};
}

/// All that a pipeline is made from; of the shader, which is long, a hash of 64 bits and its size.
std::string keyOf(std::span<const std::uint32_t> spirv, std::span<const Binding::Kind> bindings,
                  std::span<const std::uint32_t> specialization, std::uint32_t push_bytes) {
    const std::array<std::uint64_t, 5> head = {std::hash<std::string_view>()(bytesOf(spirv)), spirv.size(),
                                               bindings.size(), specialization.size(), push_bytes};
    std::string key(bytesOf(std::span<const std::uint64_t>(head)));
    key += bytesOf(bindings);
    key += bytesOf(specialization);
    return key;
}

[[maybe_unused]] bool isKind(const Resource& resource, Binding::Kind kind) {
    if (std::holds_alternative<const StorageImage*>(resource)) return kind == Binding::StorageImage;
    const Buffer::Usage usage = std::get<const Buffer*>(resource)->usage();
    return (kind == Binding::StorageBuffer && usage == Buffer::Usage::Storage) ||
           (kind == Binding::UniformBuffer && usage == Buffer::Usage::Uniform);
}

Handle<VkDescriptorPool> makePool(const Device& device, const std::vector<Binding::Kind>& kinds,
                                  const std::string& name) {
    std::vector<VkDescriptorPoolSize> sizes;
    for (Binding::Kind kind : kinds) sizes.push_back({descriptorType(kind), 1});
    VkDescriptorPoolCreateInfo create = {VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
    create.maxSets = 1;
    create.poolSizeCount = std::uint32_t(sizes.size());
    create.pPoolSizes = sizes.data();
    VkDescriptorPool made = VK_NULL_HANDLE;
    check(device.vk().vkCreateDescriptorPool(device.handle(), &create, nullptr, &made), "vkCreateDescriptorPool");
    device.setName(VK_OBJECT_TYPE_DESCRIPTOR_POOL, made, name + " pool");
    return {device.handle(), made, device.vk().vkDestroyDescriptorPool};
}

void writeBinding(const Device& device, VkDescriptorSet set, std::uint32_t number, Binding::Kind kind,
                  const Resource& resource) {
    VkDescriptorBufferInfo buffer = {};
    VkDescriptorImageInfo image = {};
    VkWriteDescriptorSet write = {VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    write.dstSet = set;
    write.dstBinding = number;
    write.descriptorCount = 1;
    write.descriptorType = descriptorType(kind);
    if (const auto* storage = std::get_if<const StorageImage*>(&resource)) {
        image = {VK_NULL_HANDLE, (*storage)->view(), VK_IMAGE_LAYOUT_GENERAL};
        write.pImageInfo = &image;
    } else {
        buffer = {std::get<const Buffer*>(resource)->handle(), 0, VK_WHOLE_SIZE};
        write.pBufferInfo = &buffer;
    }
    device.vk().vkUpdateDescriptorSets(device.handle(), 1, &write, 0, nullptr);
}

}  // namespace

ComputePipeline::ComputePipeline(Device& device, std::span<const std::uint32_t> spirv,
                                 std::span<const Binding::Kind> bindings, std::span<const std::uint32_t> specialization,
                                 std::uint32_t push_constant_bytes, const std::string& name)
    : bindings_(bindings.begin(), bindings.end()), push_constant_bytes_(push_constant_bytes) {
    assert(!bindings.empty() && push_constant_bytes % 4 == 0);
    checkLimit(push_constant_bytes, device.limits().max_push_constants_size, "maxPushConstantsSize", name);
    checkBindings(device.limits(), bindings, name);
    std::string key = keyOf(spirv, bindings, specialization, push_constant_bytes);
    objects_ = device.pipelineStore().find(key);
    if (objects_) return;
    PipelineObjects made;
    made.set_layout = makeSetLayout(device, bindings, name);
    made.layout = makeLayout(device, made.set_layout.get(), push_constant_bytes, name);
    const Handle<VkShaderModule> shader = makeShader(device, spirv, name);
    made.pipeline = makePipeline(device, shader.get(), made.layout.get(), specialization, name);
    objects_ = std::make_shared<const PipelineObjects>(std::move(made));
    device.pipelineStore().keep(std::move(key), objects_);
}

BindingSet::BindingSet(Device& device, const ComputePipeline& pipeline, const std::vector<Resource>& resources,
                       const std::string& name)
    : bindings_(pipeline.bindings()) {
    assert(resources.size() == bindings_.size());
    pool_ = makePool(device, bindings_, name);
    const VkDescriptorSetLayout layout = pipeline.setLayout();
    VkDescriptorSetAllocateInfo allocate = {VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
    allocate.descriptorPool = pool_.get();
    allocate.descriptorSetCount = 1;
    allocate.pSetLayouts = &layout;
    check(device.vk().vkAllocateDescriptorSets(device.handle(), &allocate, &set_), "vkAllocateDescriptorSets");
    device.setName(VK_OBJECT_TYPE_DESCRIPTOR_SET, set_, name);
    for (std::uint32_t i = 0; i < resources.size(); ++i) {
        assert(isKind(resources[i], bindings_[i]));
        writeBinding(device, set_, i, bindings_[i], resources[i]);
    }
}

}  // namespace dsphere::gpu
