#pragma once

// Heightmaps made by hand, and random rays at them.

#include "reference/ray.h"
#include "surface/heightmap.h"

#include <functional>
#include <random>

namespace dsphere::reference::test {

using Random = std::mt19937_64;

/// A map whose pole values are the means of its first and last rows, which they replace in gridline registration.
Heightmap makeMap(int width, int height, Registration registration, const std::function<double(int, int)>& value,
                  double longitude_origin = -180.0);

/// r = radius (1 + percent / 100 (value - midlevel)): a map of values 0 .. 1.
Relief makeRelief(double radius, double percent, double midlevel = 0.0);

Heightmap flatMap(int width, int height, Registration registration, double value);
Heightmap noiseMap(int width, int height, Registration registration, std::uint64_t seed);
Heightmap checkerboard(int width, int height, Registration registration);
/// Eight octaves of value noise, each half as high and twice as fine as the last.
Heightmap fractalMap(int width, int height, std::uint64_t seed);

/// The unit vector at texture coordinates (u, v).
dvec3 direction(double u, double v);

double uniform(Random& random, double low, double high);
dvec3 randomUnit(Random& random);
/// From a point `distance` away from the centre to a point within `reach` of it.
Ray randomRay(Random& random, double distance, double reach);

}  // namespace dsphere::reference::test
