// Image maps on the device against the reference: every pixel's colour, every kind of shape, sizes down to one texel.

#include "tests/conformance/fixture.h"
#include "tests/support/testcolours.h"
#include "tests/support/testmaps.h"

namespace dsphere::conformance {
namespace {

using Colours = Conformance;

/// Gives the last shape an image.
void paint(World& world, RawColour raw, double scale = 1.0) {
    world.maps.images.push_back(std::make_unique<ColourMap>(std::move(raw), "random"));
    world.maps.image_of_shape.resize(world.scene.shapes.size(), -1);
    world.maps.image_of_shape.back() = int(world.maps.images.size()) - 1;
    *textureOf(world.scene.shapes.back().material) = ImageMap{"random", dvec3(scale), -180.0, {}};
}

World planet(double longitude_origin = -180.0) {
    DisplacedSphere sphere;
    sphere.max_displacement = 8.0;
    sphere.longitude_origin = longitude_origin;
    World world = sphereWorld(test::fractalMap(128, 64), sphere);
    world.addSun(dvec3(1.5, 1.8, 1.9));
    world.lookAt({2.4, 1.2, 1.6}, dvec3(0.0), dvec3(0.0, 1.0, 0.0), 42.0);
    return world;
}

void expectColours(const World& world, std::uint64_t least = 8000) {
    const verify::Report report = picture(world).report;
    expectContract(report);
    EXPECT_GE(report.colours, least);
    EXPECT_LE(report.worst_colour, 1.0);
}

TEST_F(Colours, OfEverySize) {
    for (const auto& [width, height] : {std::pair{1, 1}, {2, 1}, {1, 2}, {3, 2}, {64, 32}, {257, 129}, {2048, 1024}}) {
        SCOPED_TRACE(std::to_string(width) + "x" + std::to_string(height));
        World codes = planet(), light = planet(33.0);
        paint(codes, test::randomCodes(width, height));
        expectColours(codes);
        paint(light, test::randomLight(width, height), 1.5);
        expectColours(light);
    }
}

TEST_F(Colours, AtThePoleAndTheSeam) {
    for (const dvec3& eye : {dvec3(0.01, 1.6, 0.02), dvec3(0.01, -1.6, -0.02), dvec3(0.001, 0.1, -1.6)}) {
        World world = planet();
        paint(world, test::randomCodes(16, 8));
        world.lookAt(eye, dvec3(0.0), dvec3(0.6, 0.1, 0.7), 60.0);
        expectColours(world);
    }
}

TEST_F(Colours, OnSpheresAndDisks) {
    World world = planet();
    paint(world, test::randomCodes(64, 32));
    world.addPlain(Sphere{0.7}, translation({1.3, 0.6, -0.4}));
    paint(world, test::randomCodes(32, 16, 2));
    world.addPlain(Disk{.height = 0.2, .radius = 1.9, .inner_radius = 1.3}, turned(70.0));
    paint(world, test::randomLight(40, 9, 3));
    world.addPlain(Disk{.radius = 0.8}, translation({0.0, -1.2, 0.7}));
    paint(world, test::randomLight(5, 4, 4), 0.5);
    world.addPlain(Sphere{0.3}, translation({0.6, 1.1, 0.9}));  // the plain colour beside the images
    expectColours(world);
}

// Texel (2, 1) of 8x4 is centred at longitude -67.5 and latitude 22.5. A pixel that sees it has its colour.
TEST_F(Colours, ATexelLiesWhereItsHeightWould) {
    std::vector<float> light(3 * 8 * 4, 0.0f);
    light[3 * (1 * 8 + 2) + 1] = 0.75f;
    World world = planet();
    paint(world, test::lightOf(8, 4, light));
    const dvec3 towards = direction(glm::radians(-67.5), glm::radians(22.5));
    world.lookAt(3.0 * towards, dvec3(0.0), dvec3(0.0, 1.0, 0.0), 30.0);
    world.scene.film.width = world.scene.film.height = 151;
    const verify::Outcome outcome = picture(world);
    expectContract(outcome.report);
    const std::size_t middle = 75 * 151 + 75;
    EXPECT_NEAR(outcome.device.at("Albedo.G").floats()[middle], 0.75f, 1e-3);
    EXPECT_EQ(outcome.device.at("Albedo.R").floats()[middle], 0.0f);
}

}  // namespace
}  // namespace dsphere::conformance
