#include "reference/surface.h"

#include "tests/reference/maps.h"
#include "tests/reference/oracle.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dsphere::reference::test {
namespace {

using enum Registration;

double digits(int i, int j) {
    return 10.0 * j + i;
}

TEST(Surface, TexelValuesAndTheirMeans) {
    const Heightmap map = makeMap(4, 2, Texel, digits);
    const Surface surface(map, makeRelief(1.0, 1.0));
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 4; ++i)
            EXPECT_NEAR(surface.stored(direction((i + 0.5) / 4.0, (j + 0.5) / 2.0)), digits(i, j), 1e-13);
    EXPECT_NEAR(surface.stored(direction(0.5, 0.25)), 1.5, 1e-13);      // half way between texels 1 and 2
    EXPECT_NEAR(surface.stored(direction(0.0, 0.25)), 1.5, 1e-13);      // the seam: between texels 3 and 0
    EXPECT_NEAR(surface.stored(direction(1.0, 0.25)), 1.5, 1e-13);      // and from its other side
    EXPECT_NEAR(surface.stored(direction(0.125, 0.5)), 5.0, 1e-13);     // between the rows
    EXPECT_NEAR(surface.stored(direction(0.125, 0.125)), 0.75, 1e-13);  // half way from the pole's mean 1.5 to 0
    EXPECT_EQ(surface.stored({0.0, 1.0, 0.0}), 1.5);
    EXPECT_EQ(surface.stored({0.0, -2.0, 0.0}), 11.5);
}

TEST(Surface, GridlineNodes) {
    const Heightmap map = makeMap(4, 3, Gridline, digits);
    const Surface surface(map, makeRelief(1.0, 1.0));
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(surface.stored(direction(i / 4.0, 0.5)), digits(i, 1), 1e-13);
    EXPECT_NEAR(surface.stored(direction(0.875, 0.5)), 11.5, 1e-13);
    EXPECT_NEAR(surface.stored(direction(0.25, 0.25)), 0.5 * (1.5 + 11.0), 1e-13);
    EXPECT_EQ(surface.stored({0.0, 1.0, 0.0}), 1.5);
    EXPECT_EQ(surface.stored({0.0, -1.0, 0.0}), 21.5);
}

TEST(Surface, LongitudeOriginShiftsTheMapAndNotU) {
    const Heightmap plain = makeMap(8, 4, Texel, digits), shifted = makeMap(8, 4, Texel, digits, 0.0);
    const Surface a(plain, makeRelief(1.0, 1.0)), b(shifted, makeRelief(1.0, 1.0));
    for (double u : {0.01, 0.3, 0.5, 0.77}) {
        EXPECT_NEAR(b.stored(direction(u + 0.5, 0.4)), a.stored(direction(u, 0.4)), 1e-12);
        EXPECT_NEAR(Surface::u(direction(u, 0.4)), u, 1e-15);
    }
    EXPECT_NEAR(Surface::v(direction(0.3, 0.9)), 0.9, 1e-15);
    EXPECT_EQ(Surface::u({0.0, 0.0, 1.0}), 0.5);  // longitude 0 faces +z
    EXPECT_EQ(Surface::u({1.0, 0.0, 0.0}), 0.75);
}

TEST(Surface, HeightAndRadius) {
    const Heightmap map = flatMap(4, 2, Texel, 100.0);
    Relief relief{.base = 10.0, .scale = 0.05, .least_radius = 15.0, .greatest_radius = 15.0};
    relief.h_scale = 0.01;
    relief.h_offset = -0.5;
    const Surface surface(map, relief);
    EXPECT_DOUBLE_EQ(surface.radius({3.0, 4.0, 5.0}), 15.0);
    EXPECT_DOUBLE_EQ(surface.height({3.0, 4.0, 5.0}), 0.5);
    EXPECT_DOUBLE_EQ(surface.f({0.0, 0.0, 17.0}), 2.0);
    EXPECT_GE(surface.greatestRadius(), 15.0);
    EXPECT_LE(surface.leastRadius(), 15.0);
    EXPECT_NEAR(surface.greatestRadius(), surface.leastRadius(), 1e-13);
}

struct Shape {
    int width, height;
    Registration registration;
};

class AnyShape : public testing::TestWithParam<Shape> {};

