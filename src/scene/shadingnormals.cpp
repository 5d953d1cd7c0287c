#include "scene/shadingnormals.h"

#include "base/limits.h"

#include <cmath>

namespace dsphere {

namespace {

constexpr double kParallel = 1e-3;  // sine of the angle: exporters write four digits at least

bool isNormalOf(const dvec3& n, const dvec3& a, const dvec3& b, const dvec3& c) {
    const dvec3 own = glm::normalize(glm::cross(b - a, c - a));
    const double length = glm::length(n);
    return length > 0.0 && glm::length(glm::cross(own, n / length)) <= kParallel;
}

}  // namespace

void ignoreFlatNormals(Parameters& p, const TriangleMesh& mesh, const std::vector<int>& corners) {
    p.ignoreIf("N", {"normal"}, [&](const Parameter& given) {
        const std::vector<double> n = listValue(given, 3, "points", 3 * limits::kTrianglesOfMesh);
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const std::size_t at = 3 * std::size_t(corners[i]);
            const auto& [i0, i1, i2] = mesh.triangles[i / 3];
            const auto point = [&](int k) { return mesh.points[std::size_t(k)]; };
            if (at + 2 >= n.size())
                failAt(given.where, "parameter \"N\" has {} numbers; supported: 3 for each point", n.size());
            if (!isNormalOf({n[at], n[at + 1], n[at + 2]}, point(i0), point(i1), point(i2)))
                failAt(given.where,
                       "parameter \"N\": the normal of point {} is not that of triangle {}, both counted from 0; "
                       "supported: flat triangles, whose normals change nothing",
                       corners[i], i / 3);
        }
    });
}

}  // namespace dsphere
