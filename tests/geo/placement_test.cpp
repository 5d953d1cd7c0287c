#include "geo/placement.h"

#include <gtest/gtest.h>

#include "tests/support/expecterror.h"

namespace dsphere::test {
namespace {

using geo::LatLonGrid;
using geo::Placement;

Placement place(const LatLonGrid& grid) {
    return geo::placeOnSphere("map.tif", grid);
}

std::string refusal(const LatLonGrid& grid) {
    return messageOf(ExitCode::InvalidInput, [&] { place(grid); });
}

TEST(Placement, AWholeSphereOfTexels) {
    const Placement placed = place({8, 4, -180.0, 90.0, 45.0, -45.0});
    EXPECT_EQ(placed.columns, 8);
    EXPECT_EQ(placed.rows, 4);
    EXPECT_EQ(placed.rows_above, 0);
    EXPECT_FALSE(placed.mirrored || placed.flipped || placed.gridline);
    EXPECT_EQ(placed.longitude_origin, -180.0);
    EXPECT_TRUE(placed.notices.empty());
}

TEST(Placement, AnyLongitudeMayBeTheLeftEdge) {
    EXPECT_EQ(place({8, 4, 0.0, 90.0, 45.0, -45.0}).longitude_origin, 0.0);
    EXPECT_EQ(place({8, 4, 180.0, 90.0, 45.0, -45.0}).longitude_origin, -180.0);
    EXPECT_EQ(place({8, 4, 270.0, 90.0, 45.0, -45.0}).longitude_origin, -90.0);
    EXPECT_EQ(place({8, 4, -360.0, 90.0, 45.0, -45.0}).longitude_origin, 0.0);
    EXPECT_EQ(place({8, 4, 0.0, 90.0, 45.0, -45.0}).extent.east, 360.0);
}

TEST(Placement, ColumnsWestwardAndRowsNorthward) {
    const Placement placed = place({8, 4, 360.0, -90.0, -45.0, 45.0});
    EXPECT_TRUE(placed.mirrored && placed.flipped);
    EXPECT_EQ(placed.longitude_origin, 0.0);
    EXPECT_EQ(placed.extent.south, -90.0);
    EXPECT_EQ(placed.extent.north, 90.0);
}

TEST(Placement, NodesWithARepeatedColumn) {
    const Placement placed = place({9, 5, -202.5, 112.5, 45.0, -45.0});
    EXPECT_EQ(placed.columns, 8);
    EXPECT_EQ(placed.rows, 5);
    EXPECT_TRUE(placed.gridline);
    EXPECT_EQ(placed.longitude_origin, -180.0);
    EXPECT_EQ(placed.extent.west, -180.0);
    EXPECT_EQ(placed.extent.north, 90.0);
    ASSERT_EQ(placed.notices.size(), 1u);
    EXPECT_TRUE(holds(placed.notices[0].text, "last of its 9 columns repeats the first"));
}

TEST(Placement, RowsThatEndBeforeThePoles) {
    const Placement placed = place({360, 118, -180.0, 59.0, 1.0, -1.0});
    EXPECT_EQ(placed.rows, 180);
    EXPECT_EQ(placed.rows_above, 31);
    ASSERT_EQ(placed.notices.size(), 1u);
    EXPECT_TRUE(holds(placed.notices[0].text, "covers latitudes -59 to 59; the 62 rows beyond are unknown"));
    const Placement nodes = place({8, 3, -180.0, 67.5, 45.0, -45.0});
    EXPECT_TRUE(nodes.gridline);
    EXPECT_EQ(nodes.rows, 5);
    EXPECT_EQ(nodes.rows_above, 1);
}

TEST(Placement, StepsRoundedInTheFile) {
    const Placement placed = place({43200, 21600, -180.0, 90.0, 0.00833333, -0.00833333});
    EXPECT_EQ(placed.columns, 43200);
    EXPECT_EQ(placed.rows, 21600);
    ASSERT_EQ(placed.notices.size(), 1u);
    EXPECT_TRUE(holds(placed.notices[0].text, "taken as 360"));
}

TEST(Placement, RefusesPiecesAndNamesTheWayOut) {
    for (const LatLonGrid& grid : {LatLonGrid{64, 64, -154.0, 38.0, 0.625, -0.625},  // a region
                                   LatLonGrid{7, 4, -180.0, 90.0, 45.0, -45.0},      // a column short
                                   LatLonGrid{8, 3, -180.0, 80.0, 45.0, -45.0},      // rows beside the sphere's
                                   LatLonGrid{8, 6, -180.0, 135.0, 45.0, -45.0},     // beyond the poles
                                   LatLonGrid{8, 3, -180.0, 90.0, 45.0, -52.0}}) {   // 3.46 rows
        EXPECT_TRUE(holds(refusal(grid), "dsphere import"));
        EXPECT_TRUE(holds(refusal(grid), "map.tif: covers "));
    }
}

TEST(Placement, RefusesStepsOfNothing) {
    const double nan = std::nan("");
    EXPECT_TRUE(holds(refusal({8, 4, -180.0, 90.0, 0.0, -45.0}), "0 by -45 degrees"));
    EXPECT_TRUE(holds(refusal({8, 4, -180.0, 90.0, 45.0, nan}), "finite"));
    EXPECT_TRUE(holds(refusal({8, 4, -180.0, 90.0, 1e-300, -45.0}), "dsphere import"));
    EXPECT_TRUE(holds(refusal({8, 4, -180.0, 90.0, 1e300, -45.0}), "dsphere import"));
}

}  // namespace
}  // namespace dsphere::test
