#include "render/marchpipeline.h"

#include "gpu/device.h"
#include "render/specialization.h"

#include <algorithm>
#include <thread>

namespace dsphere {

bool isNarrow(const gpu::Device& device) {
    return device.info().type == "CPU";
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
                                       std::uint32_t planes, bool listed) {
    using gpu::Binding;
    std::vector<Binding::Kind> bindings(BINDING_RAMPS, Binding::UniformBuffer);
    bindings.insert(bindings.end(), BINDING_HEIGHTS - BINDING_RAMPS, Binding::StorageBuffer);
    bindings.insert(bindings.end(), BINDING_FILM - BINDING_HEIGHTS, Binding::StorageImage);
    bindings.push_back(shader == Shader::Render ? Binding::StorageImage : Binding::StorageBuffer);
    bindings.push_back(Binding::StorageBuffer);
    if (shader != Shader::Probe) bindings.push_back(Binding::StorageBuffer);
    if (shader == Shader::Query) bindings.insert(bindings.end(), 2, Binding::StorageBuffer);
    Specialization specialization = specializationOf(traits, stride, method, planes);
    specialization[SPEC_TURNS] = listed ? 1u : std::uint32_t(turnsOf(device, traits, method));
    specialization[SPEC_LISTED] = listed ? 1 : 0;
    // One ray that takes long holds all up that share its instructions.
    specialization[SPEC_RETRY_STRIDE] = isNarrow(device) ? 1 : 32;
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
