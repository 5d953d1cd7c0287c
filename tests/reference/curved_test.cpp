// B-splines and ripples: closed forms, known values, a second reading in long double, and slopes against differences.

#include "reference/analytic.h"
#include "tests/reference/agree.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dsphere::reference::test {
namespace {

using enum Registration;

struct CurvedCase {
    std::string name;
    Heightmap map;
    Relief relief;
};

Relief splineRelief(double percent) {
    Relief relief = makeRelief(1.0, percent);
    relief.filter = Filter::BSpline;
    return relief;
}

Heightmap rippleMap(int u_frequency, int v_frequency, double longitude_origin = -180.0) {
    DisplacedSphere sphere;
    sphere.ripples = Ripples{u_frequency, v_frequency};
    sphere.longitude_origin = longitude_origin;
    return loadHeightmap(sphere);
}

std::vector<CurvedCase> curvedCases() {
    std::vector<CurvedCase> all;
    all.push_back({"texel", noiseMap(24, 12, Texel, 1), splineRelief(30.0)});
    all.push_back({"gridline", noiseMap(24, 13, Gridline, 2), splineRelief(30.0)});
    all.push_back({"checkerboard", checkerboard(16, 8, Texel), splineRelief(-40.0)});
    all.push_back({"1x1", noiseMap(1, 1, Texel, 3), splineRelief(30.0)});
    all.push_back({"3x2", noiseMap(3, 2, Texel, 4), splineRelief(60.0)});
    all.push_back({"2 rows of gridline", noiseMap(5, 2, Gridline, 5), splineRelief(60.0)});
    all.push_back({"3 rows of gridline", noiseMap(5, 3, Gridline, 6), splineRelief(60.0)});
    all.push_back({"ripples", rippleMap(12, 12), makeRelief(1.0, 15.0)});
    all.push_back({"one ripple", rippleMap(1, 1), makeRelief(1.0, 60.0)});
    all.push_back({"odd ripples", rippleMap(7, 5, 33.0), makeRelief(1.0, -25.0)});
    return all;
}

dvec3 someDirection(Random& random, int k) {
    if (k % 4) return randomUnit(random);
    const double side = k % 8 ? 1.0 : -1.0;  // near the poles
    return glm::normalize(dvec3(uniform(random, -0.1, 0.1), side, uniform(random, -0.1, 0.1)));
}

TEST(Curved, HeightsAreTheOracles) {
    Random random(1);
    for (const CurvedCase& c : curvedCases()) {
        const Surface surface(c.map, c.relief);
        const Oracle oracle(c.map, c.relief);
        for (int k = 0; k < 2000; ++k) {
            const dvec3 p = 1.1 * someDirection(random, k);
            ASSERT_NEAR(surface.f(p), double(oracle.f(p.x, p.y, p.z)), surface.evaluationError()) << c.name;
        }
    }
}

TEST(Curved, GradientsAreDifferencesOfHeights) {
    Random random(2);
    const double step = 1e-6;
    for (const CurvedCase& c : curvedCases()) {
        const Surface surface(c.map, c.relief);
        const Oracle oracle(c.map, c.relief);
        int creased = 0;
        for (int k = 0; k < 1000; ++k) {
            const dvec3 p = 1.1 * someDirection(random, k), gradient = surface.gradient(p);
            dvec3 differences;
            for (int axis = 0; axis < 3; ++axis) {
                dvec3 a = p, b = p;
                a[axis] -= step;
                b[axis] += step;
                differences[axis] = double(oracle.f(b.x, b.y, b.z) - oracle.f(a.x, a.y, a.z)) / (2.0 * step);
            }
            creased += glm::length(gradient - differences) > 1e-6 * glm::length(gradient);
        }
        EXPECT_LE(creased, 2) << c.name;  // only across the caps' circles
    }
}

TEST(Curved, SlopeBoundsHold) {
    Random random(3);
    for (const CurvedCase& c : curvedCases()) {
        const Surface surface(c.map, c.relief);
        for (int k = 0; k < 2000; ++k) {
            const int i = int(random() % std::uint64_t(surface.grid().columns()));
            const int j = int(random() % std::uint64_t(surface.grid().rows()));
            CellPart part{uniform(random, 0.0, 1.0), 0.0, uniform(random, 0.0, 1.0), 0.0};
            part.a1 = uniform(random, part.a0, 1.0);
            part.b1 = uniform(random, part.b0, 1.0);
            const CellSlopeRanges bounds = surface.slopesOver(i, j, part);
            for (int n = 0; n < 8; ++n) {
                const CellSlopes slopes =
                    surface.slopesAt(i, j, uniform(random, part.a0, part.a1), uniform(random, part.b0, part.b1));
                ASSERT_GE(slopes.east, bounds.east.least - 1e-14) << c.name;
                ASSERT_LE(slopes.east, bounds.east.greatest + 1e-14) << c.name;
                ASSERT_GE(slopes.south, bounds.south.least - 1e-14) << c.name;
                ASSERT_LE(slopes.south, bounds.south.greatest + 1e-14) << c.name;
            }
        }
    }
}

TEST(Curved, FirstHitsAreTheOracles) {
    Random random(4);
    for (const CurvedCase& c : curvedCases()) {
        const Surface surface(c.map, c.relief);
        const Oracle oracle(c.map, c.relief);
        Tally tally;
        for (int k = 0; k < 60; ++k)
            expectAgreement(c.name, surface, oracle, randomRay(random, k % 2 ? 1.8 : 4.0, 1.1), 1500, tally);
        EXPECT_GT(tally.hits, 15) << c.name;
        EXPECT_LE(tally.tangent, 1) << c.name;
    }
}

TEST(Curved, OneTexelSpreadsByTheBasis) {
    const Heightmap map = makeMap(16, 8, Texel, [](int i, int j) { return i == 5 && j == 3 ? 1.0 : 0.0; });
    const Surface surface(map, splineRelief(10.0));
    EXPECT_NEAR(surface.valueAt(5.0, 4.0), 4.0 / 9.0, 1e-15);   // its own node
    EXPECT_NEAR(surface.valueAt(6.0, 4.0), 1.0 / 9.0, 1e-15);   // a neighbour's
    EXPECT_NEAR(surface.valueAt(6.0, 5.0), 1.0 / 36.0, 1e-15);  // across the corner
    EXPECT_NEAR(surface.valueAt(7.0, 4.0), 0.0, 1e-15);
}

TEST(Curved, ConstantMapsAndFlatRipplesAreSpheres) {
    Random random(5);
    const Heightmap constant = flatMap(9, 5, Texel, 0.5), ripples = rippleMap(12, 12);
    const Surface spline(constant, splineRelief(20.0)), flat(ripples, makeRelief(1.1, 0.0));
    for (int k = 0; k < 2000; ++k) {
        const Ray ray = randomRay(random, k % 2 ? 1.5 : 9.0, 1.2);
        const FirstHit sphere = hitSphere(1.1, ray);
        for (const Surface* surface : {&spline, &flat}) {
            const FirstHit hit = firstHit(*surface, ray);
            ASSERT_EQ(hit.hit, sphere.hit);
            if (!hit.hit) continue;
            EXPECT_LT(glm::length(hit.position - sphere.position), 1e-7);
            EXPECT_NEAR(glm::dot(surface->normal(hit.position), sphere.position), 1.1, 1e-12);
        }
    }
}

TEST(Curved, SmoothNormalsAreTheSplines) {
    Random random(6);
    const Heightmap map = noiseMap(24, 12, Texel, 1);
    Relief relief = makeRelief(1.0, 30.0);
    relief.smooth_normals = true;
    const Surface bilinear(map, relief), spline(map, splineRelief(30.0));
    for (int k = 0; k < 500; ++k) {
        const dvec3 p = 1.1 * someDirection(random, k);
        EXPECT_LT(glm::length(bilinear.shadingNormal(p) - spline.normal(p)), 1e-14);
        EXPECT_EQ(spline.shadingNormal(p), spline.normal(p));
    }
}

}  // namespace
}  // namespace dsphere::reference::test
