// Horizons against brute force: rays that rise above them by next to nothing are followed over the reference's surface.

#include "surface/horizons.h"

#include "reference/surface.h"
#include "surface/cubeneighbours.h"
#include "tests/surface/grids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace dsphere::test {
namespace {

struct HorizonCase {
    const char* map;
    int width, height;
    Registration registration;
    double max_displacement;
    Filter filter = Filter::Bilinear;

    std::unique_ptr<Planet> planet() const {
        if (map == std::string("ripples")) return makeRipples({width, height}, max_displacement, 20.0);
        return makePlanet(namedMap(map, width, height), registration, max_displacement, 20.0, filter);
    }
};

void PrintTo(const HorizonCase& c, std::ostream* out) {
    *out << c.map << ' ' << c.width << 'x' << c.height
         << (c.registration == Registration::Texel ? " texel " : " gridline ") << c.max_displacement << " %"
         << (c.filter == Filter::BSpline ? " B-spline" : "");
}

class HorizonTest : public testing::TestWithParam<HorizonCase> {
  protected:
    std::unique_ptr<Planet> planet_ = GetParam().planet();
    NodeGrid nodes_{planet_->map};
    Bounds bounds_ = buildBounds(nodes_, planet_->relief);
    reference::Surface surface_{planet_->map, planet_->relief};
    std::mt19937 random_{1};

    double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }
    double radius(const dvec3& w) const { return surface_.radius(w) / planet_->relief.greatest_radius; }
};

// Starts on the ground and a little below, as rounded hits may lie, also over the very edges of the cells.
TEST_P(HorizonTest, WhatRisesAboveMeetsNothing) {
    const int side = bounds_.horizonSide();
    const double width = 2.0 / side, d = Bounds::kDilation;
    const int step = side / 16;
    for (int face = 0; face < 6; ++face)
        for (int j = face % step; j < side; j += step)
            for (int i = j / step % step; i < side; i += step) {
                const double a = i * width - 1.0 + uniform(-d, width + d), b = j * width - 1.0 + uniform(-d, width + d);
                const dvec3 up = glm::normalize(faceDirection(face, a, b));
                const double r = radius(up), start = r - uniform(0.0, 1.0) * 1.5e-6;
                ASSERT_GE(start * start, double(bounds_.squared[bounds_.horizonLeastIndex(face, i, j)]));
                const double tangent = std::sqrt(double(bounds_.squared[bounds_.horizonIndex(face, i, j)]));
                ASSERT_GT(tangent, 0.0);
                const dvec3 any = glm::normalize(dvec3(uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)));
                const dvec3 ahead = glm::normalize(any - glm::dot(any, up) * up);
                const double rise = std::atan(tangent);
                bool outside = false;
                for (double x = 2e-6; x < 0.5 * kPi - rise; x *= 1.08) {
                    const double above =
                        start * std::cos(rise) / std::cos(rise + x) - radius(std::cos(x) * up + std::sin(x) * ahead);
                    // From below the ground it may come out once.
                    outside = outside || above > 0.0;
                    ASSERT_TRUE(above > 0.0 || (!outside && x * tangent < 2e-2))
                        << "face " << face << " cell " << i << ", " << j << " at " << x << ": " << above;
                }
            }
}

INSTANTIATE_TEST_SUITE_P(Maps, HorizonTest,
                         testing::Values(HorizonCase{"random", 3, 2, Registration::Texel, 30},
                                         HorizonCase{"random", 7, 5, Registration::Gridline, -60},
                                         HorizonCase{"checkerboard", 64, 32, Registration::Texel, 20},
                                         HorizonCase{"spikes", 513, 257, Registration::Gridline, -40},
                                         HorizonCase{"spikes", 1024, 512, Registration::Texel, 50},
                                         HorizonCase{"random", 511, 255, Registration::Texel, 0.01},
                                         HorizonCase{"fractal", 1024, 512, Registration::Texel, 5},
                                         HorizonCase{"fractal", 2048, 1024, Registration::Texel, -15},
                                         HorizonCase{"terraces", 1024, 513, Registration::Gridline, 10},
                                         HorizonCase{"random", 5, 3, Registration::Texel, 20, Filter::BSpline},
                                         HorizonCase{"random", 7, 5, Registration::Gridline, -40, Filter::BSpline},
                                         HorizonCase{"spikes", 513, 257, Registration::Gridline, 40, Filter::BSpline},
                                         HorizonCase{"spikes", 512, 256, Registration::Texel, 40, Filter::BSpline},
                                         HorizonCase{"fractal", 1024, 512, Registration::Texel, 8, Filter::BSpline},
                                         HorizonCase{"ripples", 12, 10, Registration::Texel, 12},
                                         HorizonCase{"ripples", 3, 40, Registration::Texel, -30}));

