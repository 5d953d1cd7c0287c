#include "cli/placecamera.h"

#include "base/error.h"
#include "cli/commands.h"
#include "reference/ground.h"

#include <algorithm>
#include <cmath>

namespace dsphere::cli {

namespace {

[[noreturn]] void throwPlacement(const std::string& message) {
    throw Error(ExitCode::Usage, message);
}

/// East, north and up at a place of a displaced sphere, in its own space.
struct LocalFrame {
    dvec3 east, north, up;
};

LocalFrame frameAt(double latitude, double longitude) {
    const double sin_lat = std::sin(glm::radians(latitude)), cos_lat = std::cos(glm::radians(latitude));
    const double sin_lon = std::sin(glm::radians(longitude)), cos_lon = std::cos(glm::radians(longitude));
    return {{cos_lon, 0.0, -sin_lon},
            {-sin_lat * sin_lon, cos_lat, -sin_lat * cos_lon},
            {cos_lat * sin_lon, sin_lat, cos_lat * cos_lon}};
}

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

void requireRanges(const SceneOptions& options) {
    if (options.latlon.empty()) {
        if (options.heading || options.pitch) throwPlacement("--heading and --pitch go with --lookat-latlon");
        return;
    }
    if (!(std::abs(options.latlon[0]) <= 90.0 && std::isfinite(options.latlon[1]) && options.latlon[2] > 0.0 &&
          std::isfinite(options.latlon[2])))
        throwPlacement("--lookat-latlon: expected a latitude in [-90, 90], a longitude and an altitude > 0");
    if (options.heading && !std::isfinite(*options.heading)) throwPlacement("--heading: expected a number of degrees");
    if (options.pitch && !(std::abs(*options.pitch) <= 90.0)) throwPlacement("--pitch: expected degrees in [-90, 90]");
}

}  // namespace

void placeCamera(Scene& scene, const SceneMaps& maps, const SceneOptions& options) {
    requireRanges(options);
    if (options.latlon.empty()) return;
    const auto planet = std::ranges::find_if(
        scene.shapes, [](const Shape& shape) { return std::holds_alternative<DisplacedSphere>(shape.geometry); });
    if (planet == scene.shapes.end()) throwPlacement("--lookat-latlon: the scene has no displacedsphere");
    const std::size_t k = std::size_t(planet - scene.shapes.begin());
    const LocalFrame frame = frameAt(options.latlon[0], options.latlon[1]);
    const Heightmap& map = *maps.maps[std::size_t(maps.map_of_shape[k])];
    const double ground = reference::radiusTowards(map, maps.reliefs[k], frame.up);
    const double altitude = options.latlon[2] * std::get<DisplacedSphere>(planet->geometry).radius;
    const dvec3 eye = transformPoint(planet->world_from_object, frame.up * (ground + altitude));
    const View view = viewOf(frame, options.heading.value_or(0.0), options.pitch.value_or(-90.0));
    scene.camera.camera_from_world = glm::inverse(worldFromCamera(planet->world_from_object, view, eye));
}

void printCameraNotices(const Scene& scene, const SceneMaps& maps) {
    printNotices(reference::warnOfBuriedEye(scene, maps));
}

}  // namespace dsphere::cli
