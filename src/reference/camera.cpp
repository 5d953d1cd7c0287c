#include "reference/camera.h"

#include <cmath>

namespace dsphere::reference {

namespace {

std::array<double, 4> screenWindow(const Camera& camera, const Film& film) {
    if (camera.screen_window) return *camera.screen_window;
    const double aspect = camera.frame_aspect_ratio.value_or(double(film.width) / film.height);
    if (aspect > 1.0) return {-aspect, aspect, -1.0, 1.0};
    return {-1.0, 1.0, -1.0 / aspect, 1.0 / aspect};
}

}  // namespace

CameraRay cameraRay(const Camera& camera, const Film& film, double x, double y) {
    const auto [x0, x1, y0, y1] = screenWindow(camera, film);
    const double screen_x = x0 + (x1 - x0) * (x / film.width), screen_y = y1 - (y1 - y0) * (y / film.height);
    const dmat4 world_from_camera = glm::inverse(camera.camera_from_world);
    if (camera.projection == Projection::Orthographic)
        return {transformPoint(world_from_camera, {screen_x, screen_y, 0.0}),
                glm::normalize(dvec3(world_from_camera[2]))};
    const double tangent = std::tan(0.5 * glm::radians(camera.fov_degrees));
    const dvec3 direction = transformVector(world_from_camera, dvec3(screen_x * tangent, screen_y * tangent, 1.0));
    return {dvec3(world_from_camera[3]), glm::normalize(direction)};
}

}  // namespace dsphere::reference
