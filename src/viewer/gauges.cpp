#include "viewer/gauges.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "viewer/edits.h"

namespace dsphere::viewer {

namespace {

dvec3 onWindow(const Pose& pose, const dvec3& direction) {
    return {glm::dot(direction, glm::normalize(pose.right)), glm::dot(direction, glm::normalize(pose.up)),
            -glm::dot(direction, glm::normalize(pose.ahead))};
}

/// The place of the mean ground that a ray meets, else the nearest to it.
dvec3 groundOf(const Globe& globe, const CursorRay& ray) {
    const dvec3 from = ray.origin - globe.centre();
    const double along = -glm::dot(from, ray.direction), radius = globe.radius();
    const dvec3 nearest = from + along * ray.direction;
    const double room = radius * radius - glm::dot(nearest, nearest);
    if (room > 0.0 && along > 0.0) return globe.centre() + nearest - std::sqrt(room) * ray.direction;
    return globe.centre() + radius * glm::normalize(from);
}

}  // namespace

std::string LengthUnit::text(double length) const {
    const double value = per_world * length;
    if (!metres) return fmt::format("{:.4g} R", value);
    return std::abs(value) >= 1000.0 ? fmt::format("{:.6g} km", 1e-3 * value) : fmt::format("{:.4g} m", value);
}

LengthUnit lengthUnitOf(const Document& document, const Globe& globe, std::size_t shape) {
    const auto* sphere = std::get_if<DisplacedSphere>(&document.scene.shapes[shape].geometry);
    const int map = document.maps.map_of_shape[shape];
    if (sphere && map >= 0)
        if (const auto& radius = document.maps.maps[std::size_t(map)]->facts.radius) {
            const double longest = globe.radius() / document.maps.reliefs[shape].greatest_radius;
            return {*radius / (sphere->radius * longest), true};
        }
    return {1.0 / globe.radius(), false};
}

Gauges gaugesOf(const CameraControl& control, const Document& document, int width, int height) {
    const Globe& globe = control.globe();
    const Pose& pose = control.pose();
    const Camera& camera = control.camera();
    const dvec3 ground = groundOf(globe, control.rayAt(0.5 * dvec2(width, height)));
    const dvec3 outward = glm::normalize(ground - globe.centre());
    const dvec3 north = globe.north() - glm::dot(globe.north(), outward) * outward;
    Gauges gauges;
    if (glm::length(north) > 1e-6) gauges.north = dvec2(onWindow(pose, glm::normalize(north)));
    if (const DistantLight* sun = sunOf(document.scene)) gauges.sun = onWindow(pose, sun->direction);
    const double half = camera.projection == Projection::Orthographic
                            ? glm::length(pose.up)
                            : glm::length(ground - pose.eye) * std::tan(0.5 * glm::radians(camera.fov_degrees));
    gauges.pixel = 2.0 * half / std::min(width, height);
    gauges.unit = lengthUnitOf(document, globe, control.target());
    return gauges;
}

}  // namespace dsphere::viewer
