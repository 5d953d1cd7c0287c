// Worked out by hand on maps of 5x3 texels.

#include "surface/fill.h"

#include <gtest/gtest.h>

#include <limits>

#include "surface/heightmap.h"
#include "surface/scenemaps.h"
#include "tests/support/expecterror.h"
#include "tests/support/pngwriter.h"
#include "tests/support/tempfolder.h"
#include "tests/surface/grids.h"

namespace dsphere::test {
namespace {

constexpr float kX = -9999.0f;
const float kNan = std::numeric_limits<float>::quiet_NaN();

struct Filled {
    std::vector<float> samples;
    std::size_t count;
};

Filled fill(std::vector<float> samples, int width, int height, std::optional<double> nodata) {
    const std::size_t count = fillNodata(samples, width, height, Nodata(nodata));
    return {std::move(samples), count};
}

TEST(Nodata, TheNearestOfTheRowWrapsAndPrefersTheLeft) {
    const Filled filled = fill({kX, 1, kX, kX, 2,   // 0: one to the right and, across the seam, one to the left
                                kX, kX, 3, kX, kX,  // one value alone
                                4, kX, kX, kX, 5},  // 2: two from 4 and two from 5
                               5, 3, -9999.0);
    EXPECT_EQ(filled.samples, (std::vector<float>{2, 1, 1, 2, 2, 3, 3, 3, 3, 3, 4, 4, 4, 5, 5}));
    EXPECT_EQ(filled.count, 10u);
}

TEST(Nodata, AGapAcrossTheSeam) {
    const Filled filled = fill({kX, kX, 1, 2, kX,  // 4, 0, 1 between 2 and 1
                                kX, 7, 8, 9, kX,   // 4, 0 between 9 and 7
                                1, 2, 3, 4, 5},
                               5, 3, -9999.0);
    EXPECT_EQ(filled.samples, (std::vector<float>{2, 1, 1, 2, 2, 7, 7, 8, 9, 9, 1, 2, 3, 4, 5}));
    EXPECT_EQ(filled.count, 5u);
}

TEST(Nodata, ARowOfNothingElseTakesTheNearestRow) {
    const std::vector<float> none(5, kX), a{1, kX, 3, 4, 5}, b{6, 7, 8, 9, kX}, a_filled{1, 1, 3, 4, 5},
        b_filled{6, 7, 8, 9, 9};
    const auto stack = [](std::initializer_list<std::vector<float>> rows) {
        std::vector<float> all;
        for (const auto& row : rows) all.insert(all.end(), row.begin(), row.end());
        return all;
    };
    EXPECT_EQ(fill(stack({a, none, b}), 5, 3, -9999.0).samples, stack({a_filled, a_filled, b_filled}));
    EXPECT_EQ(fill(stack({none, none, b}), 5, 3, -9999.0).samples, stack({b_filled, b_filled, b_filled}));
    EXPECT_EQ(fill(stack({a, none, none}), 5, 3, -9999.0).samples, stack({a_filled, a_filled, a_filled}));
    EXPECT_EQ(fill(stack({a, none, none, b}), 5, 4, -9999.0).samples, stack({a_filled, a_filled, b_filled, b_filled}));
    const Filled tie = fill(stack({none, a, none, none, none, b}), 5, 6, -9999.0);
    EXPECT_EQ(tie.samples, stack({a_filled, a_filled, a_filled, a_filled, b_filled, b_filled}));
    EXPECT_EQ(tie.count, 22u);
}

TEST(Nodata, NothingButNodataIsLeft) {
    const Filled filled = fill(std::vector<float>(15, kX), 5, 3, -9999.0);
    EXPECT_EQ(filled.samples, std::vector<float>(15, kX));
    EXPECT_EQ(filled.count, 15u);
    EXPECT_EQ(fill({1, kX}, 2, 1, {}).samples, (std::vector<float>{1, kX}));
    EXPECT_EQ(fill({1, kX}, 2, 1, {}).count, 0u);
}

TEST(Nodata, IsTheStoredFloat) {
    EXPECT_EQ(fill({-88.8888f, 3}, 2, 1, -88.8888).samples, (std::vector<float>{3, 3}));
    const float most = std::numeric_limits<float>::max();
    EXPECT_EQ(fill({-most, 3}, 2, 1, -3.4028235e38).samples, (std::vector<float>{3, 3}));
    EXPECT_EQ(fill({kNan, 3, std::bit_cast<float>(0xffc12345u)}, 3, 1, std::nan("")).samples,
              (std::vector<float>{3, 3, 3}));
    EXPECT_EQ(fill({0, 3}, 2, 1, std::nan("")).count, 0u);
}

TEST(Nodata, IsFilledBeforeThePolesAndCounted) {
    DisplacedSphere shape;
    shape.map_path = "map.pfm";
    shape.nodata = std::nan("");
    const Heightmap map = makeHeightmap(rawOf(2, 2, {kNan, 4, 1, 2}), shape);
    EXPECT_EQ(map.samples, (std::vector<float>{4, 4, 1, 2}));
    EXPECT_EQ(map.north_pole, 4.0f);
    EXPECT_EQ(map.nodata_count, 1u);
    shape.nodata.reset();
    EXPECT_EQ(makeHeightmap(rawOf(1, 1, {1}), shape).nodata_count, 0u);
}

TEST(Nodata, AMapOfNothingElseIsRefused) {
    DisplacedSphere shape;
    shape.map_path = "map.pfm";
    shape.nodata = -9999.0;
    const auto refusal = [&](std::vector<float> samples) {
        return messageOf(ExitCode::InvalidInput, [&] { makeHeightmap(rawOf(3, 1, samples), shape); });
    };
    EXPECT_TRUE(holds(refusal({kX, kX, kX}), "map.pfm: every one of the 3x1 texels is unknown"));
    EXPECT_TRUE(holds(refusal({kX, kNan, kX}), "map.pfm: every one of the 3x1 texels is unknown"));
}

TEST(Nodata, AShapeWithoutAMapHasNone) {
    DisplacedSphere shape;
    shape.nodata = 0.0;
    EXPECT_EQ(loadHeightmap(shape).nodata_count, 0u);
}

TEST(SceneMaps, ShareOnlyWhatIsFilledAndBlurredAlike) {
    const TempFolder folder;
    DisplacedSphere sphere;
    sphere.map_path = folder.write("map.png", pngFile(2, 1, 16, PngColour::Grey, {1, 40000})).string();
    std::vector<DisplacedSphere> spheres(7, sphere);
    spheres[1].nodata = std::nan("");
    spheres[2].nodata = std::nan("");
    spheres[3].nodata = 1.0;
    spheres[4].nodata = 1.0;
    spheres[5].blur = 1.0;
    spheres[6].blur = 2.0;
    Scene scene;
    for (const DisplacedSphere& each : spheres) {
        Shape shape;
        shape.geometry = each;
        scene.shapes.push_back(shape);
    }
    EXPECT_EQ(loadSceneMaps(scene).map_of_shape, (std::vector<int>{0, 1, 1, 2, 2, 3, 4}));
}

}  // namespace
}  // namespace dsphere::test
