// Tangency, by tracing the rays beside a ray.

#include "reference/firsthit.h"
#include "reference/search.h"
#include "reference/shellclip.h"

#include <algorithm>
#include <cmath>

namespace dsphere::reference {

namespace {

constexpr int kDirections = 16;
constexpr int kHalvings = 10;
constexpr double kFarAway = 1e100;  // in R: squares of greater lengths would overflow

/// The least f over the part of the ray that can hold it: f >= |p| - R, so once f(s) is known anywhere, nothing farther
/// from the centre than f(s) + R counts.
Least leastAlong(const Surface& surface, const Line& line) {
    const Chord chord(surface, line);
    const double start = std::clamp(0.0, line.s_begin, line.s_end);
    double s0 = line.s_begin, s1 = line.s_end;
    const double reach = (surface.greatestRadius() + std::max(chord.f(start), 0.0)) * (1.0 + 1e-9);
    if (!clipToBall(line, reach, s0, s1)) return {start, chord.f(start)};
    return leastOnChord(chord, s0, s1);
}

dvec3 perpendicular(const dvec3& v, const dvec3& unit) {
    return v - glm::dot(v, unit) * unit;
}

std::vector<dvec3> sidewaysOffsets(const dvec3& direction, const dvec3& normal, double step) {
    const dvec3 d = direction / double(glm::length(direction));
    const dvec3 a = std::abs(d.x) < 0.6 ? dvec3(1.0, 0.0, 0.0) : dvec3(0.0, 1.0, 0.0);
    const dvec3 e = glm::normalize(perpendicular(a, d)), g = glm::cross(d, e);
    std::vector<dvec3> offsets;
    auto add = [&](const dvec3& unit) {
        offsets.push_back(step * unit);
        offsets.push_back(0.5 * step * unit);
    };
    for (int k = 0; k < kDirections; ++k) {
        const double angle = 2.0 * kPi * k / kDirections;
        add(std::cos(angle) * e + std::sin(angle) * g);
    }
    const dvec3 across = perpendicular(normal, d);
    const double length = glm::length(across);
    if (length > 0.0) {
        add(across / length);
        add(-across / length);
    }
    return offsets;
}

/// The ray's direction scaled so that its length neither overflows nor underflows.
dvec3 scaledDirection(const dvec3& direction) {
    return direction / std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
}

std::vector<dvec3> offsetsOf(const Surface& surface, const Ray& ray, const FirstHit& hit, const Line& line) {
    const double step = kSideways * surface.greatestRadius();
    const dvec3 direction = scaledDirection(ray.direction);
    if (!hit.hit && !std::isfinite(hit.least_f)) return sidewaysOffsets(direction, dvec3(0.0), step);
    const dvec3 p = hit.hit ? hit.position : line.at(double(line.origin_s + line.length * hit.least_t));
    const bool at_centre = p == dvec3(0.0);
    return sidewaysOffsets(direction, at_centre ? dvec3(0.0) : surface.normal(p), step);
}

/// Whether the root jumps somewhere between the ray and the moved one: the gap between their roots is followed into the
/// half of the move that holds more of it. A root that moves steadily leaves a gap that shrinks at least like the root
/// of the move: 32-fold in ten halvings.
bool jumps(const Surface& surface, const Ray& ray, const dvec3& offset, double t_ray, double t_moved, double smooth) {
    const double gap = std::abs(t_moved - t_ray);
    if (gap <= smooth) return false;
    double near = 0.0, far = 1.0;
    for (int k = 0; k < kHalvings; ++k) {
        const double half = 0.5 * (near + far);
        const FirstHit hit = firstHit(surface, movedSideways(ray, half * offset));
        if (!hit.hit) return true;
        const double t = hit.t();
        if (std::abs(t - t_ray) > std::abs(t_moved - t)) {
            far = half;
            t_moved = t;
        } else {
            near = half;
            t_ray = t;
        }
    }
    return std::abs(t_moved - t_ray) > gap / 8.0;
}

FirstHit hitAndLeast(const Surface& surface, const Ray& ray, const Line& line) {
    FirstHit hit = firstHit(surface, ray);
    const double nearest = std::clamp(0.0, line.s_begin, line.s_end);
    if (hit.hit || !(line.distance + std::abs(nearest) < kFarAway * surface.greatestRadius())) return hit;
    const Least least = leastAlong(surface, line);
    hit.least_f = least.f;
    hit.least_t = std::clamp(line.tAt(least.s), ray.t_min, ray.t_max);
    return hit;
}

}  // namespace

Ray movedSideways(Ray ray, const dvec3& offset) {
    ray.origin += offset;
    return ray;
}

std::vector<Ray> sidewaysRays(const Surface& surface, const Ray& ray) {
    Line line;
    if (!makeLine(ray, line)) return {};
    std::vector<Ray> rays;
    for (const dvec3& offset : offsetsOf(surface, ray, hitAndLeast(surface, ray, line), line))
        rays.push_back(movedSideways(ray, offset));
    return rays;
}

FirstHit classify(const Surface& surface, const Ray& ray) {
    Line line;
    if (!makeLine(ray, line)) return {};
    FirstHit hit = hitAndLeast(surface, ray, line);
    // No neighbour of such a ray comes near.
    if (line.distance > (1.0 + 2.0 * kSideways) * surface.greatestRadius()) return hit;
    // A sideways step moves a root by about step / |cos|; less than four times that is no jump.
    const double step = kSideways * surface.greatestRadius(), length = double(line.length);
    const double cosine = hit.hit ? std::abs(glm::dot(surface.normal(hit.position), line.d)) : 1.0;
    const double smooth = 4.0 * step / std::max(cosine, 1e-9) / length;
    for (const dvec3& offset : offsetsOf(surface, ray, hit, line)) {
        const FirstHit moved = firstHit(surface, movedSideways(ray, offset));
        if (moved.hit != hit.hit || (hit.hit && jumps(surface, ray, offset, hit.t(), moved.t(), smooth))) {
            hit.verdict = Verdict::Tangent;
            break;
        }
    }
    return hit;
}

}  // namespace dsphere::reference
