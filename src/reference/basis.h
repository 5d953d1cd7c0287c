#pragma once

#include "base/math.h"

#include <cmath>

namespace dsphere::reference {

/// The axes about a unit vector z of Duff et al. 2017, "Building an orthonormal basis, revisited". They jump where z.z
/// changes its sign.
struct Basis {
    dvec3 x, y, z;

    explicit Basis(const dvec3& axis) : z(axis) {
        const double sign = axis.z < 0.0 ? -1.0 : 1.0, a = -1.0 / (sign + axis.z), b = axis.x * axis.y * a;
        x = {1.0 + sign * axis.x * axis.x * a, sign * b, -sign * axis.x};
        y = {b, sign + axis.y * axis.y * a, -axis.y};
    }

    dvec3 toWorld(const dvec3& local) const { return local.x * x + local.y * y + local.z * z; }
    dvec3 toLocal(const dvec3& world) const { return {glm::dot(world, x), glm::dot(world, y), glm::dot(world, z)}; }
};

}  // namespace dsphere::reference
