#include "image/mapchannels.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "tests/image/encoders.h"
#include "tests/support/expecterror.h"
#include "tests/support/tempfolder.h"

namespace dsphere::test {
namespace {

using Rgb = std::array<float, 3>;

/// What the census of a map of those texels (row-major, `width` columns) says of it; its one notice, or none.
RawMap reportOf(const std::vector<Rgb>& texels, std::size_t width, double full_scale = 255.0) {
    RawMap map;
    map.full_scale = full_scale;
    ColourCensus census;
    for (std::size_t k = 0; k < texels.size(); ++k) {
        if (k % width == 0) census.startRow();
        map.samples.push_back(census.grey(texels[k][0], texels[k][1], texels[k][2]));
    }
    census.report(map, "map.png");
    return map;
}

constexpr int kColumns = 256, kRows = 64;

/// Heights in metres of hills that are `steepness` metres high a texel at most, with the sea at 0.
std::vector<double> hills(double steepness) {
    std::vector<double> heights;
    for (int j = 0; j < kRows; ++j)
        for (int i = 0; i < kColumns; ++i) {
            const double x = i * 0.07, y = j * 0.11;
            heights.push_back(std::max(0.0, steepness / 0.1 * (std::sin(x) * std::cos(y) + 0.4 * std::sin(3 * x + y))));
        }
    return heights;
}

std::vector<Rgb> terrarium(const std::vector<double>& heights) {
    std::vector<Rgb> texels;
    for (const double height : heights) {
        const double code = height + 32768.0, whole = std::floor(code);
        texels.push_back(
            {float(std::floor(whole / 256)), float(std::fmod(whole, 256)), float(std::floor((code - whole) * 256))});
    }
    return texels;
}

std::vector<Rgb> terrainRgb(const std::vector<double>& heights) {
    std::vector<Rgb> texels;
    for (const double height : heights) {
        const auto code = unsigned((height + 10000.0) * 10.0);
        texels.push_back({float(code >> 16), float(code >> 8 & 255), float(code & 255)});
    }
    return texels;
}

TEST(ColourCensus, EqualChannelsAreKeptAndNotMentioned) {
    const RawMap map = reportOf({{1, 1, 1}, {200, 200, 200}, {3, 3, 3}}, 3);
    EXPECT_EQ(map.samples, (std::vector<float>{1, 200, 3}));
    EXPECT_TRUE(map.notices.empty());
}

TEST(ColourCensus, DifferingChannelsAreWarnedOf) {
    const RawMap map = reportOf({{0, 3, 0}, {255, 201, 90}, {7, 7, 7}}, 3);
    EXPECT_EQ(map.samples, (std::vector<float>{1, 182, 7}));
    EXPECT_EQ(map.notices,
              (Notices{{Notice::Kind::Warning,
                        "map.png: its red, green and blue channels differ (R 0 to 255, G 3 to 201, B 0 to 90): heights "
                        "are their mean; a picture is no heightmap"}}));
}

TEST(ColourCensus, SlightDifferencesAreNoted) {
    const RawMap map = reportOf({{0, 0, 0}, {200, 201, 200}, {7, 7, 7}}, 3);
    ASSERT_EQ(map.notices.size(), 1u);
    EXPECT_EQ(map.notices[0].kind, Notice::Kind::Note);
    EXPECT_TRUE(holds(map.notices[0].text, "by at most 1: heights are their mean"));
    const RawMap floats = reportOf({{0, 0, 0}, {1.0f, 1.0f, 0.5f}}, 2, 1.0);
    EXPECT_EQ(floats.notices.at(0).kind, Notice::Kind::Warning);
}

TEST(ColourCensus, LeavesValuesThatAreNotFiniteOut) {
    const float nan = std::nanf("");
    EXPECT_TRUE(reportOf({{nan, nan, nan}, {1, 1, 1}, {-HUGE_VALF, 1, 1}}, 3, 1.0).notices.empty());
}

TEST(ColourCensus, HeightsCodedInBytesAreRefused) {
    for (const double steepness : {3.0, 20.0, 100.0, 400.0}) {
        SCOPED_TRACE(steepness);
        const auto refusal = [](const std::vector<Rgb>& texels) {
            return messageOf(ExitCode::InvalidInput, [&] { reportOf(texels, kColumns); });
        };
        EXPECT_TRUE(holds(refusal(terrarium(hills(steepness))), "R x 256 + G + B / 256 - 32768 (Terrarium)"));
        EXPECT_TRUE(
            holds(refusal(terrainRgb(hills(steepness))), "(R x 65536 + G x 256 + B) x 0.1 (Mapbox Terrain-RGB)"));
        EXPECT_TRUE(
            holds(refusal(terrarium(hills(steepness))), "map.png: its red, green and blue channels differ (R 1"));
    }
}

TEST(ColourCensus, PicturesAreWarnedOfOnly) {
    std::mt19937 random(3);
    std::vector<Rgb> noise, ramps, flags, normals;
    const std::vector<double> heights = hills(50.0);
    for (std::size_t k = 0; k < heights.size(); ++k) {
        noise.push_back({float(random() % 256), float(random() % 256), float(random() % 256)});
        const auto h = float(std::min(255.0, heights[k] / 3.0));
        ramps.push_back({std::floor(h), std::floor(255 - h), std::floor(h * h / 256)});  // blue-green to red
        flags.push_back(k / 16 % 2 ? Rgb{255, 0, 40} : Rgb{20, 200, 0});
        const double slope = k + 1 < heights.size() ? (heights[k + 1] - heights[k]) / 10.0 : 0.0;
        normals.push_back({float(std::round(128 + slope)), float(std::round(128 - slope / 2)), 255});
    }
    for (const auto& texels : {noise, ramps, flags, normals})
        EXPECT_EQ(reportOf(texels, kColumns).notices.at(0).kind, Notice::Kind::Warning);
}

TEST(AlphaCensus, SaysWhichTexelsAreKnown) {
    AlphaCensus census(255.0);
    EXPECT_TRUE(census.isKnown(255));
    EXPECT_TRUE(census.isKnown(1));
    EXPECT_FALSE(census.isKnown(0));
    RawMap map;
    map.samples.resize(3);
    census.report(map, "map.png");
    EXPECT_TRUE(map.unknown_are_nan);
    EXPECT_EQ(map.notices,
              (Notices{{Notice::Kind::Note,
                        "map.png: partly transparent texels: 1; their heights count as they are stored"}}));
}

TEST(AlphaCensus, OpaqueIsNothingAndTransparentEverywhereIsRefused) {
    AlphaCensus opaque(1.0), hidden(1.0);
    RawMap map;
    map.samples.resize(1);
    EXPECT_TRUE(opaque.isKnown(1.0f));
    opaque.report(map, "map.png");
    EXPECT_FALSE(map.unknown_are_nan);
    EXPECT_TRUE(map.notices.empty());
    EXPECT_FALSE(hidden.isKnown(std::nanf("")));
    EXPECT_TRUE(
        holds(messageOf(ExitCode::InvalidInput, [&] { hidden.report(map, "map.png"); }), "alpha is 0 everywhere"));
}

TEST(ColourCensus, SpeaksForPpmAndColourPfm) {
    const TempFolder folder;
    const RawMap ppm = readRawMap(folder.write("a.ppm", pnmFile(2, 1, 255, {1, 2, 4, 90, 7, 7})));
    EXPECT_TRUE(
        holds(ppm.notices.at(0).text, "a.ppm: its red, green and blue channels differ (R 1 to 90, G 2 to 7, B"));
    const RawMap pfm = readRawMap(folder.write("a.pfm", pfmFile(1, 2, {0.1f, 0.2f, 0.4f, 0.7f, 0.7f, 0.7f}, true)));
    EXPECT_TRUE(holds(pfm.notices.at(0).text, "(R 0.1 to 0.7, G 0.2 to 0.7, B 0.4 to 0.7)"));
    EXPECT_TRUE(readRawMap(folder.write("b.ppm", pnmFile(2, 1, 255, {1, 1, 1, 9, 9, 9}))).notices.empty());
}

}  // namespace
}  // namespace dsphere::test
