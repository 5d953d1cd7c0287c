#include "query/refine.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dsphere::query {

namespace {

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

/// How all changes along a line at a place of it, per t, in units of R.
struct Change {
    double axis_distance;
    double excess;                                 ///< |p| - r
    double longitude_rate, colatitude_rate, rate;  ///< of longitude, colatitude and excess
    double steepness2;                             ///< squared: how excess grows straight away from the surface, per R
};

// Fills what it is given, for several million rays a second: a struct that is copied right after its numbers were
// written has to wait for them.
void lookBelow(Place& place, Change& change, const ShapeFrame& shape, const dvec3& p, double t,
               const dvec3& direction) {
    const double rho2 = p.x * p.x + p.z * p.z, rho = std::sqrt(rho2), r2 = rho2 + p.y * p.y, r = std::sqrt(r2);
    place.t = t;
    place.position = p;
    place.longitude = std::atan2(p.x, p.z);
    place.colatitude = std::atan2(rho, p.y);
    const HeightSample ground = shape.heights->at(place.longitude, place.colatitude);
    place.height = ground;
    change.axis_distance = rho;
    change.excess = r - (shape.base + shape.scale * ground.value);
    const double inverse_rho = 1.0 / std::max(rho, 1e-100), inverse_r2 = 1.0 / r2;
    const double outward = (p.x * direction.x + p.z * direction.z) * inverse_rho;
    change.longitude_rate = (p.z * direction.x - p.x * direction.z) * inverse_rho * inverse_rho;
    change.colatitude_rate = (p.y * outward - rho * direction.y) * inverse_r2;
    change.rate =
        glm::dot(p, direction) * r * inverse_r2 -
        shape.scale * (ground.per_longitude * change.longitude_rate + ground.per_colatitude * change.colatitude_rate);
    const double east = shape.scale * ground.per_longitude * inverse_rho, south = shape.scale * ground.per_colatitude;
    change.steepness2 = 1.0 + east * east + south * south * inverse_r2;
}

/// Goes a short step along the line, on the same patch: nothing has to be looked up. False where more has to be done.
bool stepOnPatch(Place& place, const ShapeFrame& shape, const Line& line, const Change& change, double step) {
    const double near = kShortMove * change.axis_distance;
    if (!(step * step * line.square < near * near)) return false;
    const double east = change.longitude_rate * step, south = change.colatitude_rate * step;
    const double twist = place.height.mixed * east * south;
    if (!(std::abs(twist * shape.scale) < kGoodEnough)) return false;
    if (!shape.heights->onOnePatch(place.longitude, place.colatitude, place.longitude + east, place.colatitude + south))
        return false;
    place.t += step;
    place.position += step * line.direction;
    place.longitude += east;
    place.colatitude += south;
    place.height.value += place.height.per_longitude * east + place.height.per_colatitude * south + twist;
    return true;
}

// Newton. A step that stays on a bilinear patch is the last one: along it the ground is a line but for its twist.
void findDisplacedRoot(Place& place, const ShapeFrame& shape, const Line& line, const dvec3& found) {
    const double begin = glm::dot(found - line.origin, line.direction) / line.square;
    const dvec3 base = line.origin + begin * line.direction;  // what moves are added to: the origin may be far away
    Change change;
    lookBelow(place, change, shape, base, begin, line.direction);
    const double across2 = change.rate * change.rate / change.steepness2;  // squared: what of a move leaves the surface
    double move = 0.0;
    for (int turn = 0; turn < 4; ++turn) {
        const double step = -change.excess / change.rate, moved = move + step;
        if (std::abs(change.excess) <= kGoodEnough || !(moved * moved * across2 <= kFarthestMove * kFarthestMove))
            return;
        if (stepOnPatch(place, shape, line, change, step)) return;
        move = moved;
        Place next;
        Change next_change;
        lookBelow(next, next_change, shape, base + move * line.direction, begin + move, line.direction);
        if (!(std::abs(next_change.excess) < std::abs(change.excess))) return;
        place = next;
        change = next_change;
    }
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

void findPlaceAt(Place& place, const ShapeFrame& shape, const QueryRay& ray, double t) {
    const ShapeLine line(shape, ray);
    const dvec3 p = line.origin + t * line.direction;
    place.t = t;
    place.position = p;
    Change ignored;
    if (shape.heights) lookBelow(place, ignored, shape, p, t, line.direction);
}

void findRoot(Place& place, const ShapeFrame& shape, const QueryRay& ray, const dvec3& position) {
    if (shape.heights) {
        const Line line(shape, ray);
        findDisplacedRoot(place, shape, line, position);
        if (line.scale != 1.0) place.t /= line.scale;
        return;
    }
    const DeviceRay from_nearest = deviceRay(shape, ray);
    const double s = plainRoot(shape, from_nearest, glm::dot(position, from_nearest.direction));
    place.t = (s - from_nearest.origin) / from_nearest.length;
    place.position = from_nearest.point + s * from_nearest.direction;
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
    hit.height = shape.heights->map().stored(place.height.value);
    if (shape.facts->unit == "m") hit.metres = shape.facts->heightOf(hit.height);
}

}  // namespace dsphere::query
