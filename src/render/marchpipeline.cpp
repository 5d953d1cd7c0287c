#include "render/marchpipeline.h"

#include "base/error.h"
#include "surface/slope.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace dsphere {

namespace {

// Of |p| - r, for the steepest of the scene's maps; rounded down.
float safeStride(const PackedScene& packed) {
    if (packed.curved())
        throwInvalid(
            "the Lipschitz marcher knows bilinear surfaces alone; the scene has a B-spline, ripples or smooth normals");
    double bound = 1.0;
    for (const PackedRelief& relief : packed.reliefs)
        bound = std::max(bound, gradientBound(*packed.nodes[std::size_t(relief.map)], relief.base, relief.scale));
    return std::nextafter(float(1.0 / bound), 0.0f);
}

}  // namespace

gpu::ComputePipeline makeMarchPipeline(gpu::Device& device, const PackedScene& packed,
                                       std::span<const std::uint32_t> spirv, Shader shader, const MarchMethod& method,
                                       std::uint32_t planes) {
    using gpu::Binding;
    std::vector<Binding::Kind> bindings(BINDING_RAMPS, Binding::UniformBuffer);
    bindings.push_back(Binding::StorageBuffer);
    bindings.insert(bindings.end(), BINDING_FILM - BINDING_HEIGHTS, Binding::StorageImage);
    bindings.push_back(shader == Shader::Render ? Binding::StorageImage : Binding::StorageBuffer);
    bindings.push_back(Binding::StorageBuffer);
    std::array<std::uint32_t, SPEC_COUNT> specialization = {};
    specialization[SPEC_MARCHER] = std::uint32_t(method.marcher);
    specialization[SPEC_OBJECT_COUNT] = std::uint32_t(packed.objects.size());
    specialization[SPEC_LIGHT_COUNT] = std::uint32_t(packed.lights.size());
    specialization[SPEC_KINDS] = packed.kinds;
    specialization[SPEC_PLANES] = planes;
    specialization[SPEC_IMAGES] = packed.images.empty() ? 0 : 1;
    specialization[SPEC_SURFACES] = packed.surfaces;
    specialization[SPEC_THRESHOLD] = std::bit_cast<std::uint32_t>(method.threshold);
    specialization[SPEC_STRIDE] =
        std::bit_cast<std::uint32_t>(method.marcher == Marcher::Lipschitz ? safeStride(packed) : 1.0f);
    specialization[SPEC_DETAIL] = std::bit_cast<std::uint32_t>(method.detail);
    std::uint32_t push_bytes = shader == Shader::Render ? sizeof(layout::RenderParams) : 0;
    return gpu::ComputePipeline(device, spirv, bindings, specialization, push_bytes,
                                shader == Shader::Render ? "render" : "probe");
}

}  // namespace dsphere
