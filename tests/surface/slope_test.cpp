// The proven bound of |grad f| against the reference's gradient.

#include "surface/slope.h"

#include "reference/surface.h"
#include "tests/support/testmaps.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dsphere {
namespace {

struct SlopeCase {
    const char* map;
    int width, height;
    double percent;
    Registration registration = Registration::Texel;
};

void PrintTo(const SlopeCase& c, std::ostream* out) {
    *out << c.map << ' ' << c.width << 'x' << c.height << ' ' << c.percent << " %";
}

class SlopeTest : public testing::TestWithParam<SlopeCase> {};

// Points just outside the surface, dense at the poles, where longitude is steepest.
TEST_P(SlopeTest, BoundsEveryGradient) {
    const SlopeCase& c = GetParam();
    DisplacedSphere sphere;
    sphere.max_displacement = c.percent;
    sphere.registration = c.registration;
    Heightmap map = makeHeightmap(test::namedMap(c.map, c.width, c.height), sphere);
    Relief relief = makeRelief(sphere, map, {"slope"});
    reference::Surface surface(map, relief);
    double bound = gradientBound(NodeGrid(map), relief.base, relief.scale), steepest = 0.0;
    for (int j = 1; j < 400; ++j)
        for (int i = 0; i < 997; ++i) {
            double share = j / 400.0, theta = kPi * share * share * (3.0 - 2.0 * share),
                   phi = 2.0 * kPi * (i + 0.37) / 997;
            dvec3 w(std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi));
            steepest = std::max(steepest, glm::length(surface.gradient(surface.radius(w) * w)));
        }
    EXPECT_LE(steepest, bound);
    EXPECT_GE(bound, 1.0);
    EXPECT_LE(bound, 20.0 * steepest) << "a bound that loose would be of no use";
}

INSTANTIATE_TEST_SUITE_P(Maps, SlopeTest,
                         testing::Values(SlopeCase{"fractal", 512, 256, 5.0}, SlopeCase{"fractal", 600, 300, -20.0},
                                         SlopeCase{"random", 512, 256, 50.0}, SlopeCase{"spikes", 520, 260, 60.0},
                                         SlopeCase{"checkerboard", 512, 256, 25.0}, SlopeCase{"random", 7, 5, 30.0},
                                         SlopeCase{"fractal", 512, 257, 20.0, Registration::Gridline}));

TEST(Slope, OfASmoothSphereIsOne) {
    Heightmap map = makeHeightmap(test::constantMap(512, 256, 0.5f), {});
    EXPECT_NEAR(gradientBound(NodeGrid(map), 1.0, 0.1), 1.0, 2e-6);
}

}  // namespace
}  // namespace dsphere
