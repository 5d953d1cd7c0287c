#include "scene/motion.h"

#include "base/error.h"
#include "base/overloads.h"
#include "scene/globeview.h"
#include "scene/shaperange.h"
#include "scene/transforms.h"

#include <algorithm>
#include <cmath>

namespace dsphere {

namespace {

/// The shape that places and axes belong to: the first displaced sphere, else the first shape.
const Shape& globeOf(const Scene& scene) {
    return scene.shapes[std::size_t(std::max(firstDisplacedSphere(scene), 0))];
}

bool isMirrored(const dmat4& m) {
    return glm::determinant(dmat3(m)) < 0.0;
}

/// A camera that leans to the right by so many degrees.
dmat4 leaning(const dmat4& camera_from_world, double degrees) {
    return rotationMatrix(degrees, {0.0, 0.0, 1.0}) * camera_from_world;
}

/// The point of the camera's axis that is nearest the globe's centre: what it looks at, as far as a matrix can tell.
dvec3 lookedAt(const Scene& scene, const dmat4& world_from_camera) {
    const dvec3 eye(world_from_camera[3]), ahead = glm::normalize(dvec3(world_from_camera[2]));
    const dvec3 centre = transformPoint(globeOf(scene).world_from_object, dvec3(0.0));
    const double distance = glm::dot(centre - eye, ahead);
    return eye + (distance > 0.0 ? distance : 1.0) * ahead;
}

}  // namespace

void exaggerate(Scene& scene, double factor) {
    for (Shape& shape : scene.shapes) {
        auto* sphere = std::get_if<DisplacedSphere>(&shape.geometry);
        if (!sphere) continue;
        sphere->max_displacement *= factor;
        if (sphere->height_scale) *sphere->height_scale *= factor;
    }
}

void placeSun(Scene& scene, double latitude, double longitude) {
    const dvec3 outward = localFrameAt(latitude, longitude).up;
    const dvec3 direction = transformVector(globeOf(scene).world_from_object, outward);
    for (Light& light : scene.lights) {
        auto* sun = std::get_if<DistantLight>(&light);
        if (!sun) continue;
        sun->direction = glm::normalize(direction);
        return;
    }
    throw Error(ExitCode::Usage, "sun_lon and sun_lat need a distant light in the scene");
}

void turnTable(Scene& scene, double degrees) {
    const dmat4& globe = globeOf(scene).world_from_object;
    const dvec3 centre(globe[3]), axis = glm::normalize(dvec3(globe[1]));
    // The camera and the lights go round; area lights are shapes.
    dmat4 turn = rotationMatrix(isMirrored(globe) ? -degrees : degrees, axis);
    turn[3] = dvec4(centre - transformVector(turn, centre), 1.0);
    const dmat4 back = glm::inverse(turn);
    scene.camera.camera_from_world = scene.camera.camera_from_world * turn;
    const auto move = Overloads{[&](DistantLight& sun) { sun.direction = transformVector(back, sun.direction); },
                                [&](PointLight& lamp) { lamp.position = transformPoint(back, lamp.position); },
                                [&](InfiniteLight& sky) { sky.world_from_light = dmat3(back) * sky.world_from_light; },
                                [](AreaLight&) {}};
    for (Light& light : scene.lights) std::visit(move, light);
}

dvec3 Motion::vector(Column first, double frame) const {
    return {value(first, frame), value(Column(first + 1), frame), value(Column(first + 2), frame)};
}

void Motion::moveCamera(Scene& scene, double frame) const {
    const auto valueOr = [&](Column column, double other) { return has(column) ? value(column, frame) : other; };
    if (has(Latitude)) {
        const auto* globe = std::get_if<DisplacedSphere>(&globeOf(scene).geometry);
        if (!globe) throwInvalid("lat, lon and alt need a displacedsphere in the scene");
        GlobeView view{.latitude = std::clamp(value(Latitude, frame), -90.0, 90.0),
                       .longitude = value(Longitude, frame),
                       .distance = globe->radius * (1.0 + value(Altitude, frame))};
        view.heading = valueOr(Heading, view.heading);
        view.pitch = std::clamp(valueOr(Pitch, view.pitch), -90.0, 90.0);
        lookFrom(scene, view);
        if (has(Roll)) scene.camera.camera_from_world = leaning(scene.camera.camera_from_world, value(Roll, frame));
    } else if (has(EyeX) || has(LookX) || has(UpX)) {
        const dmat4& camera_from_world = scene.camera.camera_from_world;
        const dmat4 world_from_camera = glm::inverse(camera_from_world);
        const dvec3 eye = has(EyeX) ? vector(EyeX, frame) : dvec3(world_from_camera[3]);
        const dvec3 look = has(LookX) ? vector(LookX, frame) : lookedAt(scene, world_from_camera);
        const dvec3 up = has(UpX) ? vector(UpX, frame) : dvec3(world_from_camera[1]);
        std::optional<dmat4> view = lookAtMatrix(eye, look, up);
        if (!view)
            throwInvalid("the eye ({}, {}, {}) is the point looked at, or up is along the view", eye.x, eye.y, eye.z);
        if (isMirrored(camera_from_world)) *view = dmat4(dmat3(-1.0, 0, 0, 0, 1, 0, 0, 0, 1)) * *view;
        scene.camera.camera_from_world = *view;
    }
    if (!has(Fov)) return;
    if (scene.camera.projection != Projection::Perspective) throwInvalid("fov needs a perspective camera");
    scene.camera.fov_degrees = std::clamp(value(Fov, frame), least_fov_, greatest_fov_);
}

Scene Motion::at(const Scene& scene, double frame) const {
    Scene moved = scene;
    try {
        moveCamera(moved, frame);
        if (has(SunLatitude))
            placeSun(moved, std::clamp(value(SunLatitude, frame), -90.0, 90.0), value(SunLongitude, frame));
        if (has(Exaggeration)) exaggerate(moved, value(Exaggeration, frame));
        if (const auto fault = eyeOutOfRange(moved.camera)) throwInvalid("{}", *fault);
    } catch (const Error& error) {
        throwInvalid("{}: frame {}: {}", name_, frame, error.what());
    }
    return moved;
}

std::optional<double> Motion::exposureAt(double frame) const {
    if (!has(Exposure)) return {};
    return value(Exposure, frame);
}

}  // namespace dsphere
