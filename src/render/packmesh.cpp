#include "render/packmesh.h"

#include <algorithm>
#include <array>

namespace dsphere {

namespace {

constexpr std::array<dvec2, 3> kOwnUvs = {dvec2(0.0, 0.0), dvec2(1.0, 0.0), dvec2(1.0, 1.0)};  // pbrt's default

}  // namespace

double packMesh(layout::ObjectData& object, const TriangleMesh& mesh, std::vector<layout::TriangleData>& triangles) {
    const dvec3 centre = middleOf(mesh);
    double unit = 0.0;
    for (const dvec3& point : mesh.points) unit = std::max(unit, glm::length(point - centre));
    object.first_triangle = int(triangles.size());
    object.triangle_count = int(mesh.triangles.size());
    for (const std::array<int, 3>& triangle : mesh.triangles) {
        layout::TriangleData data = {};
        layout::vec4* const corners[] = {&data.a, &data.b, &data.c};
        for (int i = 0; i < 3; ++i) {
            const std::size_t point = std::size_t(triangle[std::size_t(i)]);
            const dvec2 uv = mesh.uvs.empty() ? kOwnUvs[std::size_t(i)] : mesh.uvs[point];
            *corners[i] = layout::vec4(glm::vec3((mesh.points[point] - centre) / unit), float(uv.x));
            data.v[i] = float(uv.y);
        }
        triangles.push_back(data);
    }
    return unit;
}

}  // namespace dsphere
