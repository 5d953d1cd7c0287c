// The pyramid against brute force: no bound below the surface over its dilated cell, none above the greatest node of
// the patches that the cell touches (of a spline the greatest Bezier point about these, of ripples the surface's own
// greatest there).

#include "surface/bounds.h"

#include "reference/surface.h"
#include "surface/spline.h"
#include "tests/surface/grids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace dsphere::test {
namespace {

struct BoundsCase {
    const char* map;
    int width, height;
    Registration registration;
    double max_displacement;
    double longitude_origin = -180.0;
    Filter filter = Filter::Bilinear;

    std::unique_ptr<Planet> planet() const {
        if (map == std::string("ripples")) return makeRipples({width, height}, max_displacement, longitude_origin);
        return makePlanet(namedMap(map, width, height), registration, max_displacement, longitude_origin, filter);
    }
};

void PrintTo(const BoundsCase& c, std::ostream* out) {
    *out << c.map << ' ' << c.width << 'x' << c.height
         << (c.registration == Registration::Texel ? " texel " : " gridline ") << c.max_displacement << " % from "
         << c.longitude_origin << (c.filter == Filter::BSpline ? " B-spline" : "");
}

class BoundsTest : public testing::TestWithParam<BoundsCase> {
  protected:
    std::unique_ptr<Planet> planet_ = GetParam().planet();
    NodeGrid nodes_{planet_->map};
    std::vector<float> extremes_ = GetParam().filter == Filter::BSpline
                                       ? SplineNodes(nodes_).extremes(planet_->relief.scale >= 0.0)
                                       : std::vector<float>();
    Bounds bounds_ = buildBounds(nodes_, planet_->relief);
    std::mt19937 random_{1};

    double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

    /// A face coordinate over cell i, dilated; every other one on its very edge or beyond.
    double across(int i) {
        double width = 2.0 / bounds_.side, low = i * width - 1.0, high = low + width, d = Bounds::kDilation;
        double choice = uniform(0.0, 1.0);
        if (choice < 0.25) return low + uniform(-d, d);
        if (choice < 0.5) return high + uniform(-d, d);
        return uniform(low - d, high + d);
    }

    double radiusOf(double stored) const {
        return (planet_->relief.base + planet_->relief.scale * stored) / planet_->relief.greatest_radius;
    }
    double radiusOfNode(int i, int j) const {
        int width = nodes_.width(), column = (i % width + width) % width;
        return radiusOf(extremes_.empty() ? nodes_.row(j)[column] : extremes_[std::size_t(j * width + column)]);
    }
    /// r over a box of ripples, from many of its points; units of R.
    double greatestRipple(double west, double east, double north, double south) const {
        const Ripples& ripples = *planet_->map.ripples;
        const int columns = 24 * int(1.0 + ripples.u_frequency * (east - west) / (2.0 * kPi)), rows = 24;
        double shift = kPi - glm::radians(planet_->map.longitude_origin + 180.0), greatest = 0.0;
        for (int k = 0; k <= columns; ++k)
            for (int l = 0; l <= rows; ++l) {
                double longitude = west + (east - west) * k / columns + shift;
                double colatitude = north + (south - north) * l / rows;
                double h =
                    0.5 + 0.5 * std::sin(ripples.u_frequency * longitude) * std::sin(ripples.v_frequency * colatitude);
                greatest = std::max(greatest, radiusOf(h));
            }
        return greatest;
    }

