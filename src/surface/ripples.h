#pragma once

#include "surface/heightmap.h"
#include "surface/interval.h"

namespace dsphere {

/// The first sine's argument at a longitude in radians: 2 pi u_frequency u, u as the map's longitude origin shifts it.
/// The second's is v_frequency times the colatitude.
double ripplePhase(const Heightmap& map, double longitude);

/// Least and greatest h over a box of longitude and colatitude, radians: exact but for rounding.
Interval rippleRange(const Heightmap& map, const Interval& longitude, const Interval& colatitude);

/// At least the greatest slope of h over such a box, on a sphere of radius 1, per radian of arc.
double steepestRipple(const Heightmap& map, const Interval& longitude, const Interval& colatitude);

}  // namespace dsphere
