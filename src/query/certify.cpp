#include "query/certify.h"

#include "verify/nearby.h"

#include <cmath>

namespace dsphere::query {

namespace {

dvec3 vectorOf(const std::array<double, 3>& v) {
    return {v[0], v[1], v[2]};
}

}  // namespace

Certifier::Certifier(const Scene& scene, const SceneMaps& maps, Frame frame, bool wants_tangent)
    : scene_(scene),
      comparison_(scene, maps),
      world_from_frame_(frame == Frame::World ? dmat4(1.0) : scene.shapes[bodyOf(scene)].world_from_object),
      wants_tangent_(wants_tangent) {}

// A shape counts as far as it is met, or nearly so, before the first hit.
bool Certifier::isTangent(const verify::WorldRay& ray, const reference::WorldHit& truth) const {
    const reference::Tracer& tracer = comparison_.tracer();
    for (int k = 0; k < int(scene_.shapes.size()); ++k) {
        reference::Ray object_ray = tracer.objectRay(k, ray.origin, ray.direction);
        object_ray.t_max = ray.t_max;
        if (const reference::Surface* surface = tracer.surface(k)) {
            const reference::FirstHit hit = reference::classify(*surface, object_ray);
            const double t = hit.hit ? hit.t() : hit.least_t;
            const bool hidden = truth.hit && k != truth.shape && t > truth.t();
            if (hit.verdict == reference::Verdict::Tangent && !hidden) return true;
            continue;
        }
        const reference::FirstHit hit = tracer.hitShape(k, object_ray);
        for (const dvec3& offset : verify::ringOffsets(object_ray.direction, reference::kSideways * tracer.unit(k))) {
            const reference::FirstHit moved = tracer.hitShape(k, reference::movedSideways(object_ray, offset));
            const bool hidden = truth.hit && k != truth.shape && std::min(hit.t(), moved.t()) > truth.t();
            if (moved.hit != hit.hit && !hidden) return true;
        }
    }
    return false;
}

Truth Certifier::check(std::uint64_t index, const QueryRay& ray, const Answer& answer) {
    Truth result;
    if (!isValid(ray) || !(ray.t_min < ray.t_max)) return result;
    // The reference takes world rays of unit directions that begin at their origin. Scaled first: a short direction's
    // square would be 0.
    const dvec3 given_direction = vectorOf(ray.direction);
    const double scale =
        std::max({std::abs(given_direction.x), std::abs(given_direction.y), std::abs(given_direction.z)});
    const dvec3 scaled = transformVector(world_from_frame_, given_direction / scale);
    const dvec3 direction = scaled / glm::length(scaled);
    const double length = glm::length(scaled) * scale;
    const dvec3 origin = transformPoint(world_from_frame_, vectorOf(ray.origin));
    const verify::WorldRay world{.origin = origin + ray.t_min * length * direction,
                                 .direction = direction,
                                 .t_max = length * (ray.t_max - ray.t_min),
                                 .rounded_ends = true};
    const QueryHit& hit = answer.hit;
    verify::Answer given;
    given.hit = hit.id != 0;
    if (given.hit) {
        given.inside = hit.status == QueryStatus::Inside;
        given.shape = int(hit.id) - 1;
        given.t = given.inside ? 0.0 : length * (hit.t - ray.t_min);
        given.object_position = comparison_.objectPoint(given.shape, answer.device_position);
        const dvec3 normal(hit.normal[0], hit.normal[1], hit.normal[2]);
        given.normal = glm::normalize(transformNormal(glm::inverse(world_from_frame_), normal));
    }
    verify::Report part;
    if (given.hit && !std::isfinite(hit.t + hit.position[0] + hit.position[1] + hit.position[2])) {
        ++part.not_finite;
        part.addFault(index, "an answer that is not finite");
    }
    const reference::WorldHit truth = comparison_.checkHit(part, index, world, given);
    if (truth.hit) {
        result.t_low = ray.t_min + truth.t_low / length;
        result.t_high = ray.t_min + truth.t_high / length;
    }
    if (wants_tangent_) result.tangent = isTangent(world, truth);
    result.wrong = !part.faults.empty();
    const std::lock_guard lock(mutex_);
    report_.merge(std::move(part));
    return result;
}

std::vector<std::string> Certifier::violations() const {
    verify::Report report = report_;
    report.tangent = 0;
    return report.violations();
}

}  // namespace dsphere::query
