// Small maps of kinds that people really have. Those of Mars are greatest near 18.28 N 133.59 W and least near 42 S 70
// E.

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "scene/parser.h"
#include "surface/heightmap.h"
#include "surface/scenemaps.h"
#include "tests/support/expecterror.h"

namespace dsphere::test {
namespace {

const std::filesystem::path kCases = std::filesystem::path(DSPHERE_SOURCE_DIR) / "tests/data/cases";

Heightmap load(const std::string& name) {
    DisplacedSphere shape;
    shape.map_path = (kCases / "maps" / name).string();
    return loadHeightmap(shape);
}

std::string refusal(const std::string& name) {
    return messageOf(ExitCode::InvalidInput, [&] { load(name); });
}

/// Degrees of the greatest sample, by the map's own registration and longitude origin.
struct Place {
    double latitude, longitude;
};
Place peakOf(const Heightmap& map) {
    const auto k = std::ranges::max_element(map.samples) - map.samples.begin();
    const double half = map.registration == Registration::Texel ? 0.5 : 0.0;
    const double rows = map.registration == Registration::Texel ? map.height : map.height - 1;
    return {90.0 - (double(k / map.width) + half) * 180.0 / rows,
            map.longitude_origin + (double(k % map.width) + half) * 360.0 / map.width};
}

void expectPeak(const Heightmap& map, double latitude, double longitude, double degrees) {
    const Place peak = peakOf(map);
    EXPECT_NEAR(peak.latitude, latitude, degrees);
    EXPECT_NEAR(peak.longitude, longitude, degrees);
}

bool warns(const Heightmap& map, std::string_view words) {
    return std::ranges::any_of(map.notices, [&](const Notice& notice) {
        return notice.kind == Notice::Kind::Warning && notice.text.find(words) != std::string::npos;
    });
}

TEST(MapCases, AGeoidInPgmIsThatInGtx) {
    const Heightmap gtx = load("egm96_5deg.gtx"), pgm = load("egm96_5deg_geographiclib.pgm");
    EXPECT_EQ(pgm.registration, Registration::Gridline);
    EXPECT_EQ(pgm.longitude_origin, 0.0);
    ASSERT_EQ(pgm.width, gtx.width);
    ASSERT_EQ(pgm.height, gtx.height);
    EXPECT_EQ(gtx.longitude_origin, -180.0);
    // The same nodes half around; stored in steps of 3 mm, counted from 108 m below.
    for (int j = 0; j < gtx.height; ++j)
        for (int i = 0; i < gtx.width; ++i)
            ASSERT_NEAR(-108.0 + 0.003 * double(pgm.at((i + gtx.width / 2) % gtx.width, j)), double(gtx.at(i, j)),
                        0.0031)
                << i << ", " << j;
}

TEST(MapCases, GridLinesWithOneColumnTooMany) {
    const Heightmap map = load("gridline_w_plus_1.tif");
    EXPECT_EQ(map.width, 64);
    EXPECT_EQ(map.height, 33);
    EXPECT_EQ(map.registration, Registration::Gridline);
    EXPECT_EQ(map.longitude_origin + 48 * 360.0 / map.width, 90.0);
    expectPeak(map, 18.28, -133.59, 360.0 / 64);
}

TEST(MapCases, ASceneOfGridLinesWithOneColumnTooMany) {
    const Scene scene = parseSceneFile((kCases / "scenes/03-gridline-duplicate-column.pbrt").string());
    const SceneMaps maps = loadSceneMaps(scene);
    EXPECT_EQ(maps.maps.at(0)->width, 90);
    EXPECT_EQ(peakOf(*maps.maps[0]).longitude, 148.0);
    EXPECT_EQ(maps.notices().at(0).kind, Notice::Kind::Note);
    EXPECT_TRUE(holds(maps.notices()[0].text, "the last of its 91 columns repeats the first"));
}

TEST(MapCases, ColoursAreNoHeights) {
    EXPECT_TRUE(
        holds(refusal("terrarium.png"), "red, green and blue channels differ (R 98 to 207, G 0 to 255, B 0 to 255)"));
    EXPECT_TRUE(holds(refusal("terrarium.png"), "Terrarium"));
    EXPECT_TRUE(holds(refusal("palette_hypsometric.png"), "its palette holds colours, not heights"));
    EXPECT_TRUE(holds(refusal("xyz_z_up.exr"), "X, Y and Z are vectors"));
}

TEST(MapCases, ATransparentValueIsUnknown) {
    const Heightmap map = load("trns_16.png");
    EXPECT_EQ(map.nodata_count, 462u);
    EXPECT_EQ(map.least, 2930.0f);
    EXPECT_EQ(map.type, "16-bit PNG with a transparent colour");
    expectPeak(map, 18.28, -133.59, 360.0 / 128);
}

TEST(MapCases, LayersAndAlphaOfExr) {
    const Heightmap layer = load("blender_multilayer.exr"), red = load("red_alpha.exr");
    EXPECT_EQ(layer.type, "colour EXR with alpha, layer ViewLayer.Combined");
    EXPECT_EQ(red.type, "EXR with alpha");
    EXPECT_EQ(layer.samples, red.samples) << "the layer's channels are equal";
    EXPECT_FALSE(warns(layer, "channels differ"));
    expectPeak(red, 18.28, -133.59, 360.0 / 32);
}

}  // namespace
}  // namespace dsphere::test
