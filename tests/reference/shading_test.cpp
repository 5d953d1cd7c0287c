// Direct light with the sample numbers of pictures: over a pixel's samples it comes to the closed form.

#include "tests/reference/plaintracer.h"

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace dsphere::reference::test {
namespace {

const dvec3 kNorth(0.0, 0.0, 1.0);

/// A floor at z = 0 and above its middle a shape that shines.
Scene floorUnder(const decltype(Shape::geometry)& emitter, const dmat4& place) {
    Scene scene;
    Shape floor, lamp;
    floor.geometry = Disk{.height = 0.0, .radius = 10.0};
    floor.material = Matte{};
    lamp.geometry = emitter;
    lamp.world_from_object = place;
    scene.shapes = {floor, lamp};
    scene.lights.emplace_back(AreaLight{.shape = 1, .radiance = dvec3(4.0), .two_sided = false});
    return scene;
}

const ShadingPoint kMiddle{0, dvec3(0.0), dvec3(0.0), {kNorth, kNorth}, kNorth};

/// The mean over a pixel's first 1024 samples: stratified, so right to about 1e-3.
double meanOf(const Tracer& tracer, const ShadingPoint& point) {
    double sum = 0.0;
    for (std::uint32_t index = 0; index < 1024; ++index) {
        const SampleSource source{17, 4, 0, index};
        sum += tracer.directLight(point, source, tracer.litLights(point, source)).g / 1024.0;
    }
    return sum;
}

TEST(DirectLight, BallAboveAFloor) {
    const Scene scene = floorUnder(Sphere{1.0}, glm::translate(dmat4(1.0), dvec3(0.0, 0.0, 3.0)));
    EXPECT_NEAR(meanOf(plainTracer(scene), kMiddle), 0.5 * 4.0 / 9.0, 1e-3);
}

TEST(DirectLight, HalfOfADiskIsHidden) {
    const dmat4 down = glm::rotate(glm::translate(dmat4(1.0), dvec3(0.0, 0.0, 2.0)), kPi, dvec3(1.0, 0.0, 0.0));
    Scene scene = floorUnder(Disk{.height = 0.0, .radius = 2.0}, down);
    EXPECT_NEAR(meanOf(plainTracer(scene), kMiddle), 0.5 * 4.0 * 0.5, 2e-3);
    // A wall whose edge is above the middle: x > 0 is hidden.
    Shape wall;
    wall.geometry = TriangleMesh{
        .points = {{0, -9, 1}, {9, -9, 1}, {9, 9, 1}, {0, 9, 1}}, .triangles = {{0, 1, 2}, {0, 2, 3}}, .uvs = {}};
    scene.shapes.push_back(wall);
    EXPECT_NEAR(meanOf(plainTracer(scene), kMiddle), 0.5 * 4.0 * 0.25, 4e-3);
}

TEST(DirectLight, EmittersShineFromTheirFront) {
    const Scene scene =
        floorUnder(Disk{.height = 0.0, .radius = 2.0}, glm::translate(dmat4(1.0), dvec3(0.0, 0.0, 2.0)));
    const Tracer tracer = plainTracer(scene);
    // It shines upward: the floor is dark, and so is its lower side.
    EXPECT_EQ(meanOf(tracer, kMiddle), 0.0);
    for (double side : {1.0, -1.0}) {
        const dvec3 towards = side * kNorth;
        const ShadingPoint seen = tracer.shadingPoint(tracer.firstHit({0.5, 0.5, 2.0 + side}, -towards), -towards);
        ASSERT_EQ(seen.shape, 1);
        EXPECT_EQ(tracer.directLight(seen, {}, 0), dvec3(side > 0.0 ? 4.0 : 0.0));
        EXPECT_EQ(tracer.emission(seen), dvec3(side > 0.0 ? 4.0 : 0.0));
    }
}

TEST(DirectLight, MirrorsAreBlack) {
    Scene scene = floorUnder(Sphere{1.0}, glm::translate(dmat4(1.0), dvec3(0.0, 0.0, 3.0)));
    scene.shapes[0].material = Mirror{};
    EXPECT_EQ(meanOf(plainTracer(scene), kMiddle), 0.0);
    EXPECT_EQ(plainTracer(scene).litLights(kMiddle, {}), 1u) << "lit has nothing to do with the material";
}

// Smooth normals turned away from the viewer: facets are not seen, diffuse light is.
TEST(DirectLight, ViewerBelowTheSmoothHorizon) {
    Scene scene = floorUnder(Sphere{1.0}, glm::translate(dmat4(1.0), dvec3(0.0, 0.0, 3.0)));
    scene.shapes[0].material = Plastic{.diffuse = ConstantColour{dvec3(0.5)}, .specular = dvec3(1.0), .alpha = 0.5};
    ShadingPoint point = kMiddle;
    point.normals.smooth = glm::normalize(dvec3(0.5, 0.0, 1.0));
    point.towards_viewer = glm::normalize(dvec3(-1.0, 0.0, 0.1));
    const dvec3 plastic = plainTracer(scene).directLight(point, {}, 1);
    scene.shapes[0].material = Matte{};
    EXPECT_EQ(plastic, plainTracer(scene).directLight(point, {}, 1));
    scene.shapes[0].material = Conductor{};
    EXPECT_EQ(plainTracer(scene).directLight(point, {}, 1), dvec3(0.0));
}

}  // namespace
}  // namespace dsphere::reference::test
