#pragma once

#include "query/frames.h"

namespace dsphere::query {

// The contract's bound of the error along a ray, with what the rounding of the position adds.
inline constexpr double kFarthestMove = 1.5e-6;
inline constexpr double kGoodEnough = 1e-12;  // R
// A place that has moved by less, in distances from the axis, has the angles that a tangent to the sphere gives: right
// to the square of that.
inline constexpr double kShortMove = 3e-7;

/// Where a hit stands, in the shape's space on the device.
struct Place {
    double t = 0.0;  ///< the ray's own
    dvec3 position{0.0};
    double longitude = 0.0, colatitude = 0.0;  ///< radians, of a displaced sphere: as Interpolator takes them
    HeightSample height;                       ///< there
};

/// The hit of a ray with a shape in double: the root nearest to the one that the device found in single floats at
/// `position`. Never moved farther than the contract's bound, so that it stays the same root; where that does not
/// suffice it stays as the device found it.
void findRoot(Place& place, const ShapeFrame& shape, const QueryRay& ray, const dvec3& position);

/// A place of a ray that is not refined: where one starts.
void findPlaceAt(Place& place, const ShapeFrame& shape, const QueryRay& ray, double t);

/// The outward normal of a displaced sphere there, in the shape's space; not normalised.
dvec3 displacedNormal(const ShapeFrame& shape, const Place& place);

/// Fills u, v, latitude, longitude and the heights of a hit of a displaced sphere.
void describePlace(QueryHit& hit, const ShapeFrame& shape, const Place& place);

}  // namespace dsphere::query
