#include "surface/ripples.h"

#include "base/math.h"

#include <algorithm>
#include <cmath>

namespace dsphere {

namespace {

// From its ends and the crests and troughs in between.
Interval sineRange(const Interval& x) {
    double a = std::sin(x.low), b = std::sin(x.high);
    auto holds = [&](double extreme) {
        return extreme + 2.0 * kPi * std::ceil((x.low - extreme) / (2.0 * kPi)) <= x.high;
    };
    return {holds(-0.5 * kPi) ? -1.0 : std::min(a, b), holds(0.5 * kPi) ? 1.0 : std::max(a, b)};
}

}  // namespace

double ripplePhase(const Heightmap& map, double longitude) {
    return map.ripples->u_frequency * (longitude + kPi - glm::radians(map.longitude_origin + 180.0));
}

Interval rippleRange(const Heightmap& map, const Interval& longitude, const Interval& colatitude) {
    double v_frequency = map.ripples->v_frequency;
    Interval u = sineRange({ripplePhase(map, longitude.low), ripplePhase(map, longitude.high)});
    Interval v = sineRange({v_frequency * colatitude.low, v_frequency * colatitude.high});
    double a = u.low * v.low, b = u.low * v.high, c = u.high * v.low, d = u.high * v.high;
    return {0.5 + 0.5 * std::min({a, b, c, d}), 0.5 + 0.5 * std::max({a, b, c, d})};
}

}  // namespace dsphere
