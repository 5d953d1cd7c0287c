#include "query/refine.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dsphere::query {

namespace {

// The contract's bound of the error along a ray, with what the rounding of the position adds.
constexpr double kFarthestMove = 1.5e-6;
constexpr double kGoodEnough = 1e-12;  // R
// A place that has moved by less, in distances from the axis, has the angles that a tangent to the sphere gives: right
// to the square of that.
constexpr double kShortMove = 3e-7;

/// A line in a shape's space on the device. Directions whose squares would overflow or vanish are scaled.
struct Line {
    dvec3 origin, direction;
    double scale = 1.0, square;  ///< of the direction

    Line(const ShapeFrame& shape, const QueryRay& ray) {
        const ShapeLine own(shape, ray);
        origin = own.origin;
        direction = own.direction;
        square = glm::dot(direction, direction);
        if (square > 1e-200 && square < 1e200) return;
        scale = std::max({std::abs(direction.x), std::abs(direction.y), std::abs(direction.z)});
        direction /= scale;
        square = glm::dot(direction, direction);
    }
};

/// The ground below a point of a line, and how all changes along it, in units of R.
struct Ground {
    HeightSample sample;
    double longitude, colatitude;
    double axis_distance;
    double excess;                                 ///< |p| - r
    double longitude_rate, colatitude_rate, rate;  ///< of longitude, colatitude and excess, per t
};

Ground groundBelow(const ShapeFrame& shape, const dvec3& p, const dvec3& direction) {
    Ground ground;
    const double rho2 = p.x * p.x + p.z * p.z, rho = std::sqrt(rho2), r2 = rho2 + p.y * p.y, r = std::sqrt(r2);
    ground.longitude = std::atan2(p.x, p.z);
    ground.colatitude = std::atan2(rho, p.y);
    ground.sample = shape.heights->at(ground.longitude, ground.colatitude);
    ground.axis_distance = rho;
    ground.excess = r - (shape.base + shape.scale * ground.sample.stored);
    const double inverse_rho = 1.0 / std::max(rho, 1e-100), inverse_r2 = 1.0 / r2;
    const double outward = (p.x * direction.x + p.z * direction.z) * inverse_rho;
    ground.longitude_rate = (p.z * direction.x - p.x * direction.z) * inverse_rho * inverse_rho;
    ground.colatitude_rate = (p.y * outward - rho * direction.y) * inverse_r2;
    ground.rate =
        glm::dot(p, direction) * r * inverse_r2 - shape.scale * (ground.sample.per_longitude * ground.longitude_rate +
                                                                 ground.sample.per_colatitude * ground.colatitude_rate);
    return ground;
}

Place placeOf(const Ground& ground, const dvec3& position, double t) {
    return {t, position, ground.longitude, ground.colatitude, ground.sample};
}

/// The end of a short step from there, on the same patch: nothing has to be looked up. False where more has to be done.
bool stepOnPatch(Place& place, const ShapeFrame& shape, const Line& line, const Ground& ground, double step) {
    const double near = kShortMove * ground.axis_distance;
    if (!(step * step * line.square < near * near)) return false;
    const double east = ground.longitude_rate * step, south = ground.colatitude_rate * step;
    const double twist = ground.sample.mixed * east * south;
    if (!(std::abs(twist * shape.scale) < kGoodEnough)) return false;
    if (!shape.heights->onOnePatch(ground.longitude, ground.colatitude, ground.longitude + east,
                                   ground.colatitude + south))
        return false;
    place.t += step;
    place.position += step * line.direction;
    place.longitude += east;
    place.colatitude += south;
    place.height.stored += ground.sample.per_longitude * east + ground.sample.per_colatitude * south + twist;
    return true;
}

// Newton. A step that stays on a bilinear patch is the last one: along it the ground is a line but for its twist.
Place displacedRoot(const ShapeFrame& shape, const Line& line, const dvec3& found, const dvec3& normal) {
    const double across = glm::dot(normal, line.direction);  // what of a move along the line leaves the surface
    const double farthest2 = kFarthestMove * kFarthestMove * glm::dot(normal, normal);
    const double begin = glm::dot(found - line.origin, line.direction) / line.square;
    const dvec3 base = line.origin + begin * line.direction;  // what moves are added to: the origin may be far away
    Place best;
    double least = std::numeric_limits<double>::infinity(), move = 0.0;
    for (int turn = 0; turn < 4; ++turn) {
        const dvec3 p = base + move * line.direction;
        const Ground ground = groundBelow(shape, p, line.direction);
        if (!(std::abs(ground.excess) < least)) break;
        best = placeOf(ground, p, begin + move);
        least = std::abs(ground.excess);
        const double step = -ground.excess / ground.rate, away = (move + step) * across;
        if (least <= kGoodEnough || !(away * away <= farthest2)) break;
        if (stepOnPatch(best, shape, line, ground, step)) break;
        move += step;
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

Place placeAt(const ShapeFrame& shape, const QueryRay& ray, double t) {
    const ShapeLine line(shape, ray);
    const dvec3 p = line.origin + t * line.direction;
    if (shape.heights) return placeOf(groundBelow(shape, p, line.direction), p, t);
    Place place;
    place.t = t;
    place.position = p;
    return place;
}

Place refined(const ShapeFrame& shape, const QueryRay& ray, const dvec3& position, const dvec3& normal) {
    if (shape.heights) {
        const Line line(shape, ray);
        Place place = displacedRoot(shape, line, position, normal);
        if (line.scale != 1.0) place.t /= line.scale;
        return place;
    }
    const DeviceRay from_nearest = deviceRay(shape, ray);
    Place place;
    const double s = plainRoot(shape, from_nearest, glm::dot(position, from_nearest.direction));
    place.t = (s - from_nearest.origin) / from_nearest.length;
    place.position = from_nearest.point + s * from_nearest.direction;
    return place;
}

// e_r - k dh/dlon / (r sin colat) e_east - k dh/dcolat / r e_south. Towards a pole dh/dlon vanishes with the sine.
dvec3 displacedNormal(const ShapeFrame& shape, const Place& place) {
    const dvec3& p = place.position;
    const double r = glm::length(p), rho = std::sqrt(p.x * p.x + p.z * p.z);
    if (!(rho > 1e-100)) return dvec3(0.0, p.y < 0.0 ? -1.0 : 1.0, 0.0);
    const dvec3 east(p.z / rho, 0.0, -p.x / rho), south(p.y * p.x / (r * rho), -rho / r, p.y * p.z / (r * rho));
    return p / r - shape.scale * (place.height.per_longitude / rho * east + place.height.per_colatitude / r * south);
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
