#include "query/refine.h"

#include <algorithm>
#include <cmath>

namespace dsphere::query {

namespace {

// The contract's bound of the error along a ray, with what the rounding of the position adds.
constexpr double kFarthestMove = 1.5e-6;
constexpr double kGoodEnough = 1e-12;  // R
// A place that has moved by less, this far from the axis at least, has the angles that a tangent to the sphere gives:
// right to the square of their quotient.
constexpr double kShortMove = 1e-6, kFarFromAxis2 = 0.01;

void findAngles(const ShapeFrame& shape, Place& place) {
    const dvec3& p = place.position;
    place.longitude = std::atan2(p.x, p.z);
    place.colatitude = std::atan2(std::sqrt(p.x * p.x + p.z * p.z), p.y);
    place.height = shape.heights->at(place.longitude, place.colatitude);
}

Place movedTo(const ShapeFrame& shape, const DeviceRay& ray, const Place& from, double s) {
    Place place = from;
    place.s = s;
    place.position = ray.point + s * ray.direction;
    const dvec3& p = from.position;
    const dvec3 step = place.position - p;
    const double rho2 = p.x * p.x + p.z * p.z;
    if (!(rho2 > kFarFromAxis2 && glm::dot(step, step) < kShortMove * kShortMove)) {
        findAngles(shape, place);
        return place;
    }
    const double rho = std::sqrt(rho2), outward = (p.x * step.x + p.z * step.z) / rho;
    place.longitude += (p.z * step.x - p.x * step.z) / rho2;
    place.colatitude += (p.y * outward - rho * step.y) / glm::dot(p, p);
    place.height = shape.heights->at(place.longitude, place.colatitude);
    return place;
}

// |p| - r in units of R.
double excess(const ShapeFrame& shape, const Place& place) {
    return glm::length(place.position) - (shape.relief.base + shape.relief.scale * place.height.stored) / shape.unit;
}

// Newton with the device's own slope, which is right to some 1e-5: each step leaves that share of what was off.
Place displacedRoot(const ShapeFrame& shape, const DeviceRay& ray, const Place& found, const dvec3& normal) {
    const double across = glm::dot(normal, ray.direction);
    const double rate = across * glm::length(found.position) / glm::dot(normal, found.position);
    const double reach = kFarthestMove * glm::length(normal) / std::max(std::abs(across), 1e-30);
    Place best = found;
    double off = excess(shape, best);
    for (int i = 0; i < 3 && std::abs(off) > kGoodEnough; ++i) {
        const double s = best.s - off / rate;
        if (!(std::abs(s - found.s) <= reach)) break;
        const Place next = movedTo(shape, ray, best, s);
        const double left = excess(shape, next);
        if (!(std::abs(left) < std::abs(off))) break;
        best = next;
        off = left;
    }
    return best;
}

double plainRoot(const ShapeFrame& shape, const DeviceRay& ray, double s) {
    double root = s;
    if (std::holds_alternative<Sphere>(*shape.geometry))
        root = -std::sqrt(1.0 - glm::dot(ray.point, ray.point));
    else if (const auto* disk = std::get_if<Disk>(shape.geometry))
        root = (disk->height / disk->radius - ray.point.z) / ray.direction.z;
    // Only tangent rays are that far off; a root that is none is NaN.
    return std::abs(root - s) < 1e-3 ? root : s;
}

}  // namespace

Place placeAt(const ShapeFrame& shape, const DeviceRay& ray, double s) {
    Place place;
    place.s = s;
    place.position = ray.point + s * ray.direction;
    if (shape.heights) findAngles(shape, place);
    return place;
}

Place refined(const ShapeFrame& shape, const DeviceRay& ray, const dvec3& position, const dvec3& normal) {
    const double s = glm::dot(position, ray.direction);
    if (!shape.heights) return placeAt(shape, ray, plainRoot(shape, ray, s));
    return displacedRoot(shape, ray, placeAt(shape, ray, s), normal);
}

// e_r - k dh/dlon / (r sin colat) e_east - k dh/dcolat / r e_south. Towards a pole dh/dlon vanishes with the sine.
dvec3 displacedNormal(const ShapeFrame& shape, const Place& place) {
    const dvec3& p = place.position;
    const double r = glm::length(p), rho = std::sqrt(p.x * p.x + p.z * p.z);
    if (!(rho > 1e-100)) return dvec3(0.0, p.y < 0.0 ? -1.0 : 1.0, 0.0);
    const double scale = shape.relief.scale / shape.unit;
    const dvec3 east(p.z / rho, 0.0, -p.x / rho), south(p.y * p.x / (r * rho), -rho / r, p.y * p.z / (r * rho));
    return glm::normalize(p / r - scale * place.height.per_longitude / rho * east -
                          scale * place.height.per_colatitude / r * south);
}

void describePlace(QueryHit& hit, const ShapeFrame& shape, const Place& place) {
    hit.u = 0.5 + place.longitude / (2.0 * kPi);
    hit.v = place.colatitude / kPi;
    hit.latitude = 90.0 - glm::degrees(place.colatitude);
    hit.longitude = glm::degrees(place.longitude);
    hit.height = place.height.stored;
    if (shape.facts->unit == "m") hit.metres = shape.facts->heightOf(hit.height);
}

}  // namespace dsphere::query
