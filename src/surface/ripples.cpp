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

double greatestSize(const Interval& x) {
    return std::max(std::abs(x.low), std::abs(x.high));
}

Interval cosineRange(const Interval& x) {
    return sineRange({x.low + 0.5 * kPi, x.high + 0.5 * kPi});
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

// Eastward h changes by half u_frequency |cos u| |sin v| over the sine of the colatitude; at the poles, where both
// sines vanish, v_frequency times an angle over its sine, at most pi / 2 up to the equator, bounds their quotient.
double steepestRipple(const Heightmap& map, const Interval& longitude, const Interval& colatitude) {
    const double u_frequency = map.ripples->u_frequency, v_frequency = map.ripples->v_frequency;
    const Interval u{ripplePhase(map, longitude.low), ripplePhase(map, longitude.high)};
    const Interval v{v_frequency * colatitude.low, v_frequency * colatitude.high};
    const double sine = std::min(std::sin(colatitude.low), std::sin(colatitude.high));
    const double quotient = std::min(greatestSize(sineRange(v)) / std::max(sine, 1e-9), 0.5 * kPi * v_frequency);
    return 0.5 * std::hypot(u_frequency * greatestSize(cosineRange(u)) * quotient,
                            v_frequency * greatestSize(sineRange(u)) * greatestSize(cosineRange(v)));
}

}  // namespace dsphere
