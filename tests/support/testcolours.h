#pragma once

// Colour images made in memory.

#include "surface/colourmap.h"

#include <random>

namespace dsphere::test {

/// Independent 8-bit codes, a third of them black: next to a dark texel a small weight decides the colour.
inline RawColour randomCodes(int width, int height, unsigned seed = 1) {
    RawColour raw;
    raw.width = width;
    raw.height = height;
    raw.type = "random";
    std::mt19937 random(seed);
    for (int k = 0; k < 3 * width * height; ++k)
        raw.srgb.push_back(random() % 3 ? std::uint8_t(random()) : std::uint8_t(0));
    return raw;
}

/// Light of 0 to 1 in floats, a third of it black.
inline RawColour randomLight(int width, int height, unsigned seed = 1) {
    RawColour raw;
    raw.width = width;
    raw.height = height;
    raw.type = "random";
    std::mt19937 random(seed);
    for (int k = 0; k < 3 * width * height; ++k)
        raw.linear.push_back(random() % 3 ? float(random() % 10007) / 10007.0f : 0.0f);
    return raw;
}

inline RawColour lightOf(int width, int height, std::vector<float> linear) {
    RawColour raw;
    raw.width = width;
    raw.height = height;
    raw.linear = std::move(linear);
    return raw;
}

}  // namespace dsphere::test