    /// r of the greatest node of the patches in the box of longitude and colatitude about the dilated cell, found by
    /// many points of it; units of R. A cell that holds a pole has all longitudes.
    double greatestNode(int face, int i, int j) const {
        constexpr int kPoints = 24;
        double width = 2.0 / bounds_.side, d = Bounds::kDilation;
        double a0 = i * width - 1.0 - d, b0 = j * width - 1.0 - d, step = (width + 2.0 * d) / kPoints;
        dvec3 middle = faceDirection(face, a0 + 0.5 * kPoints * step, b0 + 0.5 * kPoints * step);
        double centre = std::atan2(middle.x, middle.z);
        double west = 0.0, east = 0.0, north = kPi, south = 0.0;
        for (int k = 0; k <= kPoints; ++k)
            for (int l = 0; l <= kPoints; ++l) {
                dvec3 w = faceDirection(face, a0 + k * step, b0 + l * step);
                double longitude = std::remainder(std::atan2(w.x, w.z) - centre, 2.0 * kPi);
                double colatitude = std::atan2(std::hypot(w.x, w.z), w.y);
                west = std::min(west, longitude);
                east = std::max(east, longitude);
                north = std::min(north, colatitude);
                south = std::max(south, colatitude);
            }
        // Faces at the poles take longitudes evenly to both sides of the cell's middle.
        if (face / 2 == 1) west = -(east = std::max(east, -west));
        if (face / 2 == 1 && east - west > 0.9 * kPi) {  // about a pole, or with it on its edge
            east = west + 2.0 * kPi;
            (face == 2 ? north : south) = face == 2 ? 0.0 : kPi;
        }
        if (planet_->map.ripples) return greatestRipple(centre + west, centre + east, north, south);
        double tolerance = 1e-9;  // of rounding, and of extremes between the points
        int first = int(std::floor(nodes_.column(centre + west) - tolerance));
        int last = int(std::floor(nodes_.column(centre + east) + tolerance)) + 1;
        int top = std::max(int(std::floor(nodes_.nodeRow(north) - tolerance)), 0);
        int bottom = std::min(int(std::floor(nodes_.nodeRow(south) + tolerance)) + 1, nodes_.rows());
        double greatest = 0.0;
        for (int row = top; row <= bottom; ++row)
            for (int column = first; column <= last; ++column) greatest = std::max(greatest, radiusOfNode(column, row));
        return greatest;
    }
};

TEST_P(BoundsTest, NoneIsBelowTheSurface) {
    reference::Surface surface(planet_->map, planet_->relief);
    for (int face = 0; face < 6; ++face)
        for (int j = 0; j < bounds_.side; ++j)
            for (int i = 0; i < bounds_.side; ++i)
                for (int k = 0; k < 12; ++k) {
                    double r =
                        surface.radius(faceDirection(face, across(i), across(j))) / planet_->relief.greatest_radius;
                    // The slack is left whole for the marcher's rounding, but for this test's own.
                    double least = r + Bounds::kSlack - 1e-12;
                    ASSERT_GE(double(bounds_.at(face, 0, i, j)), least * least)
                        << "face " << face << " cell " << i << ", " << j;
                }
}

TEST_P(BoundsTest, NoneIsAboveItsGreatestNode) {
    // Between the points where they are read, 1/24 of a period apart at most, ripples rise by half (pi / 24)^2 / 2.
    double between = planet_->map.ripples ? 0.0043 * std::abs(planet_->relief.scale) : 0.0;
    for (int face = 0; face < 6; ++face)
        for (int j = 0; j < bounds_.side; j += 3)
            for (int i = 0; i < bounds_.side; i += 3) {
                double most = greatestNode(face, i, j) + Bounds::kSlack + between;
                // Two ulp: the bound is rounded to float and then up.
                ASSERT_LE(bounds_.at(face, 0, i, j), most * most * (1.0 + 0x1p-22))
                    << "face " << face << " cell " << i << ", " << j;
            }
}

TEST_P(BoundsTest, CoarserLevelsAreTheMaximaOfTheirCells) {
    ASSERT_EQ(bounds_.side >> (bounds_.levels - 1), 1);
    for (int face = 0; face < 6; ++face)
        for (int level = 1; level < bounds_.levels; ++level)
            for (int j = 0; j < bounds_.side >> level; ++j)
                for (int i = 0; i < bounds_.side >> level; ++i) {
                    float greatest = 0.0f;
                    for (int dj : {0, 1})
                        for (int di : {0, 1})
                            greatest = std::max(greatest, bounds_.at(face, level - 1, 2 * i + di, 2 * j + dj));
                    ASSERT_EQ(bounds_.at(face, level, i, j), greatest);
                }
}

TEST_P(BoundsTest, TheGreatestIsTheShell) {
    float greatest = 0.0f;
    for (int face = 0; face < 6; ++face) greatest = std::max(greatest, bounds_.at(face, bounds_.levels - 1, 0, 0));
    EXPECT_LE(greatest, (1.0 + Bounds::kSlack) * (1.0 + Bounds::kSlack) + 2e-7);
    if (GetParam().filter == Filter::BSpline) return;  // it runs past the map's greatest value
    EXPECT_GE(greatest, (1.0 + Bounds::kSlack) * (1.0 + Bounds::kSlack) - 2e-7);
}

INSTANTIATE_TEST_SUITE_P(Maps, BoundsTest,
                         testing::Values(BoundsCase{"random", 1, 1, Registration::Texel, 30},
                                         BoundsCase{"random", 2, 1, Registration::Texel, 30},
                                         BoundsCase{"random", 1, 2, Registration::Gridline, 30},
                                         BoundsCase{"random", 3, 2, Registration::Texel, -30, 17},
                                         BoundsCase{"random", 7, 5, Registration::Gridline, 60},
                                         BoundsCase{"checkerboard", 64, 32, Registration::Texel, 20},
                                         BoundsCase{"spikes", 65, 33, Registration::Gridline, -40, 0},
                                         BoundsCase{"random", 511, 255, Registration::Texel, 5},
                                         BoundsCase{"spikes", 512, 256, Registration::Texel, 50},
                                         BoundsCase{"random", 513, 257, Registration::Gridline, -5, 1},
                                         BoundsCase{"fractal", 1024, 512, Registration::Texel, 10},
                                         BoundsCase{"spikes", 1030, 511, Registration::Texel, 100, 0},
                                         BoundsCase{"random", 1, 1, Registration::Texel, 30, 0, Filter::BSpline},
                                         BoundsCase{"random", 2, 1, Registration::Texel, 30, 0, Filter::BSpline},
                                         BoundsCase{"random", 1, 2, Registration::Gridline, 30, 0, Filter::BSpline},
                                         BoundsCase{"random", 7, 5, Registration::Gridline, -60, 9, Filter::BSpline},
                                         BoundsCase{"checkerboard", 64, 32, Registration::Texel, 20, 0,
                                                    Filter::BSpline},
                                         BoundsCase{"spikes", 513, 257, Registration::Gridline, 40, 1, Filter::BSpline},
                                         BoundsCase{"spikes", 1024, 512, Registration::Texel, -50, 0, Filter::BSpline},
                                         BoundsCase{"ripples", 12, 12, Registration::Texel, 60},
                                         BoundsCase{"ripples", 1, 1, Registration::Texel, -60, 20},
                                         BoundsCase{"ripples", 33, 70, Registration::Texel, 25, 0}));

TEST(Bounds, LevelsAndHorizonsDoNotOverlap) {
    auto planet = makePlanet(randomMap(3, 2), Registration::Texel, 10.0);
    NodeGrid nodes(planet->map);
    Bounds bounds = buildBounds(nodes, planet->relief);
    std::vector<int> used(bounds.squared.size());
    for (int face = 0; face < 6; ++face) {
        for (int level = 0; level < bounds.levels; ++level)
            for (int j = 0; j < bounds.side >> level; ++j)
                for (int i = 0; i < bounds.side >> level; ++i) ++used.at(bounds.index(face, level, i, j));
        for (int j = 0; j < bounds.horizonSide(); ++j)
            for (int i = 0; i < bounds.horizonSide(); ++i) {
                ++used.at(bounds.horizonIndex(face, i, j));
                ++used.at(bounds.horizonLeastIndex(face, i, j));
            }
    }
    EXPECT_EQ(*std::max_element(used.begin(), used.end()), 1);
}

}  // namespace
}  // namespace dsphere::test
