#pragma once

#include "query/frames.h"

namespace dsphere::query {

/// Where a hit stands, in the shape's space on the device.
struct Place {
    double t = 0.0;  ///< the ray's own
    dvec3 position{0.0};
    double longitude = 0.0, colatitude = 0.0;  ///< radians, of a displaced sphere: as Interpolator takes them
    HeightSample height;                       ///< there
};

/// The hit of a ray with a shape in double: the root nearest to the one that the device found in single floats at
/// `position`, with the outward `normal` there (not normalised). Never moved farther than the contract's bound, so that
/// it stays the same root; where that does not suffice it stays as the device found it.
Place refined(const ShapeFrame& shape, const QueryRay& ray, const dvec3& position, const dvec3& normal);

/// A place of a ray that is not refined: where one starts.
Place placeAt(const ShapeFrame& shape, const QueryRay& ray, double t);

/// The outward normal of a displaced sphere there, in the shape's space; not normalised.
dvec3 displacedNormal(const ShapeFrame& shape, const Place& place);

/// Fills u, v, latitude, longitude and the heights of a hit of a displaced sphere.
void describePlace(QueryHit& hit, const ShapeFrame& shape, const Place& place);

}  // namespace dsphere::query
