#include "geo/import.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "geo/readmap.h"
#include "tests/geo/twins.h"
#include "tests/support/expecterror.h"
#include "tests/support/tempfolder.h"

namespace dsphere::test {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0, kRadius = 3396000.0;
constexpr int kWidth = 720, kHeight = 360;  // of the whole planet: 2 texels a degree

std::int16_t tileHeight(int column, int row) {
    return std::int16_t(8000.0 * std::sin(0.05 * column) * std::cos(0.03 * row) + (column * 7 + row * 13) % 101);
}

/// MOLA's 16 tiles: 90 by 44 degrees each, 88 N to 88 S, longitudes from 0.
std::vector<std::filesystem::path> writeTiles(const TempFolder& folder) {
    std::vector<std::filesystem::path> labels;
    constexpr int kTileWidth = kWidth / 4, kTileHeight = 88;
    for (int k = 0; k < 16; ++k) {
        const int left = k % 4 * kTileWidth, top = 4 + k / 4 * kTileHeight;  // 4 rows are north of 88 degrees
        std::vector<std::int16_t> heights;
        for (int j = 0; j < kTileHeight; ++j)
            for (int i = 0; i < kTileWidth; ++i) heights.push_back(tileHeight(left + i, top + j));
        const std::string name = fmt::format("tile{}", k);
        folder.write(name + ".img", bytesOf(heights, true));
        labels.push_back(folder.write(name + ".lbl", pds3Label({.image = name + ".img",
                                                                .sample_type = "MSB_INTEGER",
                                                                .more = "UNIT = METER\r\nOFFSET = 3396000.\r\n"
                                                                        "SCALING_FACTOR = 1\r\n",
                                                                .width = kTileWidth,
                                                                .height = kTileHeight,
                                                                .radius_km = 3396.0,
                                                                .resolution = 2.0,
                                                                .west = left / 2.0,
                                                                .east = left / 2.0 + 90.0,
                                                                .north = 90.0 - top / 2.0,
                                                                .south = 90.0 - top / 2.0 - 44.0,
                                                                .half = 0.5})));
    }
    return labels;
}

constexpr int kCapSide = 60;
constexpr double kCapStep = 40000.0, kCapEdge = kCapSide / 2 * kCapStep;  // metres on the plane

std::int16_t capHeight(int column, int row) {
    return std::int16_t(-3000.0 + 40.0 * column - 25.0 * row + 500.0 * std::sin(0.2 * column * row / 20.0));
}

/// A polar stereographic cap about the north pole.
std::filesystem::path writeCap(const TempFolder& folder) {
    std::vector<std::int16_t> heights;
    for (int j = 0; j < kCapSide; ++j)
        for (int i = 0; i < kCapSide; ++i) heights.push_back(capHeight(i, j));
    folder.write("cap.raw", bytesOf(heights, false));
    return folder.write(
        "cap.vrt",
        fmt::format(
            "<VRTDataset rasterXSize=\"{0}\" rasterYSize=\"{0}\"><SRS>+proj=stere +lat_0=90 +lon_0=0 +k=1 "
            "+R={1} +units=m +no_defs</SRS><GeoTransform>{2}, {3}, 0, {4}, 0, {5}</GeoTransform>"
            "<VRTRasterBand dataType=\"Int16\" band=\"1\" subClass=\"VRTRawRasterBand\"><UnitType>m</UnitType>"
            "<Offset>3396000</Offset><Scale>1</Scale><SourceFilename relativeToVRT=\"1\">cap.raw</SourceFilename>"
            "<ByteOrder>LSB</ByteOrder></VRTRasterBand></VRTDataset>",
            kCapSide, kRadius, -kCapEdge, kCapStep, kCapEdge, -kCapStep));
}

/// Between the cap's four texels about a place; NaN where it has not four.
double capAt(double latitude, double longitude) {
    const double rho = 2.0 * kRadius * std::tan((90.0 - latitude) * kDegree / 2.0);
    const double x = (rho * std::sin(longitude * kDegree) + kCapEdge) / kCapStep - 0.5;
    const double y = (kCapEdge + rho * std::cos(longitude * kDegree)) / kCapStep - 0.5;
    const int i = int(std::floor(x)), j = int(std::floor(y));
    if (i < 0 || j < 0 || i + 1 >= kCapSide || j + 1 >= kCapSide) return std::nan("");
    const double u = x - i, v = y - j;
    return (1 - u) * (1 - v) * capHeight(i, j) + u * (1 - v) * capHeight(i + 1, j) + (1 - u) * v * capHeight(i, j + 1) +
           u * v * capHeight(i + 1, j + 1);
}

bool nearCap(double latitude, double longitude) {
    const double rho = 2.0 * kRadius * std::tan((90.0 - latitude) * kDegree / 2.0);
    return std::abs(rho * std::sin(longitude * kDegree)) < kCapEdge + kCapStep &&
           std::abs(rho * std::cos(longitude * kDegree)) < kCapEdge + kCapStep;
}

TEST(Import, TilesAndAPolarCapOverThem) {
    const TempFolder folder;
    geo::ImportOptions options{.inputs = writeTiles(folder), .output = folder.path() / "mars.tif"};
    options.inputs.push_back(writeCap(folder));
    const geo::ImportResult result = geo::importMaps(options);
    EXPECT_EQ(result.width, kWidth);
    EXPECT_EQ(result.height, kHeight);
    EXPECT_EQ(result.type, "Int16");
    const RawMap map = geo::readMap(options.output);
    EXPECT_EQ(map.longitude_origin, -180.0);
    EXPECT_EQ(map.facts.radius, kRadius);
    EXPECT_EQ(map.facts.value_offset, kRadius);
    EXPECT_EQ(map.facts.sources.at("unit"), "tag");
    EXPECT_EQ(std::ranges::count_if(map.samples, [](float s) { return std::isnan(s); }), 4 * kWidth)
        << "the south pole";
    std::mt19937 random(1);
    int of_cap = 0, of_tiles = 0;
    while (of_cap + of_tiles < 1000) {
        // Half of them in the north, for the cap's sake.
        const int row = int(random() % (random() % 2 ? kHeight - 4 : 50)), column = int(random() % kWidth);
        const double latitude = 90.0 - (row + 0.5) / 2.0, longitude = -180.0 + (column + 0.5) / 2.0;
        const float read = map.samples[std::size_t(row * kWidth + column)];
        const double cap = capAt(latitude, longitude);
        if (!std::isnan(cap)) {
            ++of_cap;
            EXPECT_NEAR(read, cap, 0.5 + 1e-6) << latitude << " N " << longitude << " E";
        } else if (!nearCap(latitude, longitude)) {
            ++of_tiles;
            EXPECT_EQ(read, float(tileHeight((column + kWidth / 2) % kWidth, row))) << latitude << " N " << longitude;
        }
    }
    EXPECT_GT(of_cap, 200);
    EXPECT_GT(of_tiles, 300);
}

TEST(Import, UnlikeUnitsBecomeMetres) {
    const TempFolder folder;
    geo::ImportOptions options{.inputs = {writeTiles(folder)[0]}, .output = folder.path() / "mars.tif"};
    std::string bytes;
    for (int k = 0; k < 180 * 88; ++k) {
        const float km = 1.5f + 0.001f * float(k % 180);
        bytes.append(reinterpret_cast<const char*>(&km), 4);
    }
    folder.write("km.img", bytes);
    options.inputs.push_back(
        folder.write("km.lbl", pds3Label({.image = "km.img",
                                          .sample_type = "PC_REAL",
                                          .more = "UNIT = KILOMETER\r\nOFFSET = 3396.\r\nSCALING_FACTOR = 1\r\n",
                                          .bits = 32,
                                          .width = 180,
                                          .height = 88,
                                          .radius_km = 3396.0,
                                          .resolution = 2.0,
                                          .west = 90.0,
                                          .east = 180.0,
                                          .north = 88.0,
                                          .south = 44.0,
                                          .half = 0.5})));
    EXPECT_EQ(geo::importMaps(options).type, "Float32");
    const RawMap map = geo::readMap(options.output);
    EXPECT_EQ(map.samples[4 * kWidth + 360], float(tileHeight(0, 4)));
    EXPECT_NEAR(map.samples[4 * kWidth + 360 + 180 + 7], 1507.0f, 0.01f);
    EXPECT_EQ(map.facts.unit, "m");
}

TEST(Import, RegionsAndWebMercator) {
    const std::string cases = DSPHERE_SOURCE_DIR "/tests/data/cases/maps/";
    const TempFolder folder;
    const auto output = folder.path() / "out.tif";
    for (const char* name : {"regional.tif", "web_mercator.tif"}) {
        geo::importMaps({.inputs = {cases + name}, .output = output});
        const RawMap map = geo::readMap(output);
        const auto top = std::ranges::max_element(map.samples, {}, [](float s) { return std::isnan(s) ? -1e9f : s; });
        const auto index = double(top - map.samples.begin());
        const double row = std::floor(index / map.width), column = index - row * map.width;
        EXPECT_NEAR(90.0 - (row + 0.5) * 180.0 / map.height, 18.28, 3.0) << name;
        EXPECT_NEAR(-180.0 + (column + 0.5) * 360.0 / map.width, -133.59, 3.0) << name;
    }
}

TEST(Import, NothingIsWrittenWhenStopped) {
    const TempFolder folder;
    const geo::ImportOptions options{.inputs = {writeCap(folder)},
                                     .output = folder.path() / "out.tif",
                                     .resolution = std::pair{720, 360},
                                     .progress = [](double) { return false; }};
    const std::size_t before = folder.entries();
    expectError(ExitCode::Interrupted, "interrupted", [&] { geo::importMaps(options); });
    EXPECT_EQ(folder.entries(), before);
}

TEST(Import, RefusesWhatItShould) {
    const TempFolder folder;
    const auto cap = writeCap(folder);
    const auto import = [&](const std::filesystem::path& input, const std::filesystem::path& output) {
        geo::importMaps({.inputs = {input}, .output = output});
    };
    const auto plain = folder.write("plain.tif", "II*");
    expectError(ExitCode::Usage, "one of the inputs", [&] { import(plain, plain); });
    expectError(ExitCode::Usage, "ends in .tif", [&] { import(cap, folder.path() / "out.png"); });
    expectError(ExitCode::InvalidInput, "plain.tif", [&] { import(plain, folder.path() / "out.tif"); });
    expectError(ExitCode::InvalidInput, "missing.tif",
                [&] { import(folder.path() / "missing.tif", folder.path() / "out.tif"); });
    expectError(ExitCode::Failure, "no-folder", [&] { import(cap, folder.path() / "no-folder" / "out.tif"); });
}

}  // namespace
}  // namespace dsphere::test
