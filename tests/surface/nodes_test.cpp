// NodeGrid: its bilinear surface is that of the reference, which reads the map itself.

#include "surface/nodes.h"

#include "reference/surface.h"
#include "tests/surface/grids.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace dsphere::test {
namespace {

/// The grid's stored value in a direction, by the rule of its header.
double gridValue(const NodeGrid& nodes, const dvec3& w) {
    double column = nodes.column(std::atan2(w.x, w.z)), row = nodes.nodeRow(std::atan2(std::hypot(w.x, w.z), w.y));
    int j = std::clamp(int(std::floor(row)), 0, nodes.rows() - 1);
    double fu = column - std::floor(column), fv = row - j;
    if (nodes.halfCaps() && j == 0) fv = 2.0 * (row - 0.5);
    if (nodes.halfCaps() && j == nodes.rows() - 1) fv = 2.0 * (row - j);
    int i = int(((long long)(std::floor(column)) % nodes.width() + nodes.width()) % nodes.width());
    int k = (i + 1) % nodes.width();
    const float *north = nodes.row(j), *south = nodes.row(j + 1);
    return (north[i] + fu * (double(north[k]) - north[i])) * (1.0 - fv) +
           (south[i] + fu * (double(south[k]) - south[i])) * fv;
}

struct GridCase {
    int width, height;
    Registration registration;
    double longitude_origin;
};

void PrintTo(const GridCase& c, std::ostream* out) {
    *out << c.width << 'x' << c.height << (c.registration == Registration::Texel ? " texel" : " gridline") << " from "
         << c.longitude_origin;
}

class NodesTest : public testing::TestWithParam<GridCase> {
  protected:
    std::unique_ptr<Planet> planet_ = makePlanet(randomMap(GetParam().width, GetParam().height),
                                                 GetParam().registration, 20.0, GetParam().longitude_origin);
    NodeGrid nodes_{planet_->map};
};

TEST_P(NodesTest, SurfaceIsTheReferences) {
    reference::Surface reference(planet_->map, planet_->relief);
    std::mt19937 random(1);
    std::normal_distribution<double> normal;
    double worst = 0.0;
    for (int k = 0; k < 20000; ++k) {
        dvec3 w(normal(random), normal(random), normal(random));
        // Every other one near the poles, or near the seam.
        if (k % 4 == 1) w *= dvec3(0.01, 1.0, 0.01);
        if (k % 4 == 3) w = dvec3(1e-4 * w.x, w.y, -std::abs(w.z));
        worst = std::max(worst, std::abs(gridValue(nodes_, w) - reference.stored(w)));
    }
    // A subdivided node is rounded to float: half an ulp of 65535; the angles cost 1e-12 of a texel's 65535.
    EXPECT_LE(worst, 65535.0 * 0x1p-25 + 1e-5);
}

TEST_P(NodesTest, CellsAreSmall) {
    EXPECT_LE(nodes_.cellWidth(), 2.0 * kPi / 512 * (1.0 + 1e-12));
    EXPECT_LE(nodes_.cellHeight(), kPi / 256 * (1.0 + 1e-12));
    EXPECT_NEAR(nodes_.cellWidth() * nodes_.width(), 2.0 * kPi, 1e-12);
    double rows = nodes_.rows() - (nodes_.halfCaps() ? 1.0 : 0.0);
    EXPECT_NEAR(nodes_.cellHeight() * rows, kPi, 1e-12);
}

TEST_P(NodesTest, AnglesAndCoordinatesAreInverse) {
    for (int i = 0; i < nodes_.width(); i += 7) EXPECT_NEAR(nodes_.column(nodes_.longitude(i)), i, 1e-9);
    EXPECT_EQ(nodes_.colatitude(0), 0.0);
    EXPECT_EQ(nodes_.colatitude(nodes_.rows()), kPi);
    for (int j = 1; j < nodes_.rows(); ++j) EXPECT_NEAR(nodes_.nodeRow(nodes_.colatitude(j)), j, 1e-9);
}

TEST_P(NodesTest, PoleRowsAreConstant) {
    for (int i = 0; i < nodes_.width(); ++i) {
        ASSERT_EQ(nodes_.row(0)[i], planet_->map.north_pole);
        ASSERT_EQ(nodes_.row(nodes_.rows())[i], planet_->map.south_pole);
    }
}

TEST_P(NodesTest, NodesAreWithinTheMapsRange) {
    for (int j = 0; j <= nodes_.rows(); ++j)
        for (int i = 0; i < nodes_.width(); ++i) {
            ASSERT_GE(nodes_.row(j)[i], planet_->map.least);
            ASSERT_LE(nodes_.row(j)[i], planet_->map.greatest);
        }
}

INSTANTIATE_TEST_SUITE_P(
    Sizes, NodesTest,
    testing::Values(GridCase{1, 1, Registration::Texel, -180}, GridCase{1, 2, Registration::Gridline, -180},
                    GridCase{2, 1, Registration::Texel, 0}, GridCase{3, 2, Registration::Texel, -180},
                    GridCase{3, 3, Registration::Gridline, 17}, GridCase{7, 5, Registration::Texel, 0},
                    GridCase{64, 32, Registration::Texel, -180}, GridCase{65, 33, Registration::Gridline, 0},
                    GridCase{511, 255, Registration::Texel, 5}, GridCase{512, 256, Registration::Texel, -180},
                    GridCase{513, 257, Registration::Gridline, -180}, GridCase{600, 40, Registration::Texel, -180},
                    GridCase{40, 300, Registration::Gridline, 0}, GridCase{1024, 512, Registration::Texel, 180}));

TEST(Nodes, AFineMapIsNotCopied) {
    auto planet = makePlanet(randomMap(512, 256), Registration::Texel, 20.0);
    NodeGrid nodes(planet->map);
    EXPECT_EQ(nodes.row(1), planet->map.samples.data());
}

}  // namespace
}  // namespace dsphere::test
