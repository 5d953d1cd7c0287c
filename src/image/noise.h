#pragma once

// Noise that is the same on every machine: integer hashes, no library distributions.

#include "base/math.h"

#include <cstdint>

namespace dsphere {

/// A hash of the lattice point and the seed, uniform in [0, 1).
double latticeNoise(int x, int y, int z, std::uint32_t seed);

/// Noise in [0, 1) that is latticeNoise at whole points and smooth between them; its features are about 1 wide.
double valueNoise(const dvec3& point, std::uint32_t seed);

/// t^2 (3 - 2 t): 0 at 0, 1 at 1, level at both.
inline double smoothStep(double t) {
    return t * t * (3.0 - 2.0 * t);
}

}  // namespace dsphere
