// Rays through, along and beside the axis, in coordinate planes, and through the corners of cells.

#include "tests/reference/agree.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dsphere::reference::test {
namespace {

using enum Registration;

class Special : public testing::TestWithParam<Registration> {
  protected:
    Special() : map_(noiseMap(16, 8, GetParam(), 1)), surface_(map_, relief_), oracle_(map_, relief_) {}

    void expectHit(const dvec3& origin, const dvec3& direction, int samples = 20000) {
        const Ray ray{.origin = origin, .direction = direction};
        expectAgreement("special", surface_, oracle_, ray, samples, tally_);
    }

    Relief relief_ = makeRelief(1.0, 60.0);
    Heightmap map_;
    Surface surface_;
    Oracle oracle_;
    Tally tally_;
};

INSTANTIATE_TEST_SUITE_P(Registrations, Special, testing::Values(Texel, Gridline));

TEST_P(Special, AlongAndBesideTheAxis) {
    const double pole = surface_.radius({0.0, 1.0, 0.0});
    for (double beside : {0.0, -0.0, 1e-320, 1e-300, 1e-160, 1e-20, 1e-16, 1e-13, 1e-9, 1e-4}) {
        for (double sign : {1.0, -1.0}) {
            expectHit({beside, 3.0 * sign, beside}, {0.0, -sign, 0.0}, 1000);
            expectHit({-beside, 3.0 * sign, 0.0}, {-0.0, -sign, 0.0}, 1000);
            expectHit({0.0, 3.0 * sign, beside}, {beside, -sign, -beside}, 1000);
        }
        const FirstHit hit = firstHit(surface_, {.origin = {beside, 3.0, 0.0}, .direction = {0.0, -1.0, 0.0}});
        EXPECT_TRUE(hit.hit);
        EXPECT_NEAR(hit.t(), 3.0 - pole, 1e-12 + 10.0 * beside);
    }
    EXPECT_EQ(tally_.hits, tally_.rays);
}

TEST_P(Special, AcrossTheAxisAbovePoleAndThroughIt) {
    for (double above : {-1e-3, -1e-9, 1e-13, 1e-9, 1e-3, 0.05, 0.2})
        for (double beside : {0.0, 1e-300, 1e-17, 1e-12, 1e-6})
            for (double slope : {0.0, 1e-9, 0.1, -0.3}) {
                const double pole = surface_.radius({0.0, 1.0, 0.0}) + above;
                expectHit({beside, pole + 3.0 * slope, 3.0}, {0.0, -slope, -1.0}, 4000);
                expectHit({-3.0, pole + 3.0 * slope, beside}, {1.0, -slope, 0.0}, 4000);
                const double south = -surface_.radius({0.0, -1.0, 0.0}) - above;
                expectHit({3.0, south - 3.0 * slope, beside}, {-1.0, slope, 0.0}, 4000);
            }
    EXPECT_EQ(tally_.rays, 7 * 5 * 4 * 3);
}

TEST_P(Special, ThroughTheCentre) {
    Random random(3);
    for (int k = 0; k < 40; ++k) {
        const dvec3 from = 3.0 * randomUnit(random);
        expectHit(from, -from, 2000);
        const FirstHit hit = firstHit(surface_, {.origin = from, .direction = -from});
        EXPECT_NEAR(3.0 * (1.0 - hit.t()), surface_.radius(from), 1e-13);
    }
}

TEST_P(Special, InSeamAndEquatorPlanes) {
    Random random(4);
    for (int k = 0; k < 30; ++k) {
        const double angle = uniform(random, -kPi, kPi), aim = uniform(random, -1.5, 1.5);
        const double a = 3.0 * std::sin(angle), b = 3.0 * std::cos(angle);
        const double da = aim * std::cos(angle) - a, db = -aim * std::sin(angle) - b;
        for (double zero : {0.0, -0.0}) {
            expectHit({zero, a, b}, {zero, da, db}, 4000);
            expectHit({a, zero, b}, {da, zero, db}, 4000);
            expectHit({a, b, zero}, {da, db, zero}, 4000);
        }
    }
}

TEST_P(Special, ThroughNodesAndAlongCreases) {
    const PatchGrid& grid = surface_.grid();
    Random random(5);
    for (int k = 0; k < 60; ++k) {
        // A node on the surface, and a direction down to it; some lie in the node's own meridian plane.
        const double longitude = (double(k % 16) + (GetParam() == Texel ? 0.5 : 0.0)) * grid.cellWidth() - kPi;
        const double colatitude = grid.colatitudeOf(1 + k % (grid.rows() - 1)), sine = std::sin(colatitude);
        const dvec3 w(sine * std::sin(longitude), std::cos(colatitude), sine * std::cos(longitude));
        const dvec3 node = surface_.radius(w) * w;
        const dvec3 side = k % 3 == 0 ? dvec3(0.0, uniform(random, -2.0, 2.0), 0.0) : 1.5 * randomUnit(random);
        const dvec3 from = 3.0 * glm::normalize(w + 0.5 * side);
        expectHit(from, node - from, 4000);
    }
}

TEST(Poles, StartingOnTheAxis) {
    // Where a ray starts on the axis to within rounding its longitude there means nothing, whatever it turns to.
    for (Registration registration : {Texel, Gridline}) {
        const Heightmap map = noiseMap(255, 129, registration, 6);
        const Relief relief = makeRelief(1.0, -95.0);
        const Surface surface(map, relief);
        const Oracle oracle(map, relief);
        Tally tally;
        Random random(7);
        for (int k = 0; k < 1000; ++k) {
            const double beside[] = {0.0, 1e-160, -1e-160, 1e-17}, sign = k % 2 ? 1.0 : -1.0;
            const double height = surface.radius({0.0, sign, 0.0}) + uniform(random, 0.001, 0.2);
            const dvec3 from(k % 3 ? 0.0 : beside[k % 4], sign * height, beside[k / 4 % 4]);
            const dvec3 direction(uniform(random, -1.0, 1.0), uniform(random, -1.0, 0.2) * sign,
                                  uniform(random, -1.0, 1.0));
            expectAgreement("from the axis", surface, oracle, {.origin = from, .direction = direction}, 3000, tally);
        }
        EXPECT_GT(tally.hits, 800);
        EXPECT_LT(tally.finer, 10);
    }
}

}  // namespace
}  // namespace dsphere::reference::test
