#pragma once

#include "base/image.h"

#include <vector>

namespace dsphere {

/// Pixels per degree of an observer 0.7 m from a display 0.7 m and 3840 pixels wide, as the paper recommends.
inline constexpr double kPixelsPerDegree = 67.02064327658225;

/// The LDR FLIP of Andersson, Nilsson, Akenine-Moller, Oskarsson, Astrom and Fairchild, "FLIP: A Difference Evaluator
/// for Alternating Images", Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020: for each pixel, 0 (equal) to 1, what
/// an observer sees who alternates between the two pictures. Takes R, G, B of both, linear, clamped to [0, 1]; NaN is
/// black. Both pictures have the same size.
std::vector<float> flip(const Image& reference, const Image& test, double pixels_per_degree = kPixelsPerDegree);

}  // namespace dsphere
