#pragma once

#include <cstddef>
#include <vector>

namespace dsphere {

/// Convolves the row-major map with the Gaussian of standard deviation `sigma` > 0 (texels), cut at ceil(3 sigma) and
/// scaled to sum 1: first along the rows, which wrap around, then along the columns, where the first and the last row
/// go on for ever. Sums in double, rounded to float once a direction; equal values stay as they are.
void blurMap(std::vector<float>& samples, int width, int height, double sigma);

/// ceil(3 sigma): how far away texels count, along rows and along columns.
std::ptrdiff_t blurRadius(double sigma);

/// The same of a part of a map: `window` is that part and blurRadius() texels around, `width` x `height` in all, and
/// what remains of it goes to `to`, row by row.
void blurWindow(std::vector<float>& window, int width, int height, double sigma, float* to);

}  // namespace dsphere
