#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "image/rawmap.h"
#include "tests/image/encoders.h"
#include "tests/support/expecterror.h"
#include "tests/support/tempfolder.h"

namespace dsphere::test {
namespace {

RawMap readGtxOf(const std::string& bytes) {
    const TempFolder folder;
    return readRawMap(folder.write("map.GTX", bytes));
}

std::string refusalOf(const GtxHeader& header, std::size_t nodes) {
    return messageOf(ExitCode::InvalidInput, [&] { readGtxOf(header.bytes() + std::string(4 * nodes, '\0')); });
}

TEST(Gtx, KeepsFloatsAndTurnsTheRowsNorthFirst) {
    const std::vector<float> samples = floatRamp(40);
    const RawMap map = readGtxOf(gtxFile({}, samples));
    EXPECT_EQ(map.width, 8);
    EXPECT_EQ(map.height, 5);
    EXPECT_TRUE(map.gridline);
    EXPECT_EQ(map.longitude_origin, -180.0);
    EXPECT_EQ(map.full_scale, 1.0);
    EXPECT_EQ(map.type, "float32 GTX");
    EXPECT_EQ(map.facts.unit, "m") << "what a GTX has";
    EXPECT_EQ(map.samples, samples);
}

TEST(Gtx, DropsARepeatedLastColumn) {
    GtxHeader header;
    header.columns = 9;
    const std::vector<float> samples = floatRamp(45);
    const RawMap map = readGtxOf(gtxFile(header, samples));
    EXPECT_EQ(map.width, 8);
    for (std::size_t j = 0; j < 5; ++j)
        for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(map.samples[8 * j + i], samples[9 * j + i]);
}

TEST(Gtx, BringsTheWestLongitudeIntoRange) {
    GtxHeader header;
    const std::vector<float> samples(40);
    for (const auto& [west, expected] : {std::pair{0.0, 0.0}, {180.0, -180.0}, {190.0, -170.0}, {-190.0, 170.0}}) {
        header.west = west;
        EXPECT_EQ(readGtxOf(gtxFile(header, samples)).longitude_origin, expected);
    }
}

TEST(Gtx, AllowsRoundedSteps) {
    GtxHeader header{-90.0, 0.0, 0.666667, 0.666667, 271, 540};
    EXPECT_EQ(readGtxOf(gtxFile(header, std::vector<float>(271 * 540))).width, 540);
}

TEST(Gtx, ReadsNoDataAsNaN) {
    std::vector<float> samples(40, 1.0f);
    samples[11] = -88.8888f;
    const RawMap map = readGtxOf(gtxFile({}, samples));
    for (std::size_t k = 0; k < 40; ++k) EXPECT_EQ(std::isnan(map.samples[k]), k == 11);
}

TEST(Gtx, RefusesGridsOfLessThanTheGlobe) {
    EXPECT_TRUE(holds(refusalOf({-90.0, -180.0, 45.0, 45.0, 4, 8}, 32), "covers latitudes -90 to 45"));
    EXPECT_TRUE(holds(refusalOf({-67.5, -180.0, 45.0, 45.0, 4, 8}, 32), "covers latitudes -67.5 to 67.5"));
    EXPECT_TRUE(holds(refusalOf({-90.0, -180.0, 45.0, 45.0, 5, 7}, 35), "longitudes -180 to 90"));
    EXPECT_TRUE(holds(refusalOf({-90.0, -180.0, 45.0, 45.0, 5, 10}, 50), "longitudes -180 to 225"));
    EXPECT_TRUE(holds(refusalOf({90.0, -180.0, -45.0, 45.0, 5, 8}, 40), "covers"));
    EXPECT_TRUE(holds(refusalOf({-90.0, NAN, 45.0, 45.0, 5, 8}, 40), "covers"));
    EXPECT_TRUE(holds(refusalOf({NAN, -180.0, 45.0, 45.0, 5, 8}, 40), "covers"));
    EXPECT_TRUE(holds(refusalOf({-90.0, -180.0, 45.0, NAN, 5, 8}, 40), "covers"));
    EXPECT_TRUE(holds(refusalOf({-90.0, -180.0, 45.0, INFINITY, 5, 8}, 40), "covers"));
}

TEST(Gtx, RefusesSizesAndLengthsThatDisagree) {
    EXPECT_TRUE(holds(refusalOf({}, 39), "160 bytes after the header, 156 found"));
    EXPECT_TRUE(holds(refusalOf({}, 41), "160 bytes after the header, 164 found"));
    EXPECT_TRUE(holds(refusalOf({-90.0, -180.0, 45.0, 45.0, -5, 8}, 40), "8x-5"));
    EXPECT_TRUE(holds(refusalOf({-90.0, -180.0, 45.0, 45.0, 5, 0}, 40), "0x5"));
    EXPECT_TRUE(holds(refusalOf({-90.0, -180.0, 45.0, 45.0, 0x7fffffff, 8}, 40), "8x2147483647"));
}

// EGM96 of the Debian package proj-data, against figures of the geoid known from elsewhere.
TEST(Gtx, ReadsTheRealGeoid) {
    const std::filesystem::path path = "/usr/share/proj/egm96_15.gtx";
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " (package proj-data) is not installed";
    const RawMap map = readRawMap(path);
    ASSERT_EQ(map.width, 1440);
    ASSERT_EQ(map.height, 721);
    EXPECT_EQ(map.longitude_origin, -180.0);
    const auto at = [&](double latitude, double longitude) {
        const auto row = std::size_t((90.0 - latitude) * 4.0), column = std::size_t((longitude + 180.0) * 4.0);
        return map.samples[row * 1440 + column];
    };
    const auto [least, greatest] = std::ranges::minmax(map.samples);
    EXPECT_NEAR(least, -106.99, 0.01);
    EXPECT_EQ(at(4.75, 78.75), least);
    EXPECT_NEAR(greatest, 85.39, 0.01);
    EXPECT_EQ(at(-8.25, 147.25), greatest);
    EXPECT_NEAR(at(0.0, 0.0), 17.16, 0.01);
    EXPECT_NEAR(at(90.0, 0.0), 13.6, 0.01);
    EXPECT_NEAR(at(-90.0, 0.0), -29.53, 0.01);
}

}  // namespace
}  // namespace dsphere::test