INSTANTIATE_TEST_SUITE_P(Maps, AnyShape,
                         testing::Values(Shape{1, 1, Texel}, Shape{2, 1, Texel}, Shape{3, 2, Texel},
                                         Shape{3, 2, Gridline}, Shape{5, 3, Gridline}, Shape{16, 8, Texel},
                                         Shape{257, 129, Texel}, Shape{257, 129, Gridline}, Shape{4096, 3, Texel}));

dvec3 pointSomewhere(Random& random, int k) {
    dvec3 p = randomUnit(random);
    if (k % 3 == 0)
        p = dvec3(p.x * std::pow(10.0, -uniform(random, 0, 12)), p.y, p.z * std::pow(10.0, -uniform(random, 0, 12)));
    if (k % 7 == 0) p.x = k % 2 ? 0.0 : -0.0;
    return p * uniform(random, 0.5, 1.5);
}

TEST_P(AnyShape, ValueIsTheContractsOne) {
    Heightmap map = noiseMap(GetParam().width, GetParam().height, GetParam().registration, 1);
    map.longitude_origin = 31.7;
    const Relief relief = makeRelief(1.0, 50.0);
    const Surface surface(map, relief);
    const Oracle oracle(map, relief);
    Random random(2);
    for (int k = 0; k < 3000; ++k) {
        const dvec3 p = pointSomewhere(random, k);
        EXPECT_NEAR(surface.f(p), double(oracle.f(p.x, p.y, p.z)), surface.evaluationError())
            << p.x << ' ' << p.y << ' ' << p.z;
    }
}

/// Central differences of the oracle, along the three axes.
dvec3 slopeByDifferences(const Oracle& oracle, const dvec3& p, long double step) {
    const auto along = [&](long double x, long double y, long double z) {
        return double((oracle.f(p.x + x * step, p.y + y * step, p.z + z * step) -
                       oracle.f(p.x - x * step, p.y - y * step, p.z - z * step)) /
                      (2 * step));
    };
    return {along(1, 0, 0), along(0, 1, 0), along(0, 0, 1)};
}

TEST_P(AnyShape, GradientAgreesWithDifferences) {
    const Heightmap map = noiseMap(GetParam().width, GetParam().height, GetParam().registration, 3);
    const Relief relief = makeRelief(1.0, 50.0);
    const Surface surface(map, relief);
    const Oracle oracle(map, relief);
    Random random(4);
    int compared = 0;
    for (int k = 0; k < 3000; ++k) {
        const dvec3 p = pointSomewhere(random, k);
        const double q = std::hypot(p.x, p.z), step = 1e-6 * std::min(q, 0.01);
        if (step < 1e-11) continue;
        const double column = surface.grid().columnOf(std::atan2(p.x, p.z)),
                     row = surface.grid().rowOf(std::atan2(q, p.y));
        const double margin = 10.0 * step / q * GetParam().width + 10.0 * step * surface.grid().rows();
        if (std::abs(column - std::round(column)) < margin || std::abs(row - std::round(row)) < margin) continue;
        const dvec3 gradient = surface.gradient(p), differences = slopeByDifferences(oracle, p, step);
        EXPECT_LT(glm::length(gradient - differences), 1e-5 * glm::length(gradient)) << p.x << ' ' << p.y << ' ' << p.z;
        EXPECT_NEAR(glm::length(surface.normal(p)), 1.0, 1e-15);
        ++compared;
    }
    EXPECT_GT(compared, 1000);
}

TEST_P(AnyShape, OnTheAxisTheNormalIsRadial) {
    const Heightmap map = noiseMap(GetParam().width, GetParam().height, GetParam().registration, 5);
    const Surface surface(map, makeRelief(1.0, 50.0));
    EXPECT_EQ(surface.gradient({0.0, 1.2, 0.0}), dvec3(0.0, 1.0, 0.0));
    EXPECT_EQ(surface.gradient({0.0, -1.2, -0.0}), dvec3(0.0, -1.0, 0.0));
    for (double beside : {1e-300, 1e-320, 1e-160, 1e-17}) {
        const dvec3 normal = surface.normal({beside, 1.0, beside});
        EXPECT_TRUE(std::isfinite(normal.x) && std::isfinite(normal.y) && std::isfinite(normal.z));
        EXPECT_NEAR(glm::length(normal), 1.0, 1e-15);
        EXPECT_GT(normal.y, 0.0);
    }
}

}  // namespace
}  // namespace dsphere::reference::test
