#include "query/engine.h"

#include "base/parallel.h"
#include "query/refine.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <future>
#include <limits>

namespace dsphere::query {

namespace {

constexpr std::uint32_t kBlockRays = 1u << 17;  // times 64 bytes per shape
constexpr std::size_t kChunk = 2048;            // rays that a task packs or finishes
constexpr std::size_t kBatch = 64;              // answers that are handed on together, while a cache holds them

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

/// Calls body(first, count) for chunks of so many rays at most, on all cores.
template <typename Body>
void inChunks(std::size_t count, Body body) {
    parallelFor((count + kChunk - 1) / kChunk, [&](std::size_t chunk) {
        const std::size_t first = chunk * kChunk;
        body(first, std::min(kChunk, count - first));
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

void RayRows::copyTo(std::size_t begin, std::span<QueryRay> rays) const {
    for (std::size_t k = 0; k < rays.size(); ++k) rays[k] = at(begin + k);
}

bool isValid(const QueryRay& ray) {
    const auto &o = ray.origin, &d = ray.direction;
    const double size = std::max({std::abs(d[0]), std::abs(d[1]), std::abs(d[2])});
    const double nothing = 0.0 * (o[0] + o[1] + o[2] + d[0] + d[1] + d[2] + ray.t_min);  // NaN unless all are finite
    const bool finite = nothing == 0.0 || (allFinite(o) && allFinite(d) && std::isfinite(ray.t_min));
    return finite && size > kLeastDirection && !std::isnan(ray.t_max);
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
        blocks_.push_back({std::vector<QueryRay>(capacity_),
                           std::make_unique<RayBlock>(device, pipelines_, device_scene, options.wishes,
                                                      std::uint32_t(scene.shapes.size()), capacity_)});
}

void Engine::pack(Block& block, std::size_t first, std::size_t count, const Source& source) const {
    const std::span<layout::QueryRay> on_device = block.on_device->rays();
    const std::size_t shapes = shapes_.size();
    inChunks(count, [&](std::size_t begin, std::size_t size) {
        const std::span<QueryRay> rays(block.rays.data() + begin, size);
        source(first + begin, rays);
        for (std::size_t i = 0; i < size; ++i) {
            const bool valid = isValid(rays[i]);
            if (!valid) rays[i].t_max = QueryHit::kNone;  // which is all that finish() asks for
            for (std::size_t k = 0; k < shapes; ++k)
                on_device[(begin + i) * shapes + k] =
                    valid ? packed(shapes_[k], rays[i], options_.secondary) : nothing();
        }
    });
}

void Engine::fillHit(Answer& answer, const QueryRay& ray, const layout::QueryHit& found) const {
    const AnswerParts& parts = options_.parts;
    QueryHit& hit = answer.hit;
    const bool inside = hit.status == QueryStatus::Inside;
    const ShapeFrame& shape = shapes_[hit.id - 1];
    const dvec3 world_normal(found.nx, found.ny, found.nz);
    const Place place = inside ? placeAt(shape, ray, ray.t_min)
                               : refined(shape, ray, dvec3(found.px, found.py, found.pz),
                                         shape.device_from_world_normal * world_normal);
    hit.t = inside ? ray.t_min : std::clamp(place.t, ray.t_min, ray.t_max);
    answer.device_position = place.position;
    if (parts.position) hit.position = arrayOf(transformPoint(shape.frame_from_device, place.position));
    if (parts.normal) {
        // A displaced sphere's normal belongs to the refined place. A start inside has the device's, being on no
        // surface.
        const bool on_surface = shape.heights && !inside;
        const dvec3 normal = glm::normalize(on_surface ? shape.frame_from_device_normal * displacedNormal(shape, place)
                                                       : frame_from_world_normal_ * world_normal);
        hit.normal = {float(normal.x), float(normal.y), float(normal.z)};
    }
    if (parts.place && shape.heights) describePlace(hit, shape, place);
}

void Engine::fill(Answer& answer, const QueryRay& ray, const layout::QueryHit& found,
                  const layout::QueryLook* look) const {
    QueryHit& hit = answer.hit;
    const bool was_hit = found.flags & 1u, inside = found.flags & 2u, runaway = found.flags & 4u;
    if (runaway || std::isnan(ray.t_max)) hit.status = QueryStatus::Invalid;
    if (!was_hit || hit.status == QueryStatus::Invalid) return;
    hit.status = inside ? QueryStatus::Inside : QueryStatus::Hit;
    hit.id = found.flags >> 3;
    if (!inside) hit.lit = found.lit;  // within the solid no light is seen
    if (look) {
        answer.colour = {look->red, look->green, look->blue};
        hit.u = double(look->u);
        hit.v = double(look->v);
    }
    if (options_.parts.root) fillHit(answer, ray, found);
}

void Engine::finish(const Block& block, std::size_t first, std::size_t count, const Sink& sink) {
    const auto hits = block.on_device->hits();
    const auto looks = block.on_device->looks();
    std::atomic<std::uint64_t> runaways = 0;
    inChunks(count, [&](std::size_t begin, std::size_t size) {
        std::array<Answer, kBatch> answers;
        for (const std::size_t end = begin + size; begin < end; begin += kBatch) {
            const std::size_t some = std::min(kBatch, end - begin);
            for (std::size_t i = 0; i < some; ++i) {
                const std::size_t ray = begin + i;
                if (answers[i].hit.status != QueryStatus::Miss) answers[i] = Answer();  // of the batch before
                if (hits[ray].flags & 4u) ++runaways;
                fill(answers[i], block.rays[ray], hits[ray], options_.wishes.looks() ? &looks[ray] : nullptr);
            }
            sink(first + begin, {block.rays.data() + begin, some}, {answers.data(), some});
        }
    });
    runaways_ += runaways;
}

void Engine::traceBatches(std::size_t count, const Source& source, const Sink& sink) {
    const std::size_t blocks = (count + capacity_ - 1) / capacity_;
    const auto sizeOf = [&](std::size_t b) { return std::min<std::size_t>(capacity_, count - b * capacity_); };
    if (blocks > 0) pack(blocks_[0], 0, sizeOf(0), source);
    for (std::size_t b = 0; b <= blocks; ++b) {
        if (options_.between_blocks) options_.between_blocks();
        std::future<void> tracing;
        if (b < blocks)
            tracing = std::async(std::launch::async, [this, b, rays = std::uint32_t(sizeOf(b))] {
                blocks_[b % 2].on_device->trace(rays, std::uint32_t(traced_ + b * capacity_), seed_);
            });
        Block& other = blocks_[(b + 1) % 2];
        if (b > 0) finish(other, (b - 1) * capacity_, sizeOf(b - 1), sink);
        if (b + 1 < blocks) pack(other, (b + 1) * capacity_, sizeOf(b + 1), source);
        if (tracing.valid()) tracing.get();
    }
    traced_ += count;
}

}  // namespace dsphere::query
