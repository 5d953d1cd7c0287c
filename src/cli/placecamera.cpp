#include "cli/placecamera.h"

#include "base/error.h"
#include "cli/commands.h"
#include "reference/ground.h"
#include "scene/globeview.h"
#include "scene/shaperange.h"

#include <cmath>

namespace dsphere::cli {

namespace {

void requireRanges(const SceneOptions& options) {
    if (options.latlon.empty()) {
        if (options.heading || options.pitch) throwUsage("--heading and --pitch go with --lookat-latlon");
        return;
    }
    if (!(std::abs(options.latlon[0]) <= 90.0 && std::isfinite(options.latlon[1]) && options.latlon[2] > 0.0 &&
          std::isfinite(options.latlon[2])))
        throwUsage("--lookat-latlon: expected a latitude in [-90, 90], a longitude and an altitude > 0");
    if (options.heading && !std::isfinite(*options.heading)) throwUsage("--heading: expected a number of degrees");
    if (options.pitch && !(std::abs(*options.pitch) <= 90.0)) throwUsage("--pitch: expected degrees in [-90, 90]");
}

}  // namespace

void placeCamera(Scene& scene, const SceneMaps& maps, const SceneOptions& options) {
    requireRanges(options);
    if (options.latlon.empty()) return;
    const int globe = firstDisplacedSphere(scene);
    if (globe < 0) throwUsage("--lookat-latlon: the scene has no displacedsphere");
    const std::size_t k = std::size_t(globe);
    const double latitude = options.latlon[0], longitude = options.latlon[1];
    const Heightmap& map = *maps.maps[std::size_t(maps.map_of_shape[k])];
    const double ground = reference::radiusTowards(map, maps.reliefs[k], localFrameAt(latitude, longitude).up);
    const double altitude = options.latlon[2] * std::get<DisplacedSphere>(scene.shapes[k].geometry).radius;
    lookFrom(scene, {.latitude = latitude,
                     .longitude = longitude,
                     .distance = ground + altitude,
                     .heading = options.heading.value_or(0.0),
                     .pitch = options.pitch.value_or(-90.0)});
    if (const auto fault = eyeOutOfRange(scene.camera)) throwUsage("--lookat-latlon: {}", *fault);
}

void printCameraNotices(const Scene& scene, const SceneMaps& maps) {
    printNotices(reference::warnOfBuriedEye(scene, maps));
}

}  // namespace dsphere::cli
