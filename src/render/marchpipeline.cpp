#include "render/marchpipeline.h"

#include "gpu/device.h"
#include "render/specialization.h"

#include <algorithm>
#include <thread>

namespace dsphere {

namespace {

using gpu::Binding;

constexpr unsigned bit(Shader shader) {
    return 1u << unsigned(shader);
}
constexpr unsigned kRender = bit(Shader::Render), kProbe = bit(Shader::Probe), kQuery = bit(Shader::Query);
constexpr unsigned kAll = kRender | kProbe | kQuery;

struct BindingRow {
    int number;  ///< BINDING_
    Binding::Kind kind;
    unsigned shaders;  ///< that have it: bit() of each
};

/// What lies where: layout.h names it, and DeviceScene::resources() is the part that all shaders have.
constexpr BindingRow kBindings[] = {
    {BINDING_OBJECTS, Binding::UniformBuffer, kAll},
    {BINDING_MAPS, Binding::UniformBuffer, kAll},
    {BINDING_LIGHTS, Binding::UniformBuffer, kAll},
    {BINDING_MATERIALS, Binding::UniformBuffer, kAll},
    {BINDING_TRIANGLES, Binding::UniformBuffer, kAll},
    {BINDING_RAMPS, Binding::StorageBuffer, kAll},
    {BINDING_TABLES, Binding::StorageBuffer, kAll},
    {BINDING_HEIGHTS, Binding::StorageImage, kAll},
    {BINDING_BOUNDS, Binding::StorageImage, kAll},
    {BINDING_EDGES, Binding::StorageImage, kAll},
    {BINDING_IMAGES, Binding::StorageImage, kAll},
    {BINDING_SPLINE_NODES, Binding::StorageImage, kAll},
    {BINDING_TILES, Binding::StorageImage, kAll},
    {BINDING_FILM, Binding::StorageImage, kRender},
    {BINDING_FILM, Binding::StorageBuffer, kProbe | kQuery},  // their rays
    {BINDING_HITS, Binding::StorageBuffer, kProbe},
    {BINDING_RETRY, Binding::StorageBuffer, kRender | kQuery},
    {BINDING_ABSENT, Binding::StorageBuffer, kRender | kQuery},
    {BINDING_ANSWERS, Binding::StorageBuffer, kQuery},
    {BINDING_LOOKS, Binding::StorageBuffer, kQuery},
};

/// Each shader's bindings are numbered 0, 1, 2...
constexpr bool areNumbered(Shader shader) {
    int next = 0;
    for (const BindingRow& row : kBindings)
        if ((row.shaders & bit(shader)) && row.number != next++) return false;
    return true;
}
static_assert(areNumbered(Shader::Render) && areNumbered(Shader::Probe) && areNumbered(Shader::Query));

std::vector<Binding::Kind> bindingsOf(Shader shader) {
    std::vector<Binding::Kind> kinds;
    for (const BindingRow& row : kBindings)
        if (row.shaders & bit(shader)) kinds.push_back(row.kind);
    return kinds;
}

}  // namespace

bool runsOnCpu(const gpu::Device& device) {
    return device.info().type == "CPU";
}

// Baselines have no second pipeline to leave pixels to. Fewer turns where a pixel's loops are long before any march,
// and where cores are many: each has to find groups to run.
int turnsOf(const gpu::Device& device, const SceneTraits& traits, const MarchMethod& method) {
    if (!traits.needsPaths() || method.marcher != Marcher::Exact || !runsOnCpu(device)) return 1;
    const std::uint64_t vertices = traits.paths.max_depth + 1;
    const std::uint64_t lights = traits.paths.diffuse_paths ? traits.lights + vertices : traits.lights * vertices;
    const std::uint64_t loops = (vertices + lights) * (2 * traits.objects + traits.triangles + 1);
    const std::uint64_t cores = std::max(1u, std::thread::hardware_concurrency());
    return int(std::clamp<std::uint64_t>(std::min(TURN_LOOPS / loops, 32 / cores), 1, 8));
}

gpu::ComputePipeline makeMarchPipeline(gpu::Device& device, const SceneTraits& traits, float stride,
                                       std::span<const std::uint32_t> spirv, Shader shader, const MarchMethod& method,
                                       std::uint32_t planes) {
    Specialization specialization = specializationOf(traits, stride, method, planes);
    specialization[SPEC_TURNS] = std::uint32_t(turnsOf(device, traits, method));
    // One ray that takes long holds up all that share its instructions (rule N1).
    specialization[SPEC_RETRY_STRIDE] = runsOnCpu(device) ? 1 : 32;
    struct Kind {
        std::uint32_t push_bytes;
        const char* name;
    };
    constexpr Kind kKinds[] = {
        {sizeof(layout::RenderParams), "render"}, {0, "probe"}, {sizeof(layout::QueryParams), "query"}};
    const Kind& kind = kKinds[std::size_t(shader)];
    return gpu::ComputePipeline(device, spirv, bindingsOf(shader), specialization, kind.push_bytes, kind.name);
}

}  // namespace dsphere
