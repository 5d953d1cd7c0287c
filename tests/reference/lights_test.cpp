// Lights: densities that integrate to 1, irradiance against closed forms, and the definitions' corners. Estimates take
// a regular grid of numbers, so that what they miss is the grid's error and no chance.

#include "reference/lights.h"

#include "reference/quadrature.h"
#include "tests/reference/maps.h"
#include "tests/support/testcolours.h"

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace dsphere::reference::test {
namespace {

const dvec3 kUp(0.0, 0.0, 1.0);

Scene sceneOf(const decltype(Shape::geometry)& geometry, const dmat4& world_from_object, bool two_sided = false) {
    Scene scene;
    Shape shape;
    shape.geometry = geometry;
    shape.world_from_object = world_from_object;
    scene.shapes.push_back(shape);
    scene.lights.emplace_back(AreaLight{.shape = 0, .radiance = dvec3(2.0), .two_sided = two_sided});
    return scene;
}

Scene skyScene(const dmat3& turn = dmat3(1.0)) {
    Scene scene;
    scene.lights.emplace_back(
        InfiniteLight{.radiance = dvec3(3.0), .map_path = {}, .world_from_light = turn, .where = {}});
    return scene;
}

// The mean over count^2 midpoints of the unit square.
template <typename F>
double meanOf(int count, F f) {
    double sum = 0.0;
    for (int j = 0; j < count; ++j)
        for (int i = 0; i < count; ++i) sum += f(dvec2((i + 0.5) / count, (j + 0.5) / count));
    return sum / (double(count) * count);
}

double irradiance(const Lights& lights, const dvec3& point, const dvec3& n, int count = 200) {
    return meanOf(count, [&](const dvec2& u) {
        const LightSample sample = lights.sample(0, point, n, u);
        return std::max(0.0, glm::dot(n, sample.direction)) * sample.weight.r;
    });
}

// Every sample's density is what `density` says of its direction, and its weight the radiance seen there over it.
void expectConsistent(const Lights& lights, const dvec3& point, const dvec3& g, double radiance) {
    Random random(7);
    for (int k = 0; k < 1000; ++k) {
        const LightSample sample =
            lights.sample(0, point, g, dvec2(uniform(random, 0.0, 0.999), uniform(random, 0.001, 1.0)));
        EXPECT_NEAR(glm::length(sample.direction), 1.0, 1e-12);
        EXPECT_NEAR(lights.density(0, point, g, sample.direction) / sample.density, 1.0, 1e-8);
        if (radiance > 0.0) {
            EXPECT_NEAR(sample.weight.r * sample.density, radiance, 1e-12 * radiance);
        }
    }
}

TEST(Lights, SphereFromOutside) {
    const dmat4 place = glm::scale(glm::translate(dmat4(1.0), dvec3(0.0, 0.0, 5.0)), dvec3(-2.0, 2.0, 2.0));
    const Scene scene = sceneOf(Sphere{0.75}, place);
    const Lights lights(scene);
    // E = pi L sin^2(theta_max) when the sphere is straight above: midpoints are right to a few 1e-5.
    EXPECT_NEAR(irradiance(lights, dvec3(0.0), kUp), kPi * 2.0 * 0.09, 1e-5);
    // Aside and wholly above the horizon: times the cosine to its centre (Nusselt).
    const dvec3 n = glm::normalize(dvec3(0.0, 0.6, 0.8));
    EXPECT_NEAR(irradiance(lights, dvec3(0.0), n), kPi * 2.0 * 0.09 * 0.8, 1e-5);
    expectConsistent(lights, {1.0, -2.0, 0.5}, kUp, 2.0);
    const LightSample middle = lights.sample(0, dvec3(0.0), kUp, {0.0, 0.3});
    EXPECT_NEAR(middle.distance, 3.5, 1e-14);
    const LightSample rim = lights.sample(0, dvec3(0.0), kUp, {1.0, 0.3});
    EXPECT_NEAR(rim.distance, std::sqrt(25.0 - 2.25), 1e-6);
    EXPECT_NEAR(rim.direction.z, std::sqrt(0.91), 1e-14);
    // The cone is not seen beyond its rim, nor behind.
    EXPECT_EQ(lights.density(0, dvec3(0.0), kUp, glm::normalize(dvec3(0.0, 1.51, std::sqrt(25.0 - 2.28)))), 0.0);
    EXPECT_EQ(lights.density(0, dvec3(0.0), kUp, -kUp), 0.0);
    EXPECT_EQ(lights.sample(0, {0.0, 1.0, 5.0}, kUp, {0.5, 0.5}).weight, dvec3(0.0)) << "from inside";
    EXPECT_EQ(lights.emitter(0), 0);
}

TEST(Lights, FarSphereKeepsItsSolidAngle) {
    const Scene scene = sceneOf(Sphere{1.0}, glm::translate(dmat4(1.0), dvec3(0.0, 0.0, 1e8)));
    EXPECT_NEAR(irradiance(Lights(scene), dvec3(0.0), kUp, 20) / (kPi * 2.0 * 1e-16), 1.0, 1e-12);
}

TEST(Lights, Disk) {
    // Turned to shine down: its +z is the world's -z.
    const dmat4 place = glm::rotate(glm::scale(glm::translate(dmat4(1.0), dvec3(0.0, 0.0, 4.0)), dvec3(2.0)), kPi,
                                    dvec3(1.0, 0.0, 0.0));
    const Scene scene = sceneOf(Disk{.height = 0.5, .radius = 1.5}, place);
    const Lights lights(scene);
    // Coaxial, at distance d = 3 from a disk of radius 3: E = pi L r^2 / (r^2 + d^2).
    EXPECT_NEAR(irradiance(lights, dvec3(0.0), kUp), kPi * 2.0 * 0.5, 1e-4);
    expectConsistent(lights, {0.3, 1.0, -2.0}, kUp, 2.0);
    EXPECT_EQ(lights.sample(0, {0.0, 0.0, 6.0}, -kUp, {0.5, 0.5}).weight, dvec3(0.0)) << "from behind";
    const Scene both = sceneOf(Disk{.height = 0.5, .radius = 1.5}, place, true);
    EXPECT_NEAR(irradiance(Lights(both), {0.0, 0.0, 6.0}, -kUp), kPi * 2.0 * 0.5, 1e-4);
    // A ring is the disk less the hole.
    const Scene ring = sceneOf(Disk{.height = 0.5, .radius = 1.5, .inner_radius = 0.75}, place);
    EXPECT_NEAR(irradiance(Lights(ring), dvec3(0.0), kUp), kPi * 2.0 * (0.5 - 2.25 / 11.25), 1e-4);
    EXPECT_EQ(lights.emission(0, -kUp, -kUp), dvec3(2.0));
    EXPECT_EQ(lights.emission(0, -kUp, kUp), dvec3(0.0));
    EXPECT_EQ(Lights(both).emission(0, -kUp, kUp), dvec3(2.0));
}

TEST(Lights, ConstantSky) {
    const Scene scene = skyScene();
    const Lights lights(scene);
    for (const dvec3& n : {kUp, -kUp, glm::normalize(dvec3(0.2, -0.7, -0.1))}) {
        EXPECT_NEAR(irradiance(lights, dvec3(0.0), n, 10), kPi * 3.0, 1e-12) << "f cos / p has no variance";
        expectConsistent(lights, dvec3(0.0), n, 3.0);
        EXPECT_GT(glm::dot(lights.sample(0, dvec3(0.0), n, {1.0 - 0x1p-24, 0.1}).direction, n), 0.0);
    }
    EXPECT_EQ(lights.environment({1.0, 2.0, 3.0}), dvec3(3.0));
    EXPECT_EQ(lights.emitter(0), -1);
}

TEST(Lights, SkyImage) {
    const ColourMap image(dsphere::test::randomLight(16, 8), "sky");
    const dmat3 turn = dmat3(glm::rotate(dmat4(1.0), 0.7, glm::normalize(dvec3(1.0, 2.0, -1.0)))) * dmat3(-1.0);
    const Scene scene = skyScene(turn);
    const Lights lights(scene, &image);
    const dvec3 n = glm::normalize(dvec3(-0.3, 0.5, 0.1));
    expectConsistent(lights, dvec3(0.0), n, -1.0);
    // Over the sphere in panels that end at the texels' edges and middles.
    const GaussLegendre rule(4);
    double whole = 0.0, expected = 0.0;
    for (int j = 0; j < 16; ++j)
        for (int i = 0; i < 32; ++i)
            whole += rule.integral(j / 16.0, (j + 1) / 16.0, [&](double b) {
                return rule.integral(i / 32.0, (i + 1) / 32.0, [&](double a) {
                    const double sine = std::sin(kPi * b), area = 2.0 * kPi * kPi * sine;
                    const dvec3 l =
                        turn * dvec3(std::cos(2.0 * kPi * a) * sine, std::sin(2.0 * kPi * a) * sine, std::cos(kPi * b));
                    return area * lights.density(0, dvec3(0.0), n, l);
                });
            });
    EXPECT_NEAR(whole, 1.0, 1e-6);
    constexpr int kSteps = 600;
    expected = meanOf(kSteps, [&](const dvec2& place) {
        const double sine = std::sin(kPi * place.y);
        const dvec3 l = turn * dvec3(std::cos(2.0 * kPi * place.x) * sine, std::sin(2.0 * kPi * place.x) * sine,
                                     std::cos(kPi * place.y));
        return 2.0 * kPi * kPi * sine * std::max(0.0, glm::dot(n, l)) * lights.environment(l).r;
    });
    EXPECT_NEAR(irradiance(lights, dvec3(0.0), n, 1500) / expected, 1.0, 2e-3) << "black texels have bright neighbours";
}

// The place in the image of a direction, worked by hand: the top is +z, +x at the left edge, +y a quarter on.
TEST(Lights, SkyImageLiesAsDefined) {
    std::vector<float> light;
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 4; ++i) light.insert(light.end(), {float(i + 10 * j), 1.0f, 0.0f});
    const ColourMap image(dsphere::test::lightOf(4, 2, light), "numbered");
    const SkyImage sky(image);
    auto red = [&](double a, double b) {
        const double turn = 2.0 * kPi * a, sine = std::sin(kPi * b);
        return sky.radiance({std::cos(turn) * sine, std::sin(turn) * sine, std::cos(kPi * b)}).r;
    };
    EXPECT_NEAR(red(0.125, 0.25), 0.0, 1e-12);
    EXPECT_NEAR(red(0.375, 0.25), 1.0, 1e-12);
    EXPECT_NEAR(red(0.625, 0.75), 12.0, 1e-12);
    EXPECT_NEAR(red(0.0, 0.25), 1.5, 1e-12) << "half-way from column 3 to column 0";
    EXPECT_NEAR(red(0.25, 0.5), 5.5, 1e-12);
    EXPECT_NEAR(red(0.375, 0.01), 1.0, 1e-12) << "held to the pole";
    EXPECT_NEAR(red(0.375, 0.99), 11.0, 1e-12);
    // The mean red over a texel is 1/8, 3/4, 1/8 of the columns (0.5, 1, 2, 2.5), 7/8 and 1/8 of the rows; it weighs
    // 0.7152 + 0.2126 of that. u1 = 0 is the first one's left edge, u2 = 0 the top.
    const dvec3 first = sky.sample({0.0, 0.2}).direction;
    EXPECT_NEAR(first.y, 0.0, 1e-15);
    EXPECT_GT(first.x, 0.0);
    auto weight = [](double column) { return 0.7152 + 0.2126 * (column + 1.25); };
    const double row0 = 4 * 0.7152 + 0.2126 * (6.0 + 4 * 1.25), row1 = 4 * 0.7152 + 0.2126 * (6.0 + 4 * 8.75);
    const dvec3 at = sky.sample({(weight(0.5) + 0.5 * weight(1.0)) / row0, 0.5 * row0 / (row0 + row1)}).direction;
    EXPECT_NEAR(std::atan2(at.y, at.x), 0.75 * kPi, 1e-7) << "the middle of column 1";
    EXPECT_NEAR(at.z, std::cos(0.25 * kPi), 1e-7) << "the middle of row 0";
}

TEST(Lights, BlackSkyImageIsSampledEvenly) {
    const ColourMap image(dsphere::test::lightOf(2, 2, std::vector<float>(12, 0.0f)), "black");
    const SkyImage sky(image);
    EXPECT_NEAR(sky.sample({0.25, 0.5}).direction.z, 0.0, 1e-15);
    EXPECT_NEAR(sky.density({1.0, 0.0, 0.0}), 1.0 / (2.0 * kPi * kPi), 1e-15);
}

TEST(Lights, LampsHaveNoDensity) {
    Scene scene;
    scene.lights.emplace_back(PointLight{.position = {0.0, 0.0, 2.0}, .intensity = dvec3(8.0)});
    scene.lights.emplace_back(DistantLight{.direction = kUp, .radiance = dvec3(5.0)});
    const Lights lights(scene);
    const LightSample lamp = lights.sample(0, dvec3(0.0), kUp, {0.1, 0.2}), sun = lights.sample(1, kUp, kUp, {});
    EXPECT_EQ(lamp.weight, dvec3(2.0));
    EXPECT_EQ(lamp.distance, 2.0);
    EXPECT_EQ(sun.weight, dvec3(5.0));
    EXPECT_EQ(sun.direction, kUp);
    for (int k : {0, 1}) EXPECT_EQ(lights.density(k, dvec3(0.0), kUp, kUp), 0.0);
    const LightRay ray = lights.shadowRay(0, lamp, dvec3(0.0), {0.0, 0.0, 0.5});
    EXPECT_EQ(ray.direction, dvec3(0.0, 0.0, 1.5));
    EXPECT_EQ(ray.t_max, 1.0);
}

}  // namespace
}  // namespace dsphere::reference::test
