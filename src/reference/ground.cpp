#include "reference/ground.h"

#include "base/overloads.h"
#include "reference/curved.h"
#include "reference/grid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dsphere::reference {

namespace {

/// r below (or above) a point in the shape's space; 0 for shapes without a solid.
double radiusUnder(const Scene& scene, const SceneMaps& maps, std::size_t shape, const dvec3& point) {
    const auto underDisplaced = [&](const DisplacedSphere&) {
        const dvec3 direction = point == dvec3(0.0) ? dvec3(0.0, 1.0, 0.0) : point;
        return radiusTowards(*maps.maps[std::size_t(maps.map_of_shape[shape])], maps.reliefs[shape], direction);
    };
    return std::visit(Overloads{underDisplaced, [](const Sphere& sphere) { return sphere.radius; },
                                [](const Disk&) { return 0.0; }, [](const TriangleMesh&) { return 0.0; }},
                      scene.shapes[shape].geometry);
}

}  // namespace

double radiusTowards(const Heightmap& map, const Relief& relief, const dvec3& w) {
    const PatchGrid grid(map);
    const double column = grid.columnOf(std::atan2(w.x, w.z));
    const double row = grid.rowOf(std::atan2(std::hypot(w.x, w.z), w.y));
    const auto stored = [&] {
        if (map.ripples) return RippleField(grid).value(column, row);
        if (relief.filter == Filter::Bilinear) return grid.value(column, row);
        const int i = std::min(int(column), grid.columns() - 1), j = std::min(int(row), grid.rows() - 1);
        return SplineField(grid, map).value(i, j, column - i, row - j);
    };
    return relief.base + relief.scale * stored();
}

Notices warnOfBuriedEye(const Scene& scene, const SceneMaps& maps) {
    const dvec3 eye = transformPoint(glm::inverse(scene.camera.camera_from_world), dvec3(0.0));
    Notices notices;
    for (std::size_t k = 0; k < scene.shapes.size(); ++k) {
        const Shape& shape = scene.shapes[k];
        const dvec3 point = transformPoint(glm::inverse(shape.world_from_object), eye);
        const double radius = radiusUnder(scene, maps, k, point), depth = radius - glm::length(point);
        if (depth > 0.0)
            notices.push_back({Notice::Kind::Warning,
                               fmt::format("{}: the eye lies inside this shape, {:.4g} radii below its surface: the "
                                           "picture is black where it looks",
                                           shape.where.text(), depth / radius)});
    }
    return notices;
}

}  // namespace dsphere::reference
