#pragma once

// pbrt's transforms as matrices on column vectors.

#include "base/math.h"

#include <optional>

namespace dsphere {

/// v / |v| for any finite v, without overflow; unset for the zero vector.
std::optional<dvec3> unitVector(const dvec3& v);

/// World to camera of an observer at `eye` looking at `look`: left-handed, x right = up x direction, y up, z ahead.
/// Unset when eye = look or `up` is parallel to the view.
std::optional<dmat4> lookAtMatrix(const dvec3& eye, const dvec3& look, const dvec3& up);

/// Rotation about a unit axis, counter-clockwise in right-handed axes (pbrt's Rotate).
dmat4 rotationMatrix(double degrees, const dvec3& axis);

bool isFinite(const dmat4& m);

/// Whether the transform can be inverted in double: the columns of its linear part, scaled to length 1, span a volume
/// over 1e-12, and glm::inverse stays finite (a uniform scale of 1e-150 underflows it).
bool isInvertible(const dmat4& m);

/// The factor by which a linear map that keeps angles (rotation, mirroring, uniform scale) lengthens vectors; unset for
/// one that does not keep them to 1e-5.
std::optional<double> angleKeepingScale(const dmat3& m);

}  // namespace dsphere
