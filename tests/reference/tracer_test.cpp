#include "scene/ramps.h"
#include "tests/reference/maps.h"
#include "tests/reference/plaintracer.h"

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace dsphere::reference::test {
namespace {

const dmat4 kOne(1.0);

void expectNear(const dvec3& a, const dvec3& b, double tolerance = 1e-13) {
    EXPECT_LT(glm::length(a - b), tolerance) << a.x << ' ' << a.y << ' ' << a.z;
}

Shape shape(const Geometry& geometry, const dmat4& world_from_object) {
    Shape shape;
    shape.geometry = geometry;
    shape.world_from_object = world_from_object;
    return shape;
}

TEST(Tracer, NearestShapeAndItsNormal) {
    Scene scene;
    scene.shapes.push_back(shape(Sphere{1.0}, glm::translate(kOne, dvec3(0.0, 0.0, 5.0))));
    scene.shapes.push_back(shape(Disk{.height = 0.0, .radius = 2.0}, glm::translate(kOne, dvec3(0.0, 0.0, 2.0))));
    scene.shapes.push_back(shape(Sphere{0.5}, glm::translate(kOne, dvec3(3.0, 0.0, 4.0))));
    const Tracer tracer = plainTracer(scene);
    const WorldHit disk = tracer.firstHit({0.0, 0.0, 0.0}, {0.0, 0.0, 2.0});
    EXPECT_EQ(disk.shape, 1);
    EXPECT_DOUBLE_EQ(disk.t(), 1.0);
    expectNear(disk.position, {0.0, 0.0, 2.0});
    expectNear(disk.normal, {0.0, 0.0, 1.0});
    expectNear(disk.shading_normal, {0.0, 0.0, -1.0});
    const WorldHit sphere = tracer.firstHit({0.0, 0.0, 10.0}, {0.0, 0.0, -1.0});
    EXPECT_EQ(sphere.shape, 0);
    EXPECT_DOUBLE_EQ(sphere.t(), 4.0);
    expectNear(sphere.normal, {0.0, 0.0, 1.0});
    expectNear(sphere.object_position, {0.0, 0.0, 1.0});
    EXPECT_EQ(tracer.firstHit({3.0, 0.0, 0.0}, {0.0, 0.0, 1.0}).shape, 2);
    EXPECT_FALSE(tracer.firstHit({10.0, 0.0, 0.0}, {0.0, 0.0, 1.0}).hit);
    EXPECT_EQ(tracer.surface(0), nullptr);
}

TEST(Tracer, TransformsCarryHitsAndNormals) {
    // The unit sphere stretched to the ellipsoid (x/3)^2 + (y/1)^2 + (z/2)^2 = 1, mirrored, turned and moved.
    const dmat4 stretch = glm::scale(kOne, dvec3(-3.0, 1.0, 2.0));
    const dmat4 turn = glm::rotate(kOne, 0.5 * kPi, dvec3(0.0, 0.0, 1.0)),
                move = glm::translate(kOne, dvec3(0.0, 0.0, 10.0));
    const Heightmap flat = flatMap(8, 4, Registration::Texel, 0.0);
    Scene scene;
    scene.shapes.push_back(shape(Sphere{1.0}, move * turn * stretch));
    Scene same = scene;
    same.shapes[0].geometry = DisplacedSphere{};
    const Tracer plain = plainTracer(scene), displaced(same, {&flat}, {makeRelief(1.0, 10.0)});
    for (const Tracer* tracer : {&plain, &displaced}) {
        // In the world the long axis now lies along y.
        const WorldHit top = tracer->firstHit({0.0, 10.0, 10.0}, {0.0, -1.0, 0.0});
        ASSERT_TRUE(top.hit);
        EXPECT_NEAR(top.t(), 7.0, 1e-13);
        expectNear(top.normal, {0.0, 1.0, 0.0});
        const WorldHit side = tracer->firstHit({0.0, 1.5, 0.0}, {0.0, 0.0, 1.0});
        ASSERT_TRUE(side.hit);
        const double z = -2.0 * std::sqrt(0.75);
        expectNear(side.position, {0.0, 1.5, 10.0 + z});
        expectNear(side.normal, glm::normalize(dvec3(0.0, 1.5 / 9.0, z / 4.0)));
        EXPECT_NEAR(tracer->firstHit({0.5, 0.0, 0.0}, {0.0, 0.0, 1.0}).position.z, 10.0 + z, 1e-13);
    }
}

TEST(Tracer, DisplacedSphereFacesTheRightWay) {
    // One high texel at longitude 90 degrees east (+x), on the equator of a gridline map.
    const Heightmap map =
        makeMap(4, 3, Registration::Gridline, [](int i, int j) { return i == 3 && j == 1 ? 1.0 : 0.0; });
    Scene scene;
    scene.shapes.push_back(shape(DisplacedSphere{}, glm::rotate(kOne, 0.5 * kPi, dvec3(0.0, 1.0, 0.0))));
    const Tracer tracer(scene, {&map}, {makeRelief(1.0, 50.0)});
    // The turn carries +x to -z.
    EXPECT_NEAR(tracer.firstHit({0.0, 0.0, -5.0}, {0.0, 0.0, 1.0}).t(), 3.5, 1e-13);
    EXPECT_NEAR(tracer.firstHit({0.0, 0.0, 5.0}, {0.0, 0.0, -1.0}).t(), 4.0, 1e-13);
    EXPECT_TRUE(tracer.firstHit({0.1, 0.0, 0.0}, {0.0, 0.0, 1.0}).inside);
}

TEST(Tracer, Occlusion) {
    Scene scene;
    scene.shapes.push_back(shape(Sphere{1.0}, kOne));
    scene.shapes.push_back(shape(Disk{.height = -1.0, .radius = 5.0}, kOne));
    const Tracer tracer = plainTracer(scene);
    const double far = std::numeric_limits<double>::infinity();
    // From the disk, beside and below the sphere.
    const dvec3 beside(3.0, 0.0, -1.0 + 1e-6), below(0.5, 0.0, -1.0 + 1e-6);
    EXPECT_FALSE(tracer.occluded(beside, {0.0, 0.0, 1.0}, far, 1, beside));
    EXPECT_TRUE(tracer.occluded(below, {0.0, 0.0, 1.0}, far, 1, below));
    EXPECT_FALSE(tracer.occluded(below, {0.0, 0.0, 1.0}, 0.01, 1, below));
    EXPECT_TRUE(tracer.occluded(beside, {0.0, 0.0, -1.0}, far, 1, beside));
    // From the sphere outward, whatever its world position was rounded to; and into it.
    const dvec3 top(0.0, 0.0, 1.0 - 1e-9);
    EXPECT_FALSE(tracer.occluded(top, {0.1, 0.0, 1.0}, far, 0, top));
    EXPECT_TRUE(tracer.occluded(top, {0.1, 0.0, -1.0}, far, 0, top));
    EXPECT_FALSE(tracer.occluded({0.0, 0.0, 0.5}, {0.1, 0.0, 1.0}, far, 0, {0.0, 0.0, 1.0 + 1e-9}));
}

TEST(Tracer, LambertUnderSunAndLamp) {
    Scene scene;
    scene.shapes.push_back(shape(Sphere{1.0}, glm::scale(kOne, dvec3(2.0))));
    *textureOf(scene.shapes[0].material) = ConstantColour{{0.5, 0.25, 1.0}};
    scene.lights.emplace_back(DistantLight{.direction = {0.0, 0.6, 0.8}, .radiance = {3.0, 3.0, 6.0}});
    scene.lights.emplace_back(PointLight{.position = {0.0, 0.0, 5.0}, .intensity = {9.0, 18.0, 9.0}});
    scene.lights.emplace_back(DistantLight{.direction = {0.0, 0.0, -1.0}, .radiance = dvec3(100.0)});
    const Tracer tracer = plainTracer(scene);
    const dvec3 north(0.0, 0.0, 1.0);  // world (0, 0, 2): the lamp is 3 away
    const ShadingPoint top{0, north, {0.0, 0.0, 2.0}, {north, north}, north};
    auto shade = [&](std::uint32_t lit) { return tracer.directLight(top, {}, lit); };
    expectNear(shade(1), dvec3(0.5, 0.25, 1.0) / kPi * dvec3(2.4, 2.4, 4.8));
    expectNear(shade(2), dvec3(0.5, 0.25, 1.0) / kPi * dvec3(1.0, 2.0, 1.0));
    expectNear(shade(7), dvec3(0.5, 0.25, 1.0) / kPi * dvec3(3.4, 4.4, 5.8));
    expectNear(shade(4), dvec3(0.0));
    expectNear(shade(0), dvec3(0.0));
    const LightRay lamp = lightRay(scene.lights[1], {0.0, 0.0, 2.0});
    EXPECT_EQ(lamp.direction, dvec3(0.0, 0.0, 3.0));
    EXPECT_EQ(lamp.t_max, 1.0);
    EXPECT_TRUE(std::isinf(lightRay(scene.lights[0], {}).t_max));
}

TEST(Tracer, HeightRampColoursByHeight) {
    const Ramp& ramp = ramps()[0];
    Heightmap map = makeMap(8, 4, Registration::Texel, [](int i, int) { return 1000.0 * i; });
    Relief relief = makeRelief(1.0, 1e-3);
    relief.h_scale = 1.0 / 8000.0;
    relief.h_offset = 0.0625;
    Scene scene;
    scene.shapes.push_back(shape(DisplacedSphere{}, kOne));
    HeightRamp by_height;
    by_height.ramp = ramp.name;
    *textureOf(scene.shapes[0].material) = by_height;
    const Tracer tracer(scene, {&map}, {relief});
    // Texel 4 is centred at longitude 22.5 degrees: h = 4000 / 8000 + 1/16.
    const double longitude = kPi / 8;
    const dvec3 p(std::sin(longitude), 0.0, std::cos(longitude));
    expectNear(tracer.reflectance(0, p), rampColour(ramp, 0.5625));
    by_height.scale = {2.0, 0.5, 100.0};
    *textureOf(scene.shapes[0].material) = by_height;
    expectNear(tracer.reflectance(0, p), glm::min(by_height.scale * rampColour(ramp, 0.5625), dvec3(1.0)));
}

}  // namespace
}  // namespace dsphere::reference::test
