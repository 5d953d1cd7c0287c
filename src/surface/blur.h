#pragma once

#include <vector>

namespace dsphere {

/// Convolves the row-major map with the Gaussian of standard deviation `sigma` > 0 (texels), cut at ceil(3 sigma) and
/// scaled to sum 1: first along the rows, which wrap around, then along the columns, where the first and the last row
/// go on for ever. Sums in double, rounded to float once a direction; equal values stay as they are.
void blurMap(std::vector<float>& samples, int width, int height, double sigma);

}  // namespace dsphere
