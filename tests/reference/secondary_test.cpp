// The rules of rays that start on the surface.

#include "reference/firsthit.h"
#include "tests/reference/maps.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dsphere::reference::test {
namespace {

using enum Registration;

/// The unit sphere with a ring of hills of height 0.5 all around at latitude 45 degrees north.
Heightmap ringMap() {
    return makeMap(16, 16, Texel, [](int, int j) { return j == 4 ? 1.0 : 0.0; });
}

FirstHit secondary(const Surface& surface, const dvec3& origin, const dvec3& direction,
                   double t_max = std::numeric_limits<double>::infinity()) {
    return firstHit(surface, {.origin = origin, .direction = direction, .t_max = t_max, .may_start_inside = false});
}

class Ring : public testing::Test {
  protected:
    Heightmap map_ = ringMap();
    Surface surface_{map_, makeRelief(1.0, 50.0)};
    const dvec3 ground_{0.0, 0.0, 1.0};  // on the equator, clear of the hills
};

TEST_F(Ring, OutwardFromJustInsideIsFree) {
    for (double below : {0.0, 1e-16, 1e-9, 1e-7, 2e-6}) {
        const dvec3 start = (1.0 - below) * ground_;
        EXPECT_FALSE(secondary(surface_, start, {0.0, 0.0, 1.0}).hit) << below;
        EXPECT_FALSE(secondary(surface_, start, {0.3, -0.4, 0.9}).hit) << below;
        EXPECT_FALSE(secondary(surface_, start, {1.0, 0.0, 0.02}).hit) << below;
    }
}

TEST_F(Ring, OutwardFromJustInsideStillMeetsTheHill) {
    const dvec3 hill = 1.45 * glm::normalize(dvec3(0.0, std::sin(0.25 * kPi - 0.1), std::cos(0.25 * kPi - 0.1)));
    for (double height : {-2e-6, -1e-9, -1e-16, 0.0, 1e-16, 1e-9, 2e-6}) {
        const dvec3 start = (1.0 + height) * ground_, target = surface_.radius(hill) * glm::normalize(hill);
        const FirstHit hit = secondary(surface_, start, target - start, 2.0);
        ASSERT_TRUE(hit.hit) << height;
        EXPECT_FALSE(hit.inside) << height;
        EXPECT_GT(hit.t_low, 0.1) << height;
        EXPECT_FALSE(secondary(surface_, start, target - start, 0.5 * hit.t_low).hit) << height;
    }
}

TEST_F(Ring, DownwardHitsAtOnce) {
    for (double height : {-1e-3, -2e-6, -1e-16, 0.0}) {
        const FirstHit hit = secondary(surface_, (1.0 + height) * ground_, {0.1, 0.0, -1.0});
        EXPECT_TRUE(hit.hit && (hit.inside || hit.t_high < 1e-12)) << height;
    }
    const FirstHit above = secondary(surface_, (1.0 + 2e-6) * ground_, {0.0, 0.0, -1.0});
    EXPECT_TRUE(above.hit && !above.inside);
    EXPECT_NEAR(above.t(), 2e-6, 1e-13);
}

TEST_F(Ring, StayingInsideToTheEndHits) {
    const FirstHit hit = secondary(surface_, 0.9 * ground_, {0.0, 0.0, 1.0}, 0.05);
    EXPECT_TRUE(hit.hit && hit.inside);
    EXPECT_EQ(hit.t_low, 0.0);
    EXPECT_FALSE(secondary(surface_, 0.9 * ground_, {0.0, 0.0, 1.0}, 0.2).hit);
}

TEST_F(Ring, CameraRayThereIsInside) {
    const FirstHit hit = firstHit(surface_, {.origin = 0.999 * ground_, .direction = {0.0, 0.0, 1.0}});
    EXPECT_TRUE(hit.hit && hit.inside);
}

TEST(Secondary, LeavingRoughGroundStraightUpIsFree) {
    for (Registration registration : {Texel, Gridline}) {
        const Heightmap map = noiseMap(24, 13, registration, 1);
        const Surface surface(map, makeRelief(1.0, 30.0));
        Random random(2);
        for (int k = 0; k < 3000; ++k) {
            const dvec3 w = k == 0 ? dvec3(0.0, 1.0, 0.0) : k == 1 ? dvec3(0.0, -1.0, 0.0) : randomUnit(random);
            const double radius = surface.radius(w);
            for (double height : {-1e-9, 0.0, 1e-9}) {
                EXPECT_FALSE(secondary(surface, (radius + height) * w, w).hit);
                EXPECT_TRUE(secondary(surface, (radius + height) * w, -w).hit);
            }
        }
    }
}

}  // namespace
}  // namespace dsphere::reference::test
