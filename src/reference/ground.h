#pragma once

// Where a point stands over (or under) the surfaces of a scene.

#include "surface/scenemaps.h"

namespace dsphere::reference {

/// r of a displaced sphere in the direction of w, which is not 0; object units. Reads one patch of the map.
double radiusTowards(const Heightmap& map, const Relief& relief, const dvec3& w);

/// A warning if the scene's eye lies in the solid of a sphere or displaced sphere, which makes the picture black; none
/// otherwise. `maps` are the scene's own.
Notices warnOfBuriedEye(const Scene& scene, const SceneMaps& maps);

}  // namespace dsphere::reference
