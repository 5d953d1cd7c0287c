// Where the ground is under a point, against the surface of the first hit.

#include "reference/ground.h"

#include "reference/surface.h"
#include "tests/reference/maps.h"

#include <gtest/gtest.h>

#include <random>

namespace dsphere::reference {
namespace {

Scene sceneOf(DisplacedSphere sphere) {
    Scene scene;
    scene.shapes.push_back({.geometry = std::move(sphere), .material = Material{}, .where = {"a.pbrt", 3, 1}});
    return scene;
}

SceneMaps mapsOf(const Scene& scene, RawMap raw) {
    const auto& sphere = std::get<DisplacedSphere>(scene.shapes[0].geometry);
    SceneMaps maps;
    maps.maps.push_back(std::make_unique<Heightmap>(makeHeightmap(std::move(raw), sphere)));
    maps.map_of_shape = {0};
    maps.reliefs = {makeRelief(sphere, *maps.maps[0], scene.shapes[0].where)};
    return maps;
}

RawMap steps() {
    RawMap raw;
    raw.width = 8, raw.height = 4;
    for (int i = 0; i < 32; ++i) raw.samples.push_back(float(i * 7 % 5) / 5.0f);
    return raw;
}

TEST(Ground, IsTheSurfacesRadius) {
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    for (int form = 0; form < 4; ++form) {
        DisplacedSphere sphere;
        sphere.max_displacement = 20.0;
        if (form == 1) sphere.filter = Filter::BSpline;
        if (form == 2) sphere.ripples = Ripples{5, 3};
        if (form == 3) sphere.registration = Registration::Gridline, sphere.filter = Filter::BSpline;
        const Scene scene = sceneOf(sphere);
        const SceneMaps maps = mapsOf(scene, steps());
        const Surface surface(*maps.maps[0], maps.reliefs[0]);
        for (int i = 0; i < 200; ++i) {
            const dvec3 w = glm::normalize(dvec3(normal(random), normal(random), normal(random)));
            EXPECT_NEAR(radiusTowards(*maps.maps[0], maps.reliefs[0], w), surface.radius(w), 1e-14) << form;
        }
        for (const dvec3& pole : {dvec3(0, 1, 0), dvec3(0, -1, 0)})
            EXPECT_NEAR(radiusTowards(*maps.maps[0], maps.reliefs[0], pole), surface.radius(pole), 1e-14) << form;
    }
}

TEST(Ground, BuriedEyesAreWarnedOf) {
    DisplacedSphere sphere;
    sphere.max_displacement = 20.0;
    Scene scene = sceneOf(sphere);
    scene.shapes[0].world_from_object[3] = dvec4(0.0, 0.0, 5.0, 1.0);
    scene.shapes.push_back({.geometry = Sphere{0.5}, .material = Material{}, .where = {"a.pbrt", 4, 1}});
    SceneMaps maps = mapsOf(scene, steps());
    maps.map_of_shape.push_back(-1);
    maps.reliefs.push_back({});
    const auto warnings = [&](const dvec3& eye) {
        scene.camera.camera_from_world[3] = dvec4(-eye, 1.0);
        return warnOfBuriedEye(scene, maps);
    };
    const Surface surface(*maps.maps[0], maps.reliefs[0]);
    const double ground = surface.radius({0.0, 0.0, -1.0});
    EXPECT_TRUE(warnings({0.0, 0.0, 5.0 - ground - 1e-6}).empty());
    ASSERT_EQ(warnings({0.0, 0.0, 5.0 - ground + 1e-6}).size(), 1u);
    EXPECT_EQ(warnings({0.0, 0.0, 5.0 - ground + 1e-6})[0].text.find("a.pbrt:3:1: the eye lies inside"), 0u);
    EXPECT_EQ(warnings({0.0, 0.0, 5.0}).size(), 1u) << "the centre";
    EXPECT_EQ(warnings({0.0, 0.0, 0.4}).size(), 1u) << "a plain sphere";
    EXPECT_TRUE(warnings({0.0, 0.5, 0.0}).empty()) << "exactly on it";
}

}  // namespace
}  // namespace dsphere::reference
