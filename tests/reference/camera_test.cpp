#include "reference/camera.h"

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace dsphere::reference {
namespace {

void expectNear(const dvec3& a, const dvec3& b) {
    EXPECT_LT(glm::length(a - b), 1e-15) << a.x << ' ' << a.y << ' ' << a.z;
}

TEST(Camera, LandscapeAndPortrait) {
    Camera camera;
    camera.fov_degrees = 90.0;
    Film film;
    film.width = 200;
    film.height = 100;
    expectNear(cameraRay(camera, film, 100.0, 50.0).direction, {0.0, 0.0, 1.0});
    expectNear(cameraRay(camera, film, 0.0, 0.0).direction, glm::normalize(dvec3(-2.0, 1.0, 1.0)));
    expectNear(cameraRay(camera, film, 200.0, 100.0).direction, glm::normalize(dvec3(2.0, -1.0, 1.0)));
    expectNear(cameraRay(camera, film, 150.0, 25.0).origin, {0.0, 0.0, 0.0});
    std::swap(film.width, film.height);
    expectNear(cameraRay(camera, film, 0.0, 0.0).direction, glm::normalize(dvec3(-1.0, 2.0, 1.0)));
    camera.fov_degrees = 60.0;
    const double half = std::tan(kPi / 6.0);
    expectNear(cameraRay(camera, film, 0.0, 0.0).direction, glm::normalize(dvec3(-half, 2.0 * half, 1.0)));
}

TEST(Camera, WindowAndFrame) {
    Camera camera;
    camera.fov_degrees = 90.0;
    camera.screen_window = {{-0.5, 1.5, 0.25, 0.75}};
    Film film;
    film.width = 64;
    film.height = 32;
    expectNear(cameraRay(camera, film, 0.0, 0.0).direction, glm::normalize(dvec3(-0.5, 0.75, 1.0)));
    expectNear(cameraRay(camera, film, 64.0, 32.0).direction, glm::normalize(dvec3(1.5, 0.25, 1.0)));
    camera.screen_window.reset();
    camera.frame_aspect_ratio = 0.5;
    expectNear(cameraRay(camera, film, 0.0, 0.0).direction, glm::normalize(dvec3(-1.0, 2.0, 1.0)));
}

TEST(Camera, StandsWhereTheTransformSays) {
    Camera camera;
    camera.fov_degrees = 90.0;
    // pbrt's LookAt 0 0 -5  0 0 0  0 1 0, mirrored as the assets are: world x runs to the left.
    const dmat4 mirror = glm::scale(dmat4(1.0), dvec3(-1.0, 1.0, 1.0));
    camera.camera_from_world = mirror * glm::translate(dmat4(1.0), dvec3(0.0, 0.0, 5.0));
    Film film;
    film.width = film.height = 10;
    const CameraRay ray = cameraRay(camera, film, 10.0, 5.0);
    expectNear(ray.origin, {0.0, 0.0, -5.0});
    expectNear(ray.direction, glm::normalize(dvec3(-1.0, 0.0, 1.0)));
}

}  // namespace
}  // namespace dsphere::reference
