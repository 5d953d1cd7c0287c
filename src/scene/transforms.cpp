#include "scene/transforms.h"

#include <algorithm>
#include <cmath>

namespace dsphere {

namespace {

constexpr double kParallel = 1e-12;  // sine of an angle, or volume of unit columns, that double no longer tells from 0

}  // namespace

std::optional<dvec3> unitVector(const dvec3& v) {
    double largest = std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    if (!(largest > 0.0) || std::isinf(largest)) return {};
    return glm::normalize(v / largest);
}

std::optional<dmat4> lookAtMatrix(const dvec3& eye, const dvec3& look, const dvec3& up) {
    std::optional<dvec3> ahead = unitVector(look - eye);
    std::optional<dvec3> upward = unitVector(up);
    if (!ahead || !upward) return {};
    dvec3 across = glm::cross(*upward, *ahead);
    if (glm::length(across) < kParallel) return {};
    dvec3 right = glm::normalize(across);
    dmat3 world_from_camera(right, glm::cross(*ahead, right), *ahead);
    dmat4 camera_from_world(glm::transpose(world_from_camera));
    camera_from_world[3] = dvec4(-(glm::transpose(world_from_camera) * eye), 1.0);
    return camera_from_world;
}

// Rodrigues: R = cos I + sin [a]x + (1 - cos) a a^T.
dmat4 rotationMatrix(double degrees, const dvec3& axis) {
    double angle = degrees * kPi / 180.0, sine = std::sin(angle), cosine = std::cos(angle);
    dmat3 cross(0.0, axis.z, -axis.y, -axis.z, 0.0, axis.x, axis.y, -axis.x, 0.0);  // columns of [a]x
    return dmat4(cosine * dmat3(1.0) + sine * cross + (1.0 - cosine) * glm::outerProduct(axis, axis));
}

bool isFinite(const dmat4& m) {
    for (int column = 0; column < 4; ++column)
        for (int row = 0; row < 4; ++row)
            if (!std::isfinite(m[column][row])) return false;
    return true;
}

std::optional<double> angleKeepingScale(const dmat3& m) {
    constexpr double kTolerance = 1e-5;  // written matrices have six digits
    const double scale = glm::length(m[0]);
    if (!(scale > 0.0) || std::isinf(scale)) return {};
    const dmat3 unit(m[0] / scale, m[1] / scale, m[2] / scale);
    const dmat3 gram = glm::transpose(unit) * unit;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            if (!(std::abs(gram[column][row] - (row == column ? 1.0 : 0.0)) <= kTolerance)) return {};
    return scale;
}

bool isInvertible(const dmat4& m) {
    dmat3 unit_columns;
    for (int column = 0; column < 3; ++column) {
        std::optional<dvec3> unit = unitVector(dvec3(m[column]));
        if (!unit) return false;
        unit_columns[column] = *unit;
    }
    return std::abs(glm::determinant(unit_columns)) > kParallel && isFinite(glm::inverse(m));
}

}  // namespace dsphere
