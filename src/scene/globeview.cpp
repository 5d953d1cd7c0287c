#include "scene/globeview.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace dsphere {

namespace {

/// Where a camera looks, what is up in its picture, and what to the right.
struct View {
    dvec3 ahead, up, right;
};

View viewOf(const LocalFrame& frame, double heading, double pitch) {
    const double sin_h = std::sin(glm::radians(heading)), cos_h = std::cos(glm::radians(heading));
    const double sin_p = std::sin(glm::radians(pitch)), cos_p = std::cos(glm::radians(pitch));
    const dvec3 level = cos_h * frame.north + sin_h * frame.east;
    return {cos_p * level + sin_p * frame.up, cos_p * frame.up - sin_p * level,
            cos_h * frame.east - sin_h * frame.north};
}

// The columns of a transform may be scaled and sheared: the camera's axes are unit and at right angles.
dmat4 worldFromCamera(const dmat4& world_from_object, const View& view, const dvec3& eye) {
    const dvec3 ahead = glm::normalize(transformVector(world_from_object, view.ahead));
    dvec3 up = transformVector(world_from_object, view.up);
    up = glm::normalize(up - glm::dot(up, ahead) * ahead);
    dvec3 right = glm::cross(ahead, up);
    if (glm::dot(right, transformVector(world_from_object, view.right)) < 0.0) right = -right;
    return {dvec4(right, 0.0), dvec4(up, 0.0), dvec4(ahead, 0.0), dvec4(eye, 1.0)};
}

}  // namespace

LocalFrame localFrameAt(double latitude, double longitude) {
    const double sin_lat = std::sin(glm::radians(latitude)), cos_lat = std::cos(glm::radians(latitude));
    const double sin_lon = std::sin(glm::radians(longitude)), cos_lon = std::cos(glm::radians(longitude));
    return {{cos_lon, 0.0, -sin_lon},
            {-sin_lat * sin_lon, cos_lat, -sin_lat * cos_lon},
            {cos_lat * sin_lon, sin_lat, cos_lat * cos_lon}};
}

int firstDisplacedSphere(const Scene& scene) {
    const auto found = std::ranges::find_if(
        scene.shapes, [](const Shape& shape) { return std::holds_alternative<DisplacedSphere>(shape.geometry); });
    return found == scene.shapes.end() ? -1 : int(found - scene.shapes.begin());
}

void lookFrom(Scene& scene, const GlobeView& view) {
    const int globe = firstDisplacedSphere(scene);
    assert(globe >= 0);
    const dmat4& world_from_object = scene.shapes[std::size_t(globe)].world_from_object;
    const LocalFrame frame = localFrameAt(view.latitude, view.longitude);
    const dvec3 eye = transformPoint(world_from_object, frame.up * view.distance);
    scene.camera.camera_from_world =
        glm::inverse(worldFromCamera(world_from_object, viewOf(frame, view.heading, view.pitch), eye));
}

}  // namespace dsphere
