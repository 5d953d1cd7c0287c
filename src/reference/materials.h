#pragma once

// How a point of a shape reflects light, in a frame of its own: the shading normal is +z, directions point away from
// the point and are unit. docs/light.md defines it.

#include "reference/ggx.h"
#include "scene/scene.h"

#include <memory>
#include <optional>

namespace dsphere::reference {

/// The Oren-Nayar factor on Lambert's law, 1 for sigma 0 (degrees).
double orenNayar(double sigma_degrees, const dvec3& l, const dvec3& v);

/// The material of a regularising integrator's later vertices: see docs/light.md.
Material softened(Material material);

/// A material made ready: what its facets lose is tabulated once. Thread-safe.
class Reflector {
  public:
    explicit Reflector(const Material& material);

    /// f(l, v) per steradian, without the cosine; `colour` is the material's texture at the point, of those that have
    /// one. Nothing below the surface. Where v lies below the shading normal's horizon, as smooth normals can have it,
    /// facets are not seen and diffuse light still is. A mirror's is 0.
    dvec3 f(const dvec3& l, const dvec3& v, const dvec3& colour) const;
    /// Per steradian, of `sample`; the rest to 1 are samples below the surface. A mirror's is 0.
    double density(const dvec3& l, const dvec3& v) const;
    /// A light direction drawn with that density by numbers in [0, 1); `lobe` says which way. It may lie below the
    /// surface: such a sample counts for nothing. A mirror's is the mirrored v.
    dvec3 sample(const dvec3& v, const dvec2& u, double lobe) const;
    /// The share of the radiance that a mirror sends on; nullptr: the material is none.
    const dvec3* mirror() const;

  private:
    double facetShare(const dvec3& v) const;  ///< the probability that a sample takes the visible normals
    dvec3 bounced(double c_l, double c_v) const;

    Material material_;
    std::optional<Facets> facets_;
    std::shared_ptr<const LostLight> lost_;  ///< conductors
    dvec3 bounced_fresnel_{0.0};             ///< F_ms
};

}  // namespace dsphere::reference
