#pragma once

#include "reference/line.h"

#include <algorithm>
#include <cmath>

namespace dsphere::reference {

/// Cuts s0..s1 to the part of the line within `radius` of the centre; false if nothing is left.
inline bool clipToBall(const Line& line, double radius, double& s0, double& s1) {
    const double distance = double(line.distance);
    if (!(distance < radius)) return false;
    // |p|^2 = |c|^2 + s^2: the ray is below the radius only for s^2 < (radius - |c|)(radius + |c|).
    const double half = std::sqrt((radius - distance) * (radius + distance));
    s0 = std::max(s0, -half);
    s1 = std::min(s1, half);
    return s0 <= s1;
}

}  // namespace dsphere::reference
