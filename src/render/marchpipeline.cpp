#include "render/marchpipeline.h"

#include <array>

namespace dsphere {

gpu::ComputePipeline makeMarchPipeline(gpu::Device& device, const PackedScene& packed,
                                       std::span<const std::uint32_t> spirv, Shader shader, Marcher marcher,
                                       Precision precision, std::uint32_t planes) {
    using gpu::Binding;
    std::vector<Binding::Kind> bindings(BINDING_RAMPS, Binding::UniformBuffer);
    bindings.push_back(Binding::StorageBuffer);
    bindings.insert(bindings.end(), BINDING_FILM - BINDING_HEIGHTS, Binding::StorageImage);
    bindings.push_back(shader == Shader::Render ? Binding::StorageImage : Binding::StorageBuffer);
    bindings.push_back(Binding::StorageBuffer);
    std::array<std::uint32_t, SPEC_COUNT> specialization = {};
    specialization[SPEC_MARCHER] = std::uint32_t(marcher);
    specialization[SPEC_OBJECT_COUNT] = std::uint32_t(packed.objects.size());
    specialization[SPEC_LIGHT_COUNT] = std::uint32_t(packed.lights.size());
    specialization[SPEC_KINDS] = packed.kinds;
    specialization[SPEC_PLANES] = planes;
    specialization[SPEC_PRECISION] = std::uint32_t(precision);
    specialization[SPEC_IMAGES] = packed.images.empty() ? 0 : 1;
    std::uint32_t push_bytes = shader == Shader::Render ? sizeof(layout::RenderParams) : 0;
    return gpu::ComputePipeline(device, spirv, bindings, specialization, push_bytes,
                                shader == Shader::Render ? "render" : "probe");
}

}  // namespace dsphere
