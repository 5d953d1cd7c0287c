#include "render/probe.h"

#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "render/marchpipeline.h"
#include "render/tovec4.h"
#include "shaders/probe_curved.spv.h"
#include "shaders/probe_lean.spv.h"

namespace dsphere {

namespace {

using Spirv = std::span<const std::uint32_t>;

}  // namespace

layout::ProbeRay packProbe(const ProbeQuery& query) {
    double size = glm::length(query.direction);
    dvec3 d = size > 0.0 ? query.direction / size : query.direction;
    dvec3 point = glm::cross(d, glm::cross(query.origin, d));
    layout::ProbeRay ray = {};
    ray.point = toVec4(point, -glm::dot(query.origin, d));
    ray.point_lo = toVec4(point - dvec3(ray.point), 0.0);
    ray.direction = toVec4(d, query.length);
    ray.direction_lo = toVec4(d - dvec3(ray.direction), 0.0);
    ray.flags = query.secondary ? 1u : 0u;
    return ray;
}

Probe::Probe(gpu::Device& device, const PackedScene& packed)
    : device_(device),
      device_scene_(device, packed),
      pipeline_(makeMarchPipeline(device, packed.traits, 1.0f,
                                  packed.traits.curved() ? Spirv(kSpirv_probe_curved) : Spirv(kSpirv_probe_lean),
                                  Shader::Probe, Marcher::Exact, 0)) {}

std::vector<layout::ProbeHit> Probe::trace(const std::vector<ProbeQuery>& queries) {
    std::vector<layout::ProbeRay> rays;
    for (const ProbeQuery& query : queries) rays.push_back(packProbe(query));
    std::vector<layout::ProbeHit> hits(queries.size());
    if (queries.empty()) return hits;
    using gpu::Buffer;
    Buffer input(device_, Buffer::Usage::Storage, Buffer::Place::Device, rays.size() * sizeof(rays[0]), "rays");
    Buffer output(device_, Buffer::Usage::Storage, Buffer::Place::Device, hits.size() * sizeof(hits[0]), "hits");
    input.upload(0, input.size(), rays.data());
    std::vector<gpu::Resource> resources = device_scene_.resources();
    resources.push_back(&input);
    resources.push_back(&output);
    gpu::BindingSet set(device_, pipeline_, resources, "probe");
    gpu::Batch batch(device_, "probe");
    batch.bind(pipeline_, set);
    batch.dispatch(std::uint32_t((rays.size() + PROBE_GROUP_SIZE - 1) / PROBE_GROUP_SIZE), 1, 1);
    batch.submit();
    output.download(0, output.size(), hits.data());
    return hits;
}

}  // namespace dsphere
