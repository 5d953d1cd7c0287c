#pragma once

#include "scene/scene.h"

#include <random>

namespace dsphere::reference {

/// A place in a pixel filter, about the pixel's centre, and how much a sample there counts; less than nothing where the
/// filter is negative. The mean of what samples bring is the filter's.
struct FilterSample {
    dvec2 place{0.0};
    double weight = 1.0;
};

class FilterSampler {
  public:
    explicit FilterSampler(const PixelFilter& filter);
    FilterSample sample(std::mt19937_64& random) const;

  private:
    PixelFilter filter_;
    dvec2 mean_{1.0};  // of the kernel within the radius, along each axis
};

/// The kernel along one axis at a distance from the centre, up to a factor; 0 beyond the radius.
double filterKernel(const PixelFilter& filter, double radius, double x);

}  // namespace dsphere::reference
