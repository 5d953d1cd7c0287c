#pragma once

#include "base/image.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace dsphere {

/// Where two pictures differ the most.
struct WorstPixel {
    int x = 0, y = 0;  ///< in the first picture's display coordinates
    std::string channel;
    double a = 0.0, b = 0.0;
};

/// How the second picture differs from the first over the chosen channels. Equal values, infinities and NaN in both
/// included, differ by 0; a NaN in one only, or an infinity against anything else, differs by infinity.
struct Comparison {
    double mae = 0.0, rmse = 0.0;
    double psnr = 0.0;  ///< dB for a peak of 1; infinity for equal pictures
    double max = 0.0;
    std::uint64_t non_finite = 0;     ///< values whose difference is infinite
    std::optional<WorstPixel> worst;  ///< none when the pictures are equal; a NaN in one only comes before all
};

/// Compares the channels of those names, which both pictures must have, in pictures of the same size.
Comparison comparePictures(const Image& a, const Image& b, const std::vector<std::string>& channels);

/// b - a, one float channel for each name; 0 where comparePictures sees no difference.
Image differencePicture(const Image& a, const Image& b, const std::vector<std::string>& channels);

}  // namespace dsphere
