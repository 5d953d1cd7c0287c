#include "surface/preparemap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "surface/heightmap.h"
#include "tests/support/expecterror.h"
#include "tests/surface/grids.h"

namespace dsphere::test {
namespace {

const float kNan = std::nanf("");

DisplacedSphere shapeOf(std::optional<Registration> registration = {}) {
    DisplacedSphere shape;
    shape.map_path = "map.tif";
    shape.registration = registration;
    return shape;
}

/// Values that differ from node to node; `columns` distinct ones, the first again as the last.
RawMap gridOf(int columns, int rows) {
    RawMap map = rawOf(columns + 1, rows, {});
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i <= columns; ++i) map.samples.push_back(float(100 * j + i % columns));
    return map;
}

TEST(PrepareMap, AMapOnGridLinesLosesItsLastColumn) {
    const Heightmap map = makeHeightmap(gridOf(8, 5), shapeOf());
    EXPECT_EQ(map.width, 8);
    EXPECT_EQ(map.height, 5);
    EXPECT_EQ(map.registration, Registration::Gridline);
    EXPECT_EQ(map.at(0, 1), 100.0f);
    EXPECT_EQ(map.at(7, 3), 307.0f);
    EXPECT_EQ(map.notices,
              (Notices{{Notice::Kind::Note,
                        "map.tif: the last of its 9 columns repeats the first and is left out; with 5 rows "
                        "that is a map on grid lines, and is read as such"}}));
}

TEST(PrepareMap, TheScenesRegistrationCounts) {
    const Heightmap texel = makeHeightmap(gridOf(8, 5), shapeOf(Registration::Texel));
    EXPECT_EQ(texel.width, 8);
    EXPECT_EQ(texel.registration, Registration::Texel);
    EXPECT_EQ(texel.notices.at(0).text, "map.tif: the last of its 9 columns repeats the first and is left out");
    const Heightmap gridline = makeHeightmap(gridOf(8, 7), shapeOf(Registration::Gridline));
    EXPECT_EQ(gridline.width, 8);
    EXPECT_EQ(gridline.registration, Registration::Gridline);
    RawMap said = gridOf(8, 7);
    said.gridline = true;
    EXPECT_EQ(makeHeightmap(said, shapeOf()).width, 8);
    // A texel more than 2 to 1: columns repeat, rows tell nothing.
    const Heightmap texels = makeHeightmap(gridOf(8, 4), shapeOf());
    EXPECT_EQ(texels.width, 8);
    EXPECT_EQ(texels.registration, Registration::Texel);
}

TEST(PrepareMap, OtherColumnsStay) {
    RawMap differs = gridOf(8, 5);
    differs.samples.back() += 1.0f;
    EXPECT_EQ(makeHeightmap(differs, shapeOf()).width, 9);
    EXPECT_EQ(makeHeightmap(gridOf(7, 5), shapeOf()).width, 8) << "an even number of columns has no node too many";
    EXPECT_EQ(makeHeightmap(rawOf(9, 5, std::vector<float>(45, 3.0f)), shapeOf()).width, 9) << "a sphere";
    RawMap zones = rawOf(9, 5, {});
    for (int k = 0; k < 45; ++k) zones.samples.push_back(float(k / 9));
    EXPECT_EQ(makeHeightmap(zones, shapeOf()).width, 9) << "nothing changes with longitude";
    RawMap island = rawOf(9, 5, std::vector<float>(45, 0.0f));
    island.samples[22] = 5.0f;
    EXPECT_EQ(makeHeightmap(island, shapeOf()).width, 9) << "sea at both edges";
    EXPECT_EQ(makeHeightmap(island, shapeOf(Registration::Gridline)).width, 8);
}

TEST(PrepareMap, TheShapeOfGridLinesIsNoted) {
    const RawMap map = rawOf(32, 17, std::vector<float>(32 * 17, 1.0f));
    const Heightmap texels = makeHeightmap(map, shapeOf());
    EXPECT_EQ(texels.registration, Registration::Texel);
    EXPECT_TRUE(holds(texels.notices.at(0).text, "map.tif: 32x17 texels are the shape of a map on grid lines"));
    EXPECT_TRUE(makeHeightmap(map, shapeOf(Registration::Texel)).notices.empty());
    EXPECT_TRUE(makeHeightmap(map, shapeOf(Registration::Gridline)).notices.empty());
}

TEST(PrepareMap, UnknownTexelsMayRepeat) {
    RawMap map = gridOf(8, 5);
    map.samples[9] = map.samples[17] = kNan;
    map.unknown_are_nan = true;
    const Heightmap heights = makeHeightmap(map, shapeOf());
    EXPECT_EQ(heights.width, 8);
    EXPECT_EQ(heights.nodata_count, 1u);
}

TEST(PrepareMap, WhatIsNoNumberIsUnknownAndWarnedOf) {
    for (const float bad : {kNan, HUGE_VALF, -HUGE_VALF, -3.4028235e38f, -3.4e38f, 3.4028235e38f}) {
        SCOPED_TRACE(bad);
        const Heightmap map = makeHeightmap(rawOf(3, 2, {1, 2, 3, 4, bad, bad}), shapeOf());
        EXPECT_EQ(map.samples, (std::vector<float>{1, 2, 3, 4, 4, 4}));
        EXPECT_EQ(map.nodata_count, 2u);
        ASSERT_EQ(map.notices.size(), 1u);
        EXPECT_EQ(map.notices[0].kind, Notice::Kind::Warning);
        EXPECT_TRUE(
            holds(map.notices[0].text, "map.tif: 2 of 6 texels hold no number that could be a height, the first "));
        EXPECT_TRUE(holds(map.notices[0].text, "at column 1, row 1"));
    }
}

TEST(PrepareMap, WhatIsNoNumberNeedsNoWarningWhereNodataIsDeclared) {
    DisplacedSphere shape = shapeOf();
    shape.nodata = -9999.0;
    const Heightmap map = makeHeightmap(rawOf(4, 1, {1, -9999, -HUGE_VALF, -3.4028235e38f}), shape);
    EXPECT_EQ(map.nodata_count, 3u);
    EXPECT_EQ(map.storedLeast(), 1.0);
    EXPECT_TRUE(map.notices.empty());
    RawMap masked = rawOf(3, 1, {1, kNan, -HUGE_VALF});
    masked.unknown_are_nan = true;
    EXPECT_TRUE(makeHeightmap(masked, shapeOf()).notices.empty());
}

TEST(PrepareMap, ACommonNodataValueIsWarnedOf) {
    const Heightmap map = makeHeightmap(rawOf(4, 1, {20472, -32768, -7659, -32768}), shapeOf());
    EXPECT_EQ(map.least, -32768.0f) << "nobody said that it is unknown";
    EXPECT_EQ(map.notices,
              (Notices{{Notice::Kind::Warning,
                        "map.tif: 2 of 4 texels hold -32768, far below all others, which are -7659 to "
                        "20472: if that means unknown, say \"float nodata\" -32768 in the scene, or --nodata"}}));
    EXPECT_TRUE(makeHeightmap(rawOf(4, 1, {5, -9999, -9998, 3}), shapeOf()).notices.empty()) << "a sea floor";
    DisplacedSphere said = shapeOf();
    said.nodata = -9999.0;
    EXPECT_TRUE(makeHeightmap(rawOf(3, 1, {5, -9999, 3}), said).notices.empty());
    EXPECT_EQ(makeHeightmap(rawOf(3, 1, {5, -1e32f, 3}), shapeOf()).notices.size(), 1u);
}

}  // namespace
}  // namespace dsphere::test
