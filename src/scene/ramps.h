#pragma once

// Colour ramps of the heightramp texture: piecewise linear between control points that stand at equal distances.

#include "base/math.h"

#include <array>
#include <string_view>
#include <vector>

namespace dsphere {

inline constexpr int kRampPoints = 17;

struct Ramp {
    std::string_view name;
    std::array<dvec3, kRampPoints> points;  ///< linear RGB, first at 0, last at 1
};

/// All ramps, in a fixed order: terrain, viridis, geoid, grey.
const std::vector<Ramp>& ramps();

/// The index in ramps() of that name, or -1.
int findRamp(std::string_view name);

/// The ramp's colour at x, clamped to [0, 1]; NaN gives the first colour.
dvec3 rampColour(const Ramp& ramp, double x);

}  // namespace dsphere
