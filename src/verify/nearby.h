#pragma once

// What a device that computes in floats may take for its inputs: the neighbours at which the reference is asked again,
// so that bounds follow from what is compared and not from a constant. A lobe of width alpha turns an angle's error
// into 1 / alpha of itself, a lamp at a distance d the last place of P into 1 / d of itself: the neighbours show both.

#include "reference/tracer.h"

#include <vector>

namespace dsphere::verify {

namespace rounding {
inline constexpr double kTurn = 1e-6;        ///< radians: a sampled direction, through sine, cosine, root and frame
inline constexpr double kViewTurn = 5e-7;    ///< radians: a direction that was only normalised
inline constexpr double kPosition = 1.2e-7;  ///< of what a world position is the sum of
inline constexpr double kNumber = 1.2e-7;    ///< of a sum of probabilities: two last places below 1
inline constexpr double kObject = 5.2e-8;    ///< R: half a last place below 1 in each of three coordinates
inline constexpr double kCoordinate =
    2e-6;  ///< R: u or v, up to 1 and off by 3e-7, on the way of 2 pi R that they measure
}  // namespace rounding

/// Eight directions across another one, of length `step`.
std::vector<dvec3> ringOffsets(const dvec3& direction, double step);
/// Eight unit directions that an angle lies between and this one.
std::vector<dvec3> turned(const dvec3& direction, double angle);

/// Light k's samples from positions, normals and sample numbers that round to the same floats, and, of an area light,
/// directions a kTurn off. Where a frame's sign, a texel or a cone's rim is in doubt they lie on both sides. None of a
/// distant light.
std::vector<reference::LightSample> nearbySamples(const Scene& scene, const reference::Tracer& tracer,
                                                  const reference::ShadingPoint& point, int k,
                                                  const reference::SampleSource& source);

/// Object positions at which the texture may be read instead; none where it is read exactly enough.
std::vector<dvec3> nearbyTexturePlaces(const Scene& scene, const reference::Tracer& tracer,
                                       const reference::ShadingPoint& point, const dvec3& object_normal);

}  // namespace dsphere::verify
