#include "render/marchpipeline.h"

#include "base/error.h"
#include "surface/slope.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace dsphere {

namespace {

std::uint32_t bit(int place) {
    return 1u << place;
}

std::uint32_t surfacesOf(const DisplacedSphere& sphere) {
    if (sphere.ripples) return bit(SURFACE_RIPPLES);
    if (sphere.filter == Filter::BSpline) return bit(SURFACE_SPLINE);
    return bit(SURFACE_BILINEAR) | (sphere.smooth_normals ? bit(SURFACE_SMOOTH_NORMALS) : 0u);
}

}  // namespace

SceneTraits traitsOf(const Scene& scene) {
    SceneTraits traits{std::uint32_t(scene.shapes.size()), std::uint32_t(scene.lights.size()), 0, 0, false};
    for (const Shape& shape : scene.shapes) {
        traits.images = traits.images || textureAs<ImageMap>(shape.material) != nullptr;
        if (std::holds_alternative<Sphere>(shape.geometry)) traits.kinds |= bit(KIND_SPHERE);
        if (std::holds_alternative<Disk>(shape.geometry)) traits.kinds |= bit(KIND_DISK);
        const auto* displaced = std::get_if<DisplacedSphere>(&shape.geometry);
        if (!displaced) continue;
        traits.kinds |= bit(KIND_DISPLACED);
        traits.surfaces |= surfacesOf(*displaced);
    }
    return traits;
}

SceneTraits traitsOf(const PackedScene& packed) {
    return {std::uint32_t(packed.objects.size()), std::uint32_t(packed.lights.size()), packed.kinds, packed.surfaces,
            !packed.images.empty()};
}

// For the steepest of the scene's maps; rounded down.
float safeStride(const PackedScene& packed, const MarchMethod& method) {
    if (method.marcher != Marcher::Lipschitz) return 1.0f;
    if (traitsOf(packed).curved())
        throwInvalid(
            "the Lipschitz marcher knows bilinear surfaces alone; the scene has a B-spline, ripples or smooth normals");
    double bound = 1.0;
    for (const PackedRelief& relief : packed.reliefs)
        bound = std::max(bound, gradientBound(*packed.nodes[std::size_t(relief.map)], relief.base, relief.scale));
    return std::nextafter(float(1.0 / bound), 0.0f);
}

gpu::ComputePipeline makeMarchPipeline(gpu::Device& device, const SceneTraits& traits, float stride,
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
    specialization[SPEC_OBJECT_COUNT] = traits.objects;
    specialization[SPEC_LIGHT_COUNT] = traits.lights;
    specialization[SPEC_KINDS] = traits.kinds;
    specialization[SPEC_PLANES] = planes;
    specialization[SPEC_IMAGES] = traits.images ? 1 : 0;
    specialization[SPEC_SURFACES] = traits.surfaces;
    specialization[SPEC_THRESHOLD] = std::bit_cast<std::uint32_t>(method.threshold);
    specialization[SPEC_STRIDE] = std::bit_cast<std::uint32_t>(stride);
    specialization[SPEC_DETAIL] = std::bit_cast<std::uint32_t>(method.detail);
    std::uint32_t push_bytes = shader == Shader::Render ? sizeof(layout::RenderParams) : 0;
    return gpu::ComputePipeline(device, spirv, bindings, specialization, push_bytes,
                                shader == Shader::Render ? "render" : "probe");
}

}  // namespace dsphere
