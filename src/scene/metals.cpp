#include "scene/metals.h"

namespace dsphere {

namespace {

// Measured spectra (Palik 1985, "Handbook of Optical Constants of Solids", and the luxpop.com tables after it, which
// pbrt and Mitsuba ship) under the CIE 1931 observer in sRGB's primaries, as the renderer Tungsten lists them, to four
// digits.
constexpr Metal kMetals[] = {
    {"Cu", {0.2004, 0.9240, 1.1022}, {3.9129, 2.4528, 2.1421}},
    {"Au", {0.1431, 0.3750, 1.4425}, {3.9832, 2.3857, 1.6032}},
    {"Ag", {0.1553, 0.1167, 0.1384}, {4.8283, 3.1222, 2.1470}},
    {"Al", {1.6575, 0.8804, 0.5212}, {9.2239, 6.2695, 4.8370}},
};

}  // namespace

std::span<const Metal> metals() {
    return kMetals;
}

}  // namespace dsphere
