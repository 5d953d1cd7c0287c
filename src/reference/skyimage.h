#pragma once

#include "surface/colourmap.h"

#include <vector>

namespace dsphere::reference {

/// An infinite light's image, and directions drawn in proportion to its brightness. Directions are of the light's own
/// space, unit: (cos 2 pi a sin pi b, sin 2 pi a sin pi b, cos pi b) at the place (a, b), b from the image's top.
/// Refers to the image.
class SkyImage {
  public:
    explicit SkyImage(const ColourMap& image);

    /// Bilinear; repeated in a, its first and last rows held to the poles.
    dvec3 radiance(const dvec3& direction) const;

    struct Sample {
        dvec3 direction;
        double density;  ///< per steradian; infinite at a pole
    };
    Sample sample(const dvec2& u) const;
    double density(const dvec3& direction) const;

  private:
    double texelShare(int i, int j) const;

    const ColourMap* image_;
    std::vector<double> marginal_;  ///< [j]: the sum of the rows before j, over all; height + 1
    std::vector<double> rows_;      ///< the same within each row; width + 1 a row
};

}  // namespace dsphere::reference
