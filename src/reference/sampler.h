#pragma once

// The sample numbers of docs/light.md: an Owen-scrambled Sobol sequence of its own for every pixel and decision.

#include "base/math.h"

#include <cstdint>

namespace dsphere::reference {

/// The pairs of numbers that decisions take at vertex n of a path.
inline constexpr std::uint32_t kFilterPair = 0;
constexpr std::uint32_t directionPair(std::uint32_t n) {
    return 64 * n + 1;
}
constexpr std::uint32_t lobePair(std::uint32_t n) {
    return 64 * n + 2;
}
constexpr std::uint32_t lightChoicePair(std::uint32_t n) {
    return 64 * n + 3;
}
constexpr std::uint32_t lightPair(std::uint32_t n, std::uint32_t light) {
    return 64 * n + 4 + light;
}

/// Which numbers a pixel of the film's raster gets: x and y count from the whole film's corner, not the crop's.
struct SampleSource {
    std::uint32_t x = 0, y = 0, seed = 0;
    std::uint32_t index = 0;  ///< of the pixel's sample, from 0

    /// Both in [0, 1), multiples of 2^-24.
    dvec2 pair(std::uint32_t number) const;
};

}  // namespace dsphere::reference