// From pole to pole the ground rises evenly, so that a ray along it that is hardly less steep than its slope would meet
// it.
TEST(Horizons, OfARampAreItsSlope) {
    constexpr int kWidth = 512, kHeight = 256;
    std::vector<float> samples;
    for (int j = 0; j < kHeight; ++j)
        for (int i = 0; i < kWidth; ++i) samples.push_back(65535.0f * float(j) / float(kHeight - 1));
    auto planet = makePlanet(rawOf(kWidth, kHeight, std::move(samples)), Registration::Gridline, 40.0);
    const NodeGrid nodes(planet->map);
    const Bounds bounds = buildBounds(nodes, planet->relief);
    const reference::Surface surface(planet->map, planet->relief);
    const int side = bounds.horizonSide();
    for (int face : {0, 1, 4, 5})  // around the equator
        for (int j = 1; j + 1 < side; ++j)
            for (int i = 1; i + 1 < side; ++i) {
                const dvec3 up =
                    glm::normalize(faceDirection(face, (i + 0.5) * 2.0 / side - 1.0, (j + 0.5) * 2.0 / side - 1.0));
                const dvec3 gradient = surface.gradient(surface.radius(up) * up);
                const double slope = glm::length(gradient - glm::dot(gradient, up) * up);
                const double tangent = std::sqrt(double(bounds.squared[bounds.horizonIndex(face, i, j)]));
                ASSERT_GE(tangent, slope);
                ASSERT_LE(tangent, 1.35 * slope) << "face " << face << " cell " << i << ", " << j;
            }
}

// The steepest ground anywhere, and what the tables say of most places.
TEST(Horizons, AreNotMuchHigherThanSlopes) {
    auto planet = makePlanet(namedMap("fractal", 2048, 1024), Registration::Texel, 5.0);
    const NodeGrid nodes(planet->map);
    const Bounds bounds = buildBounds(nodes, planet->relief);
    const BlockExtremes blocks = measureBlocks(nodes, Filter::Bilinear);
    const double slope = std::abs(planet->relief.scale) / planet->relief.least_radius;
    const double steepest = slope * double(std::ranges::max(blocks.steepest));
    std::vector<double> tangents;
    for (int face = 0; face < 6; ++face)
        for (int j = 0; j < bounds.horizonSide(); ++j)
            for (int i = 0; i < bounds.horizonSide(); ++i)
                tangents.push_back(std::sqrt(double(bounds.squared[bounds.horizonIndex(face, i, j)])));
    std::ranges::sort(tangents);
    EXPECT_LE(tangents.back(), 1.0001 * steepest + 2e-4);
    std::vector<float> slopes = blocks.steepest;
    std::ranges::sort(slopes);
    EXPECT_LE(tangents[tangents.size() / 2], 3.0 * slope * double(slopes[slopes.size() / 2]));
}

TEST(Horizons, OfASmoothSphereIsTheHorizontalPlane) {
    auto planet = makePlanet(constantMap(512, 256, 0.5f), Registration::Texel, 10.0);
    const NodeGrid nodes(planet->map);
    const Bounds bounds = buildBounds(nodes, planet->relief);
    for (int face = 0; face < 6; ++face) EXPECT_LT(bounds.squared[bounds.horizonIndex(face, 3, 5)], 1e-6f);
}

// Each direction whose place in the plane of a face is at most so many cells beside a cell.
TEST(CubeGrid, DilationReachesOverTheEdgesOfFaces) {
    constexpr int kSide = 8;
    std::mt19937 random(1);
    CubeGrid grid(kSide);
    for (int face = 0; face < 6; ++face)
        for (int j = 0; j < kSide; ++j)
            for (int i = 0; i < kSide; ++i) grid.at(face, i, j) = float(random() % 100000);
    const auto valueAt = [&](const dvec3& w) {
        int axis = 0;
        for (int k : {1, 2})
            if (std::abs(w[k]) > std::abs(w[axis])) axis = k;
        const auto cell = [&](double c) {
            return std::clamp(int((c / std::abs(w[axis]) + 1.0) * 0.5 * kSide), 0, kSide - 1);
        };
        return grid.at(2 * axis + (w[axis] < 0.0 ? 1 : 0), cell(w[(axis + 1) % 3]), cell(w[(axis + 2) % 3]));
    };
    for (int rings : {1, 3}) {
        const CubeGrid dilated = grid.dilated(rings);
        double excess = 0.0;
        for (int face = 0; face < 6; ++face)
            for (int j = 0; j < kSide; ++j)
                for (int i = 0; i < kSide; ++i) {
                    float found = 0.0f;
                    for (int k = 0; k < 400; ++k) {
                        std::uniform_real_distribution<double> offset(-rings, rings + 1);
                        const double a = (i + offset(random)) * 2.0 / kSide - 1.0;
                        const double b = (j + offset(random)) * 2.0 / kSide - 1.0;
                        found = std::max(found, valueAt(faceDirection(face, a, b)));
                    }
                    ASSERT_GE(dilated.at(face, i, j), found) << rings << ": " << face << ' ' << i << ' ' << j;
                    excess += dilated.at(face, i, j) - found;
                }
        EXPECT_LT(excess / (6 * kSide * kSide), 4000.0) << "reaches much farther than asked";
    }
}

}  // namespace
}  // namespace dsphere::test
