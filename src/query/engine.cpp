#include "query/engine.h"

#include "base/parallel.h"
#include "query/roots.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <future>
#include <limits>

namespace dsphere::query {

namespace {

constexpr std::uint32_t kBlockRays = 1u << 16;  // times 64 bytes per shape

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
        blocks_.push_back(
            {SentRays(capacity_), std::make_unique<RayBlock>(device, pipelines_, device_scene, options.wishes,
                                                             std::uint32_t(scene.shapes.size()), capacity_)});
}

void Engine::pack(Block& block, std::size_t first, std::size_t count, const RaySource& source) const {
    block.sent.take(shapes_, first, count, source);
    block.count = block.sent.pack(shapes_, options_.secondary, block.on_device->rays());
}

/// Answers that are handed on together, while a cache holds them.
struct Engine::Batch {
    static constexpr std::size_t kMost = 64;

    std::size_t begin, count = 0;  ///< the number of the first, and of them
    std::array<Answer, kMost> answers;
    /// Those whose roots are to be found, of one shape.
    std::array<std::uint8_t, kMost> which;
    std::array<const layout::QueryHit*, kMost> found;
    std::array<FoundHit, kMost> hits;
    std::array<Place, kMost> places;
    std::size_t hit_count = 0;
};

bool Engine::fill(Answer& answer, const layout::QueryHit& found, const layout::QueryLook* look) const {
    QueryHit& hit = answer.hit;
    const bool was_hit = found.flags & 1u, inside = found.flags & 2u, runaway = found.flags & 4u;
    if (runaway) hit.status = QueryStatus::Invalid;
    if (!was_hit || runaway) return false;
    hit.status = inside ? QueryStatus::Inside : QueryStatus::Hit;
    hit.id = found.flags >> 3;
    if (!inside && options_.wishes.lit) hit.lit = found.lit;  // within the solid no light is seen
    if (look) {
        answer.colour = {look->red, look->green, look->blue};
        hit.u = double(look->u);
        hit.v = double(look->v);
    }
    return options_.parts.root;
}

void Engine::describe(Answer& answer, const QueryRay& ray, const layout::QueryHit& found, const Place& place) const {
    const AnswerParts& parts = options_.parts;
    QueryHit& hit = answer.hit;
    const bool inside = hit.status == QueryStatus::Inside;
    const ShapeFrame& shape = shapes_[hit.id - 1];
    hit.t = inside ? ray.t_min : std::clamp(place.t, ray.t_min, ray.t_max);
    answer.device_position = place.position;
    if (parts.position) hit.position = arrayOf(transformPoint(shape.frame_from_device, place.position));
    if (parts.normal) {
        // A displaced sphere's normal belongs to the refined place. A start inside has the device's, being on no
        // surface.
        const bool on_surface = shape.heights && !inside;
        const dvec3 world_normal(found.nx, found.ny, found.nz);
        const dvec3 normal = glm::normalize(on_surface ? shape.frame_from_device_normal * displacedNormal(shape, place)
                                                       : frame_from_world_normal_ * world_normal);
        hit.normal = {float(normal.x), float(normal.y), float(normal.z)};
    }
    if (parts.place && shape.heights) describePlace(hit, shape, place);
}

/// Finds the roots of the batch's hits, which are of one shape.
void Engine::solve(Batch& batch) const {
    if (batch.hit_count == 0) return;
    const ShapeFrame& shape = shapes_[batch.answers[batch.which[0]].hit.id - 1];
    findRoots(batch.places, shape, {batch.hits.data(), batch.hit_count});
    for (std::size_t k = 0; k < batch.hit_count; ++k)
        describe(batch.answers[batch.which[k]], *batch.hits[k].ray, *batch.found[k], batch.places[k]);
    batch.hit_count = 0;
}

std::uint64_t Engine::finishChunk(const Block& block, std::size_t chunk, std::size_t first, const Sink& sink) const {
    static const Answer kNothing;  // a copy from memory takes a fifth of the time that Answer() takes
    const auto hits = block.on_device->hits();
    const auto looks = block.on_device->looks();
    std::uint64_t runaways = 0;
    Batch batch;
    batch.begin = first + chunk * SentRays::kChunk;
    const auto handOn = [&] {
        solve(batch);
        sink(batch.begin, {batch.answers.data(), batch.count});
        batch.begin += batch.count;
        batch.count = 0;
    };
    block.sent.forEach(chunk, [&](SentRays::Fate fate, const QueryRay& ray, std::uint32_t place) {
        const std::size_t i = batch.count++;
        Answer& answer = batch.answers[i];
        if (answer.hit.status != QueryStatus::Miss) answer = kNothing;  // of the batch before
        if (fate == SentRays::Fate::Invalid) answer.hit.status = QueryStatus::Invalid;
        if (fate == SentRays::Fate::Sent) runaways += hits[place].flags >> 2 & 1u;
        if (fate == SentRays::Fate::Sent &&
            fill(answer, hits[place], options_.wishes.looks() ? &looks[place] : nullptr)) {
            if (answer.hit.status == QueryStatus::Inside) {
                Place start;
                findPlaceAt(start, shapes_[answer.hit.id - 1], ray, ray.t_min);
                describe(answer, ray, hits[place], start);
            } else {
                const bool another = batch.hit_count > 0 && batch.answers[batch.which[0]].hit.id != answer.hit.id;
                if (another) solve(batch);
                const std::size_t k = batch.hit_count++;
                batch.which[k] = std::uint8_t(i);
                batch.found[k] = &hits[place];
                batch.hits[k] = {&ray, dvec3(hits[place].px, hits[place].py, hits[place].pz)};
            }
        }
        if (batch.count == Batch::kMost) handOn();
    });
    if (batch.count > 0) handOn();
    return runaways;
}

void Engine::finish(const Block& block, std::size_t first, const Sink& sink) {
    std::atomic<std::uint64_t> runaways = 0;
    parallelFor(block.sent.chunks(), [&](std::size_t chunk) { runaways += finishChunk(block, chunk, first, sink); });
    runaways_ += runaways;
}

void Engine::traceBatches(std::size_t count, const RaySource& source, const Sink& sink) {
    const std::size_t blocks = (count + capacity_ - 1) / capacity_;
    const auto packBlock = [&](std::size_t b) {
        pack(blocks_[b % 2], b * capacity_, std::min<std::size_t>(capacity_, count - b * capacity_), source);
    };
    if (blocks > 0) packBlock(0);
    for (std::size_t b = 0; b <= blocks; ++b) {
        if (options_.between_blocks) options_.between_blocks();
        std::future<void> tracing;
        if (b < blocks)
            tracing = std::async(std::launch::async, [this, b, &block = blocks_[b % 2]] {
                block.on_device->trace(block.count, std::uint32_t(traced_ + b * capacity_), seed_);
            });
        if (b > 0) finish(blocks_[(b - 1) % 2], (b - 1) * capacity_, sink);
        if (b + 1 < blocks) packBlock(b + 1);
        if (tracing.valid()) tracing.get();
    }
    traced_ += count;
}

}  // namespace dsphere::query
