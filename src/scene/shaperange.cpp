#include "scene/shaperange.h"

#include "base/limits.h"
#include "base/overloads.h"
#include "scene/diagnostics.h"

#include <algorithm>
#include <cmath>

namespace dsphere {

namespace {

/// NaN where any is.
double greatest(const dvec3& v) {
    return std::isnan(v.x + v.y + v.z) ? v.x + v.y + v.z : std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

struct Extent {
    double size;   ///< object units
    dvec3 middle;  ///< object space
};

Extent extentOf(const Geometry& geometry) {
    const auto ofMesh = [](const TriangleMesh& mesh) {
        Extent extent{0.0, middleOf(mesh)};
        for (const dvec3& point : mesh.points) extent.size = std::max(extent.size, greatest(point - extent.middle));
        return extent;
    };
    return std::visit(Overloads{[](const DisplacedSphere& sphere) {
                                    return Extent{sphere.radius, dvec3(0.0)};
                                },
                                [](const Sphere& sphere) {
                                    return Extent{sphere.radius, dvec3(0.0)};
                                },
                                [](const Disk& disk) {
                                    return Extent{disk.radius, dvec3(0.0, 0.0, disk.height)};
                                },
                                ofMesh},
                      geometry);
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

std::optional<std::string> eyeOutOfRange(const Camera& camera) {
    const dvec3 eye = dvec3(glm::inverse(camera.camera_from_world)[3]) + 0.0;  // no -0
    if (greatest(eye) <= limits::kGreatestCoordinate) return {};
    return fmt::format("the eye is at {:.3g} {:.3g} {:.3g}; supported: coordinates up to {}", eye.x, eye.y, eye.z,
                       limits::kGreatestCoordinate);
}

}  // namespace dsphere
