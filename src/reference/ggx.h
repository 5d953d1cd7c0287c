#pragma once

// GGX facets about the normal +z: Walter et al. 2007, "Microfacet models for refraction"; Smith's height-correlated
// masking and shadowing, Heitz 2014, "Understanding the masking-shadowing function".

#include "base/math.h"

#include <vector>

namespace dsphere::reference {

/// Directions are unit and above the surface (z > 0); alpha in (0, 1].
struct Facets {
    double alpha;

    /// D G / (4 c_l c_v).
    double reflection(const dvec3& l, const dvec3& v) const;
    /// Of light directions that mirror v in the normals that v sees: D_v(h) / (4 dot(v, h)) = D G1(v) / (4 c_v).
    double visibleDensity(const dvec3& l, const dvec3& v) const;
    /// A normal that v sees, from two numbers in [0, 1).
    dvec3 visibleNormal(const dvec3& v, const dvec2& u) const;

    /// E: the share of the light from an angle of that cosine, 0 < cosine <= 1, that facets which reflect all send
    /// off at their first reflection; to 1e-6 or better from 1e-4 on.
    double albedo(double cosine) const;
};

/// What facets lose by reflecting but once, 1 - E, tabulated for one alpha; to 3e-6.
class LostLight {
  public:
    explicit LostLight(double alpha);

    double at(double cosine) const;             ///< 1 - E
    double mean() const { return mean_lost_; }  ///< 1 - E_mean

  private:
    std::vector<double> lost_;  // at cosine (k / (count - 1))^3: E bends where the cosine is of the order of alpha
    double mean_lost_ = 0.0;
};

}  // namespace dsphere::reference
