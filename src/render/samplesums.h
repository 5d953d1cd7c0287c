#pragma once

#include "base/image.h"

namespace dsphere {

/// The colour of a picture that may go on: what its samples 0 to samples - 1 add up to, as the device adds them.
struct SampleSums {
    int samples = 0;
    Image sums;  ///< R, G, B, and A where it is wanted
};

/// The picture: its channels are the means. A mean times its number gives the sum back where that is a power of two;
/// else the sums come with it, as sum.R, sum.G, sum.B, sum.A.
Image pictureOf(SampleSums sums);

/// Of a picture of so many samples, bit for bit; other channels are left out, and A where the picture has none. Error
/// (InvalidInput) without the channels that it takes.
SampleSums sumsOf(const Image& picture, int samples);

/// How many pixels hold a sum that is not finite: a sample of theirs was not.
std::size_t nonFinitePixels(const SampleSums& sums);

}  // namespace dsphere
