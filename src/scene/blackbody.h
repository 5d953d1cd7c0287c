#pragma once

#include "base/math.h"

namespace dsphere {

/// Linear sRGB of a black body's light, by Planck's law and the CIE's standard observer of 1931. `kelvin` is in 500 to
/// 100000. A component below 0, of a red outside sRGB under some 1900 K, counts as 0.
///
/// pbrt v4 normalises a light's spectrum to luminance 1.
dvec3 blackbodyOfLuminance1(double kelvin);
/// pbrt v3 normalises the spectrum to 1 at its greatest wavelength, visible or not.
dvec3 blackbodyOfPeak1(double kelvin);

}  // namespace dsphere
