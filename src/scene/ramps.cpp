#include "scene/ramps.h"

#include "base/srgb.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace dsphere {

namespace {

using Codes = std::array<std::uint32_t, kRampPoints>;  // 0xRRGGBB, sRGB

// Hypsometric: sea in the lower half, the shore at 0.5, land above it up to snow.
constexpr Codes kTerrain = {0x0a1a4a, 0x0d2560, 0x113277, 0x16428e, 0x1e55a3, 0x2c6bb5, 0x4486c6, 0x6ba6d8, 0xa5cfe8,
                            0x3f8f4f, 0x6da84f, 0xa9c15a, 0xddc96b, 0xc79a52, 0x9c6b3c, 0xb9a190, 0xffffff};

// S. van der Walt and N. Smith's viridis (2015, CC0): its 256 entries read at 255 i / 16, linear between entries.
constexpr Codes kViridis = {0x440154, 0x48186a, 0x472d7b, 0x424086, 0x3b528b, 0x33638d, 0x2c728e, 0x26818e, 0x21908c,
                            0x1f9f88, 0x28ae80, 0x3ebc74, 0x5dc963, 0x82d34c, 0xabdc32, 0xd5e21a, 0xfde725};

// Blue below, green at the middle, red above, as maps of geoid undulation are coloured.
constexpr Codes kGeoid = {0x0a0a5c, 0x10198a, 0x1230b8, 0x1550dc, 0x1b78ee, 0x1fa0ee, 0x25c4e0, 0x35d8b4, 0x4cd964,
                          0x8edf45, 0xc8e337, 0xf3dc32, 0xfab92b, 0xf79225, 0xec6420, 0xd6331b, 0xa80f17};

double linearFromByte(std::uint32_t byte) {
    return linearFromSrgb(byte / 255.0);
}

Ramp fromCodes(std::string_view name, const Codes& codes) {
    Ramp ramp{name, {}};
    for (int i = 0; i < kRampPoints; ++i) {
        std::uint32_t code = codes[i];
        ramp.points[i] = {linearFromByte(code >> 16), linearFromByte(code >> 8 & 255), linearFromByte(code & 255)};
    }
    return ramp;
}

// Linear in light, so that the colour is h itself.
Ramp grey() {
    Ramp ramp{"grey", {}};
    for (int i = 0; i < kRampPoints; ++i) ramp.points[i] = dvec3(double(i) / (kRampPoints - 1));
    return ramp;
}

}  // namespace

const std::vector<Ramp>& ramps() {
    static const std::vector<Ramp> all = {fromCodes("terrain", kTerrain), fromCodes("viridis", kViridis),
                                          fromCodes("geoid", kGeoid), grey()};
    return all;
}

int findRamp(std::string_view name) {
    for (std::size_t i = 0; i < ramps().size(); ++i)
        if (ramps()[i].name == name) return int(i);
    return -1;
}

dvec3 rampColour(const Ramp& ramp, double x) {
    double place = std::isnan(x) ? 0.0 : std::clamp(x, 0.0, 1.0) * (kRampPoints - 1);
    int first = std::min(int(place), kRampPoints - 2);
    return glm::mix(ramp.points[first], ramp.points[first + 1], place - first);
}

}  // namespace dsphere
