#pragma once

// A map that stays in its file, blurred as it is read.

#include "surface/gaps.h"

#include <memory>

namespace dsphere {

/// The widest blur that windows are read with, in texels: each takes ceil(3 sigma) more on all sides. For a map of
/// 16,385 x 256 texels in memory 2 took 2.5 s in all, this one 4.4, 32 29 and 128 310.
inline constexpr double kMostTiledBlur = 8.0;

/// The map with its gaps filled, then blurred as blurMap() does it, bit for bit: Float32, without an unknown texel.
/// `sigma` in texels, from above 0 to kMostTiledBlur.
std::shared_ptr<const geo::LargeMap> blurredMap(std::shared_ptr<const geo::LargeMap> source, Gaps gaps, double sigma);

}  // namespace dsphere
