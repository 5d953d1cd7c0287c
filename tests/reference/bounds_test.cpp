#include "reference/surface.h"
#include "tests/reference/maps.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dsphere::reference::test {
namespace {

using enum Registration;

void expectEnclosure(const Surface& surface, double u0, double u1, double v0, double v1, Random& random) {
    const RadiusBounds bounds = surface.bounds(u0, u1, v0, v1);
    EXPECT_GE(bounds.lower, surface.leastRadius());
    EXPECT_LE(bounds.upper, surface.greatestRadius());
    for (int k = 0; k < 40; ++k) {
        // Corners first, then anywhere.
        const double u = k < 4 ? (k & 1 ? u1 : u0) : uniform(random, u0, u1);
        const double v = k < 4 ? (k & 2 ? v1 : v0) : uniform(random, v0, v1);
        const double r = surface.radius(direction(u, v));
        EXPECT_LE(bounds.lower, r + surface.evaluationError()) << u << ' ' << v;
        EXPECT_GE(bounds.upper, r - surface.evaluationError()) << u << ' ' << v;
    }
}

TEST(Bounds, EncloseAnyRectangle) {
    struct {
        int width, height;
        Registration registration;
    } shapes[] = {{1, 1, Texel},   {2, 1, Texel},     {3, 2, Gridline},     {3, 2, Texel},    {8, 4, Texel},
                  {37, 19, Texel}, {257, 129, Texel}, {257, 129, Gridline}, {1024, 2, Texel}, {1000, 500, Gridline}};
    for (const auto& shape : shapes) {
        Heightmap map = noiseMap(shape.width, shape.height, shape.registration, 1);
        map.longitude_origin = 12.5;
        for (double percent : {60.0, -60.0}) {
            const Surface surface(map, makeRelief(2.0, percent));
            Random random(2);
            for (int k = 0; k < 1500; ++k) {
                const double width = std::pow(10.0, -uniform(random, 0.0, 5.0)),
                             tall = std::pow(10.0, -uniform(random, 0.0, 5.0));
                const double u0 = uniform(random, -1.5, 1.5);
                const double v0 = k % 5 == 0 ? 0.0 : k % 5 == 1 ? 1.0 - tall : uniform(random, 0.0, 1.0 - tall);
                expectEnclosure(surface, u0, u0 + width, v0, std::min(1.0, v0 + tall), random);
            }
        }
    }
}

TEST(Bounds, AreTightInACell) {
    const Heightmap map = noiseMap(16, 8, Texel, 3);
    const Surface surface(map, makeRelief(1.0, 50.0));
    // Cell between texel centres (4, 3) and (5, 4): its bounds are its corners.
    const RadiusBounds bounds = surface.bounds(4.51 / 16, 5.49 / 16, 3.51 / 8, 4.49 / 8);
    const auto [least, greatest] = std::minmax({map.at(4, 3), map.at(5, 3), map.at(4, 4), map.at(5, 4)});
    EXPECT_NEAR(bounds.lower, 1.0 + 0.5 * least, 1e-14);
    EXPECT_NEAR(bounds.upper, 1.0 + 0.5 * greatest, 1e-14);
}

TEST(Bounds, ShrinkTowardsThePole) {
    const Heightmap map = noiseMap(1024, 512, Texel, 4);
    const Surface surface(map, makeRelief(1.0, 50.0));
    for (double v : {0.0, 1.0}) {
        const double pole = surface.radius({0.0, 1.0 - 2.0 * v, 0.0});
        const RadiusBounds bounds =
            v == 0.0 ? surface.bounds(0.0, 0.5, 0.0, 1e-9) : surface.bounds(0.0, 0.5, 1.0 - 1e-9, 1.0);
        EXPECT_LE(bounds.lower, pole);
        EXPECT_GE(bounds.upper, pole);
        EXPECT_LT(bounds.upper - bounds.lower, 2e-6);
    }
}

}  // namespace
}  // namespace dsphere::reference::test
