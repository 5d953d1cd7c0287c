#pragma once

#include <cmath>

namespace dsphere {

/// The light that an sRGB code of 0 to 1 means, 0 to 1 (IEC 61966-2-1).
inline double linearFromSrgb(double code) {
    return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}

/// The sRGB code of light of 0 to 1, 0 to 1.
inline double srgbFromLinear(double light) {
    return light <= 0.0031308 ? 12.92 * light : 1.055 * std::pow(light, 1.0 / 2.4) - 0.055;
}

}  // namespace dsphere
