#include "reference/pathtracer.h"

#include "base/parallel.h"
#include "reference/basis.h"
#include "reference/camera.h"

#include <array>
#include <cmath>
#include <vector>

namespace dsphere::reference {
namespace {

double uniform(PathTracer::Random& random) {
    return std::uniform_real_distribution<double>()(random);
}

dvec2 pairOf(PathTracer::Random& random) {
    const double first = uniform(random);
    return {first, uniform(random)};
}

double balance(double own, double other) {
    return own / (own + other);
}

}  // namespace

/// How a ray came about.
struct PathTracer::Step {
    dvec3 direction;
    double density = 0.0;  ///< of the material's sample; 0: a camera ray or a mirror's, which nothing else samples
    ShadingPoint from;     ///< where, unless density is 0
};

PathTracer::PathTracer(const Scene& scene, const SceneMaps& maps)
    : scene_(&scene),
      filter_(scene.pixel_filter),
      tracer_(scene, maps.perShape(), maps.reliefs, maps.imagePerShape(), maps.lightImage()) {}

// Emission or environment at the end of a ray, less what light samples brought of it.
dvec3 PathTracer::emitted(const WorldHit& hit, const Step& step) const {
    const Lights& lights = tracer_.lights();
    const dvec3 radiance =
        hit.hit ? tracer_.emission(tracer_.shadingPoint(hit, step.direction)) : lights.environment(step.direction);
    if (step.density == 0.0 || radiance == dvec3(0.0)) return radiance;
    double other = 0.0;
    for (int k = 0; k < int(scene_->lights.size()); ++k) {
        const bool infinite = std::holds_alternative<InfiniteLight>(scene_->lights[std::size_t(k)]);
        if (hit.hit ? lights.emitter(k) != hit.shape : !infinite) continue;
        other = lights.density(k, step.from.position, step.from.normals.geometric, step.direction);
    }
    return radiance * balance(step.density, other);
}

dvec3 PathTracer::sampledLights(const ShadingPoint& point, const dvec3& start, Random& random) const {
    const Basis basis(point.normals.smooth);
    const Reflector& reflector = tracer_.reflector(point);
    const dvec3 colour = tracer_.reflectance(point.shape, point.object_position);
    dvec3 sum(0.0);
    for (int k = 0; k < int(scene_->lights.size()); ++k) {
        const LightSample sample = tracer_.lights().sample(k, point.position, point.normals.geometric, pairOf(random));
        if (sample.weight == dvec3(0.0)) continue;
        const dvec3 share = tracer_.reflected(point, sample.direction, colour) * sample.weight;
        if (share == dvec3(0.0) || !tracer_.seen(point, k, sample, start)) continue;
        const double material = reflector.density(basis.toLocal(sample.direction), basis.toLocal(point.towards_viewer));
        sum += share * (isPath() && sample.density > 0.0 ? balance(sample.density, material) : 1.0);
    }
    return sum;
}

dvec3 PathTracer::sample(const dvec3& origin, const dvec3& direction, Random& random) const {
    dvec3 sum(0.0), throughput(1.0);
    Step step{.direction = direction, .from = {}};
    WorldHit hit = tracer_.firstHit(origin, direction);
    bool scattered = false;  // other than by mirrors
    for (int vertex = 0;; ++vertex) {
        if (hit.inside) return sum;
        sum += throughput * emitted(hit, step);
        if (!hit.hit) return sum;
        ShadingPoint point = tracer_.shadingPoint(hit, step.direction);
        point.softened = scattered && scene_->integrator.regularize;
        const Reflector& reflector = tracer_.reflector(point);
        const dvec3 start = tracer_.beside(point);
        const bool last = vertex >= scene_->integrator.max_depth;
        if (!reflector.mirror() && !(isPath() && last)) sum += throughput * sampledLights(point, start, random);
        if (last || !(reflector.mirror() || isPath())) return sum;

        const Basis basis(point.normals.smooth);
        const dvec3 v = basis.toLocal(point.towards_viewer), l = reflector.sample(v, pairOf(random), uniform(random));
        step = {.direction = glm::normalize(basis.toWorld(l)), .density = reflector.density(l, v), .from = point};
        if (!(glm::dot(step.direction, point.normals.geometric) > 0.0)) return sum;
        if (reflector.mirror())
            throughput *= *reflector.mirror();
        else if (step.density > 0.0)
            throughput *= tracer_.reflected(point, step.direction) / step.density;
        else
            return sum;
        if (throughput == dvec3(0.0)) return sum;
        scattered = scattered || !reflector.mirror();
        hit = tracer_.nextHit(point.shape, start, step.direction);
    }
}

Estimate PathTracer::mean(const Box& region, int samples, std::uint64_t seed) const {
    dvec3 sum(0.0), squares(0.0);
    std::vector<std::array<dvec3, 2>> rows(std::size_t(region.height()), {dvec3(0.0), dvec3(0.0)});
    parallelFor(rows.size(), [&](std::size_t row) {
        const int y = region.y0 + int(row);
        std::seed_seq words{std::uint32_t(seed), std::uint32_t(seed >> 32), std::uint32_t(y)};
        Random random(words);
        for (int x = region.x0; x < region.x1; ++x)
            for (int k = 0; k < samples; ++k) {
                const FilterSample in_filter = filter_.sample(random);
                const dvec2 place = dvec2(x + 0.5, y + 0.5) + in_filter.place;
                const CameraRay ray = cameraRay(scene_->camera, scene_->film, place.x, place.y);
                const dvec3 value = in_filter.weight * sample(ray.origin, ray.direction, random);
                rows[row][0] += value;
                rows[row][1] += value * value;
            }
    });
    for (const auto& row : rows) {
        sum += row[0];
        squares += row[1];
    }
    const double count = double(region.width()) * region.height() * samples;
    const dvec3 mean = sum / count;
    return {mean, glm::sqrt(glm::max(squares / count - mean * mean, dvec3(0.0)) / count)};
}

}  // namespace dsphere::reference
