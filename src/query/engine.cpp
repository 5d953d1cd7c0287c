#include "query/engine.h"

#include "base/parallel.h"
#include "query/refine.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <future>
#include <limits>

namespace dsphere::query {

namespace {

constexpr std::uint32_t kBlockRays = 1u << 17;  // times 64 bytes per shape
constexpr std::size_t kChunk = 2048;            // rays that a task packs or finishes

// A shorter direction is taken for 0: what t counts in it would overflow.
constexpr double kLeastDirection = 1e-280;

bool allFinite(const std::array<double, 3>& v) {
    return std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
}

// A ray that meets nothing.
layout::QueryRay nothing() {
    return packRay(dvec3(0.0, 1e15, 0.0), dvec3(1.0, 0.0, 0.0), 0.0, -1.0, false);
}

layout::QueryRay packed(const ShapeFrame& shape, const QueryRay& ray, bool secondary) {
    const DeviceRay on_device = deviceRay(shape, ray);
    const double begin = on_device.origin + on_device.length * ray.t_min;
    const double end = on_device.origin + on_device.length * ray.t_max;
    const bool near = glm::dot(on_device.point, on_device.point) < 1e24;  // in R; else it overflowed or passes far off
    if (!near || !(begin < end)) return nothing();
    return packRay(on_device.point, on_device.direction, begin, end, secondary);
}

template <typename Body>
void inChunks(std::size_t count, Body body) {
    parallelFor((count + kChunk - 1) / kChunk, [&](std::size_t chunk) {
        for (std::size_t i = chunk * kChunk; i < std::min(count, (chunk + 1) * kChunk); ++i) body(i);
    });
}

std::array<double, 3> arrayOf(const dvec3& v) {
    return {v.x, v.y, v.z};
}

}  // namespace

QueryRay RayRows::at(std::size_t i) const {
    const double* row = first + i * std::size_t(columns);
    QueryRay ray{{row[0], row[1], row[2]}, {row[3], row[4], row[5]}};
    if (columns == 8) {
        ray.t_min = row[6];
        ray.t_max = row[7];
    }
    return ray;
}

bool isValid(const QueryRay& ray) {
    const auto& d = ray.direction;
    const double size = std::max({std::abs(d[0]), std::abs(d[1]), std::abs(d[2])});
    return allFinite(ray.origin) && allFinite(d) && size > kLeastDirection && std::isfinite(ray.t_min) &&
           !std::isnan(ray.t_max);
}

Engine::Engine(gpu::Device& device, const Scene& scene, const SceneMaps& maps, const PackedScene& packed_scene,
               const DeviceScene& device_scene, const Options& options)
    : options_(options),
      shapes_(shapeFrames(scene, maps, packed_scene, options.frame)),
      frame_from_world_normal_(options.frame == Frame::World
                                   ? dmat3(1.0)
                                   : glm::transpose(dmat3(scene.shapes[bodyOf(scene)].world_from_object))),
      seed_(std::uint32_t(scene.sampler.seed)),
      pipelines_(device, packed_scene.traits, options.wishes),
      capacity_(std::max(64u, kBlockRays / std::uint32_t(scene.shapes.size()))) {
    for (int i = 0; i < 2; ++i)
        blocks_.push_back(std::make_unique<RayBlock>(device, pipelines_, device_scene, options.wishes,
                                                     std::uint32_t(scene.shapes.size()), capacity_));
}

void Engine::pack(RayBlock& block, std::size_t first, std::size_t count, const Source& source) const {
    const std::span<layout::QueryRay> rays = block.rays();
    inChunks(count, [&](std::size_t i) {
        const QueryRay ray = source(first + i);
        const bool valid = isValid(ray);
        for (std::size_t k = 0; k < shapes_.size(); ++k)
            rays[i * shapes_.size() + k] = valid ? packed(shapes_[k], ray, options_.secondary) : nothing();
    });
}

Answer Engine::answerOf(const QueryRay& ray, const layout::QueryHit& found, const layout::QueryLook* look) const {
    Answer answer;
    QueryHit& hit = answer.hit;
    const bool was_hit = found.flags & 1u, inside = found.flags & 2u, runaway = found.flags & 4u;
    if (runaway || !isValid(ray)) {
        hit.status = QueryStatus::Invalid;
        return answer;
    }
    if (!was_hit) return answer;
    hit.status = inside ? QueryStatus::Inside : QueryStatus::Hit;
    hit.id = found.flags >> 3;
    if (look) answer.colour = {look->red, look->green, look->blue};
    if (!options_.whole) return answer;
    if (!inside) hit.lit = found.lit;  // within the solid no light is seen
    const ShapeFrame& shape = shapes_[hit.id - 1];
    const DeviceRay on_device = deviceRay(shape, ray);
    const dvec3 world_normal(found.nx, found.ny, found.nz);
    Place place;
    if (inside) {
        place = placeAt(shape, on_device, on_device.origin + on_device.length * ray.t_min);
        hit.t = ray.t_min;
    } else {
        place = refined(shape, on_device, dvec3(found.px, found.py, found.pz),
                        shape.device_from_world_normal * world_normal);
        hit.t = std::clamp((place.s - on_device.origin) / on_device.length, ray.t_min, ray.t_max);
    }
    answer.device_position = place.position;
    hit.position = arrayOf(transformPoint(shape.frame_from_device, place.position));
    // A displaced sphere's normal belongs to the refined place. A start inside has the device's, being on no surface.
    const bool on_surface = shape.heights && !inside;
    const dvec3 normal = on_surface ? shape.frame_from_device_normal * displacedNormal(shape, place)
                                    : frame_from_world_normal_ * world_normal;
    const dvec3 unit_normal = glm::normalize(normal);
    hit.normal = {float(unit_normal.x), float(unit_normal.y), float(unit_normal.z)};
    if (look) {
        hit.u = double(look->u);
        hit.v = double(look->v);
    }
    if (shape.heights) describePlace(hit, shape, place);
    return answer;
}

void Engine::finish(const RayBlock& block, std::size_t first, std::size_t count, const Source& source,
                    const Sink& sink) {
    const auto hits = block.hits();
    const auto looks = block.looks();
    std::atomic<std::uint64_t> runaways = 0;
    inChunks(count, [&](std::size_t i) {
        if (hits[i].flags & 4u) ++runaways;
        sink(first + i, answerOf(source(first + i), hits[i], options_.wishes.looks() ? &looks[i] : nullptr));
    });
    runaways_ += runaways;
    retried_ += block.retried();
}

void Engine::trace(std::size_t count, const Source& source, const Sink& sink) {
    const std::size_t blocks = (count + capacity_ - 1) / capacity_;
    const auto sizeOf = [&](std::size_t b) { return std::min<std::size_t>(capacity_, count - b * capacity_); };
    if (blocks > 0) pack(*blocks_[0], 0, sizeOf(0), source);
    for (std::size_t b = 0; b <= blocks; ++b) {
        if (options_.between_blocks) options_.between_blocks();
        std::future<void> tracing;
        if (b < blocks)
            tracing = std::async(std::launch::async, [this, b, rays = std::uint32_t(sizeOf(b))] {
                blocks_[b % 2]->trace(rays, std::uint32_t(traced_ + b * capacity_), seed_);
            });
        RayBlock& other = *blocks_[(b + 1) % 2];
        if (b > 0) finish(other, (b - 1) * capacity_, sizeOf(b - 1), source, sink);
        if (b + 1 < blocks) pack(other, (b + 1) * capacity_, sizeOf(b + 1), source);
        if (tracing.valid()) tracing.get();
    }
    traced_ += count;
}

void Engine::trace(const RayRows& rays, const Sink& sink) {
    trace(
        rays.count, [&](std::size_t i) { return rays.at(i); }, sink);
}

}  // namespace dsphere::query
