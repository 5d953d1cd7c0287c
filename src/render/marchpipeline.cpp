#include "render/marchpipeline.h"

#include "base/error.h"
#include "gpu/device.h"
#include "surface/slope.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <thread>

namespace dsphere {

bool isNarrow(const gpu::Device& device) {
    return device.info().type == "CPU";
}

// For the steepest of the scene's maps; rounded down.
float safeStride(const PackedScene& packed, const MarchMethod& method) {
    if (method.marcher != Marcher::Lipschitz) return 1.0f;
    if (packed.traits.curved())
        throwInvalid(
            "the Lipschitz marcher knows bilinear surfaces alone; the scene has a B-spline, ripples or smooth normals");
    double bound = 1.0;
    for (const PackedRelief& relief : packed.reliefs)
        bound = std::max(bound, gradientBound(*packed.nodes[std::size_t(relief.map)], relief.base, relief.scale));
    return std::nextafter(float(1.0 / bound), 0.0f);
}

// Baselines have no second pipeline to leave pixels to. Fewer turns where a pixel's loops are long before any march,
// and where cores are many: each has to find groups to run.
int turnsOf(const gpu::Device& device, const SceneTraits& traits, const MarchMethod& method) {
    if (!traits.needsPaths() || method.marcher != Marcher::Exact || !isNarrow(device)) return 1;
    const std::uint64_t vertices = traits.paths.max_depth + 1;
    const std::uint64_t lights = traits.paths.diffuse_paths ? traits.lights + vertices : traits.lights * vertices;
    const std::uint64_t loops = (vertices + lights) * (2 * traits.objects + traits.triangles + 1);
    const std::uint64_t cores = std::max(1u, std::thread::hardware_concurrency());
    return int(std::clamp<std::uint64_t>(std::min(TURN_LOOPS / loops, 32 / cores), 1, 8));
}

gpu::ComputePipeline makeMarchPipeline(gpu::Device& device, const SceneTraits& traits, float stride,
                                       std::span<const std::uint32_t> spirv, Shader shader, const MarchMethod& method,
                                       std::uint32_t planes) {
    using gpu::Binding;
    std::vector<Binding::Kind> bindings(BINDING_RAMPS, Binding::UniformBuffer);
    bindings.insert(bindings.end(), BINDING_HEIGHTS - BINDING_RAMPS, Binding::StorageBuffer);
    bindings.insert(bindings.end(), BINDING_FILM - BINDING_HEIGHTS, Binding::StorageImage);
    bindings.push_back(shader == Shader::Render ? Binding::StorageImage : Binding::StorageBuffer);
    bindings.push_back(Binding::StorageBuffer);
    if (shader == Shader::Query) bindings.insert(bindings.end(), 2, Binding::StorageBuffer);
    std::array<std::uint32_t, SPEC_COUNT> specialization = {};
    specialization[SPEC_MARCHER] = std::uint32_t(method.marcher);
    specialization[SPEC_OBJECT_COUNT] = traits.objects;
    specialization[SPEC_LIGHT_COUNT] = traits.lights;
    specialization[SPEC_KINDS] = traits.kinds;
    specialization[SPEC_ONLY_DISPLACED] = std::uint32_t(traits.only_displaced);
    specialization[SPEC_ONLY_PLAIN] = std::uint32_t(traits.only_plain);
    specialization[SPEC_TURNS] = std::uint32_t(turnsOf(device, traits, method));
    specialization[SPEC_PLANES] = planes;
    specialization[SPEC_IMAGES] = traits.images ? 1 : 0;
    specialization[SPEC_SURFACES] = traits.surfaces;
    specialization[SPEC_THRESHOLD] = std::bit_cast<std::uint32_t>(method.threshold);
    specialization[SPEC_STRIDE] = std::bit_cast<std::uint32_t>(stride);
    specialization[SPEC_DETAIL] = std::bit_cast<std::uint32_t>(method.detail);
    specialization[SPEC_SHADOWS] = method.shadows ? 1 : 0;
    // One ray that takes long holds all up that share its instructions.
    specialization[SPEC_RETRY_STRIDE] = isNarrow(device) ? 1 : 32;
    const SceneTraits::Paths& paths = traits.paths;
    specialization[SPEC_MATERIALS] = paths.materials;
    specialization[SPEC_LIGHT_KINDS] = paths.light_kinds;
    specialization[SPEC_CHECKERBOARDS] = paths.checkerboards ? 1 : 0;
    specialization[SPEC_MAX_DEPTH] = paths.max_depth;
    specialization[SPEC_DIFFUSE_PATHS] = paths.diffuse_paths ? 1 : 0;
    specialization[SPEC_CLAMP] = std::bit_cast<std::uint32_t>(paths.clamp);
    specialization[SPEC_REGULARIZE] = paths.regularize ? 1 : 0;
    specialization[SPEC_HIDE_DISTANCE] = paths.hide_distance ? 1 : 0;
    specialization[SPEC_FILTER] = std::uint32_t(paths.filter);
    specialization[SPEC_RADIUS_X] = std::bit_cast<std::uint32_t>(paths.radius_x);
    specialization[SPEC_RADIUS_Y] = std::bit_cast<std::uint32_t>(paths.radius_y);
    struct Kind {
        std::uint32_t push_bytes;
        const char* name;
    };
    constexpr Kind kKinds[] = {
        {sizeof(layout::RenderParams), "render"}, {0, "probe"}, {sizeof(layout::QueryParams), "query"}};
    const Kind& kind = kKinds[std::size_t(shader)];
    return gpu::ComputePipeline(device, spirv, bindings, specialization, kind.push_bytes, kind.name);
}

}  // namespace dsphere
