#pragma once

// Small maths in double, on GLM. Angles are in radians unless a name says degrees.

#include <glm/glm.hpp>

#include <limits>
#include <numbers>

namespace dsphere {

using glm::dmat3;
using glm::dmat4;
using glm::dvec2;
using glm::dvec3;
using glm::dvec4;

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kEpsilon = std::numeric_limits<double>::epsilon();  ///< 2^-52

/// `m` applied to a point (w = 1, affine).
inline dvec3 transformPoint(const dmat4& m, const dvec3& p) {
    return dvec3(m * dvec4(p, 1.0));
}

/// `m` applied to a vector (w = 0).
inline dvec3 transformVector(const dmat4& m, const dvec3& v) {
    return dvec3(m * dvec4(v, 0.0));
}

/// An outward normal carried by the inverse transpose; not normalised. `inverse` is the inverse of the transform.
inline dvec3 transformNormal(const dmat4& inverse, const dvec3& n) {
    return glm::transpose(dmat3(inverse)) * n;
}

}  // namespace dsphere
