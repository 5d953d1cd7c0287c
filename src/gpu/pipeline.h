#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "gpu/pipelinestore.h"

namespace dsphere::gpu {

class Buffer;
class Device;
class StorageImage;

struct Binding {
    enum Kind { StorageBuffer, UniformBuffer, StorageImage };
};

/// A compute shader made ready: entry point `main`, descriptor set 0 with bindings 0, 1, 2... of the given kinds. Where
/// the device has made the same one before, this shares it, name and all.
class ComputePipeline {
  public:
    /// `specialization` holds the 4-byte values of constant_id 0, 1, 2...; floats and bools are passed by their bits (a
    /// bool as 0 or 1). `push_constant_bytes` is a multiple of 4 within max_push_constants_size; 0 for none.
    ComputePipeline(Device& device, std::span<const std::uint32_t> spirv, std::span<const Binding::Kind> bindings,
                    std::span<const std::uint32_t> specialization, std::uint32_t push_constant_bytes,
                    const std::string& name);

    VkPipeline handle() const { return objects_->pipeline.get(); }
    VkPipelineLayout layout() const { return objects_->layout.get(); }
    VkDescriptorSetLayout setLayout() const { return objects_->set_layout.get(); }
    const std::vector<Binding::Kind>& bindings() const { return bindings_; }
    std::uint32_t pushConstantBytes() const { return push_constant_bytes_; }

  private:
    std::vector<Binding::Kind> bindings_;
    std::uint32_t push_constant_bytes_;
    std::shared_ptr<const PipelineObjects> objects_;
};

/// What a binding points at; never null.
using Resource = std::variant<const Buffer*, const StorageImage*>;

/// A descriptor set: one resource per binding of the pipeline, in order, whole buffers and whole images. The resources
/// must outlive it; the pipeline needs not. It fits every pipeline with the same list of binding kinds.
class BindingSet {
  public:
    BindingSet(Device& device, const ComputePipeline& pipeline, const std::vector<Resource>& resources,
               const std::string& name);

    VkDescriptorSet handle() const { return set_; }
    const std::vector<Binding::Kind>& bindings() const { return bindings_; }

  private:
    std::vector<Binding::Kind> bindings_;
    Handle<VkDescriptorPool> pool_;
    VkDescriptorSet set_ = VK_NULL_HANDLE;  ///< freed with its pool
};

}  // namespace dsphere::gpu
