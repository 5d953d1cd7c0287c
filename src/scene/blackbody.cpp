#include "scene/blackbody.h"

#include <cmath>

namespace dsphere {

namespace {

// The CIE 1931 2 degree standard observer, 380 to 780 nm in steps of 10 (CIE 015: x, y and z of equal energy).
constexpr double kObserver[][3] = {
    {0.0014, 0.0000, 0.0065}, {0.0042, 0.0001, 0.0201}, {0.0143, 0.0004, 0.0679}, {0.0435, 0.0012, 0.2074},
    {0.1344, 0.0040, 0.6456}, {0.2839, 0.0116, 1.3856}, {0.3483, 0.0230, 1.7471}, {0.3362, 0.0380, 1.7721},
    {0.2908, 0.0600, 1.6692}, {0.1954, 0.0910, 1.2876}, {0.0956, 0.1390, 0.8130}, {0.0320, 0.2080, 0.4652},
    {0.0049, 0.3230, 0.2720}, {0.0093, 0.5030, 0.1582}, {0.0633, 0.7100, 0.0782}, {0.1655, 0.8620, 0.0422},
    {0.2904, 0.9540, 0.0203}, {0.4334, 0.9950, 0.0087}, {0.5945, 0.9950, 0.0039}, {0.7621, 0.9520, 0.0021},
    {0.9163, 0.8700, 0.0017}, {1.0263, 0.7570, 0.0011}, {1.0622, 0.6310, 0.0008}, {1.0026, 0.5030, 0.0003},
    {0.8544, 0.3810, 0.0002}, {0.6424, 0.2650, 0.0000}, {0.4479, 0.1750, 0.0000}, {0.2835, 0.1070, 0.0000},
    {0.1649, 0.0610, 0.0000}, {0.0874, 0.0320, 0.0000}, {0.0468, 0.0170, 0.0000}, {0.0227, 0.0082, 0.0000},
    {0.0114, 0.0041, 0.0000}, {0.0058, 0.0021, 0.0000}, {0.0029, 0.0010, 0.0000}, {0.0014, 0.0005, 0.0000},
    {0.0007, 0.0002, 0.0000}, {0.0003, 0.0001, 0.0000}, {0.0002, 0.0001, 0.0000}, {0.0001, 0.0000, 0.0000},
    {0.0000, 0.0000, 0.0000}};

constexpr double kSecondRadiation = 1.438777e7;  // h c / k in nm K
constexpr double kWien = 2.897772e6;             // wavelength of the peak times temperature, nm K

// Planck's law but for a constant factor; the wavelength in nm.
double planck(double wavelength, double kelvin) {
    return std::pow(wavelength / 500.0, -5.0) / std::expm1(kSecondRadiation / (wavelength * kelvin));
}

// Of the spectrum divided by `unit`; equal energy of 1 has luminance 1.
dvec3 xyz(double kelvin, double unit) {
    dvec3 sum(0.0);
    double luminance = 0.0, wavelength = 380.0;
    for (const auto& [x, y, z] : kObserver) {
        sum += dvec3(x, y, z) * (planck(wavelength, kelvin) / unit);
        luminance += y;
        wavelength += 10.0;
    }
    return sum / luminance;
}

// IEC 61966-2-1.
dvec3 srgb(const dvec3& xyz) {
    const dvec3 rgb(3.2406 * xyz.x - 1.5372 * xyz.y - 0.4986 * xyz.z, -0.9689 * xyz.x + 1.8758 * xyz.y + 0.0415 * xyz.z,
                    0.0557 * xyz.x - 0.2040 * xyz.y + 1.0570 * xyz.z);
    return glm::max(rgb, dvec3(0.0));
}

}  // namespace

dvec3 blackbodyOfLuminance1(double kelvin) {
    const dvec3 colour = xyz(kelvin, planck(kWien / kelvin, kelvin));
    return srgb(colour / colour.y);
}

dvec3 blackbodyOfPeak1(double kelvin) {
    return srgb(xyz(kelvin, planck(kWien / kelvin, kelvin)));
}

}  // namespace dsphere
