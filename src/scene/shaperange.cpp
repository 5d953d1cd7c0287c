#include "scene/shaperange.h"

#include "base/limits.h"
#include "scene/diagnostics.h"

#include <algorithm>
#include <cmath>

namespace dsphere {

namespace {

double greatest(const dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

struct Extent {
    double size;   ///< object units
    dvec3 middle;  ///< object space
};

Extent extentOf(const Geometry& geometry) {
    if (const auto* displaced = std::get_if<DisplacedSphere>(&geometry)) return {displaced->radius, dvec3(0.0)};
    if (const auto* sphere = std::get_if<Sphere>(&geometry)) return {sphere->radius, dvec3(0.0)};
    if (const auto* disk = std::get_if<Disk>(&geometry)) return {disk->radius, {0.0, 0.0, disk->height}};
    const auto& mesh = std::get<TriangleMesh>(geometry);
    Extent extent{0.0, middleOf(mesh)};
    for (const dvec3& point : mesh.points) extent.size = std::max(extent.size, greatest(point - extent.middle));
    return extent;
}

}  // namespace

void requireShapeInRange(const Shape& shape) {
    const auto& [size, middle] = extentOf(shape.geometry);
    const auto& [least, most] = limits::kLength;
    for (int axis = 0; axis < 3; ++axis) {
        const double length = size * glm::length(dvec3(shape.world_from_object[axis]));
        if (!(length >= least && length <= most))
            failAt(shape.where, "the shape's size in the world is {:.3g} along its {} axis; supported: {} to {}",
                   length, "xyz"[axis], least, most);
    }
    const dvec3 place = transformPoint(shape.world_from_object, middle);
    if (!(greatest(place) <= limits::kGreatestCoordinate))
        failAt(shape.where, "the shape lies at {:.3g} {:.3g} {:.3g} in the world; supported: coordinates up to {}",
               place.x, place.y, place.z, limits::kGreatestCoordinate);
}

}  // namespace dsphere
