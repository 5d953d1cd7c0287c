#include "geo/largemap.h"

#include <gtest/gtest.h>

#include <bit>
#include <chrono>
#include <cmath>
#include <cstring>
#include <limits>
#include <random>
#include <thread>

#include "geo/readmap.h"
#include "tests/geo/twins.h"
#include "tests/image/tiffwriter.h"
#include "tests/support/expecterror.h"
#include "tests/support/tempfolder.h"

namespace dsphere::test {
namespace {

namespace fs = std::filesystem;
using geo::LargeMap;
using geo::SampleKind;

std::shared_ptr<const LargeMap> openAny(const fs::path& path, std::optional<int> band = {}) {
    return geo::openLargeMap(path, band, 1);
}

template <typename Sample>
std::vector<float> readAs(const LargeMap& map, int x, int y, int width, int height) {
    const auto count = std::size_t(width) * std::size_t(height);
    std::vector<Sample> samples(count + 1, Sample(77));
    map.read(x, y, width, height, samples.data());
    EXPECT_EQ(samples[count], Sample(77)) << "nothing is written beyond the window";
    std::vector<float> values(samples.begin(), samples.end() - 1);
    if (map.unknownCode())
        for (float& value : values)
            if (value == float(*map.unknownCode())) value = std::numeric_limits<float>::quiet_NaN();
    return values;
}

/// As readMap() gives them: NaN where unknown.
std::vector<float> windowOf(const LargeMap& map, int x, int y, int width, int height) {
    switch (map.kind()) {
        case SampleKind::UInt16:
            return readAs<std::uint16_t>(map, x, y, width, height);
        case SampleKind::Int16:
            return readAs<std::int16_t>(map, x, y, width, height);
        case SampleKind::Float32:
            break;
    }
    return readAs<float>(map, x, y, width, height);
}

bool same(float a, float b) {
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b) || (std::isnan(a) && std::isnan(b));
}

void expectWindow(const LargeMap& map, const RawMap& whole, int x, int y, int width, int height) {
    const std::vector<float> window = windowOf(map, x, y, width, height);
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) {
            const float is = window[std::size_t(j * width + i)];
            const float should = whole.samples[std::size_t((y + j) * whole.width + x + i)];
            ASSERT_TRUE(same(is, should)) << is << " instead of " << should << " at " << x + i << ", " << y + j
                                          << " in a window of " << width << "x" << height;
        }
}

void expectWindows(const LargeMap& map, const RawMap& whole, unsigned seed) {
    const int width = whole.width, height = whole.height;
    expectWindow(map, whole, 0, 0, width, height);
    expectWindow(map, whole, 0, 0, 1, 1);
    expectWindow(map, whole, width - 1, height - 1, 1, 1);
    std::minstd_rand random(seed);
    const auto below = [&](int count) { return std::uniform_int_distribution(0, count - 1)(random); };
    for (int k = 0; k < 40; ++k) {
        const int x = below(width), y = below(height);
        expectWindow(map, whole, x, y, 1, 1);
        expectWindow(map, whole, x, y, 1 + below(width - x), 1 + below(height - y));
        expectWindow(map, whole, 0, y, width, 1);
    }
}

void expectSameHead(const RawMap& head, const RawMap& whole) {
    EXPECT_TRUE(head.samples.empty());
    EXPECT_EQ(head.width, whole.width);
    EXPECT_EQ(head.height, whole.height);
    EXPECT_EQ(head.full_scale, whole.full_scale);
    EXPECT_EQ(head.gridline, whole.gridline);
    EXPECT_EQ(head.longitude_origin, whole.longitude_origin);
    EXPECT_EQ(head.type, whole.type);
    EXPECT_EQ(head.unknown_are_nan, whole.unknown_are_nan);
    EXPECT_EQ(head.facts.value_scale, whole.facts.value_scale);
    EXPECT_EQ(head.facts.value_offset, whole.facts.value_offset);
    EXPECT_EQ(head.facts.unit, whole.facts.unit);
    EXPECT_EQ(head.facts.radius, whole.facts.radius);
    EXPECT_EQ(head.facts.offset_is_radius, whole.facts.offset_is_radius);
    EXPECT_EQ(head.facts.projection, whole.facts.projection);
    EXPECT_EQ(head.facts.extent.has_value(), whole.facts.extent.has_value());
    EXPECT_EQ(head.facts.sources, whole.facts.sources);
}

/// The map in its file says and holds what readMap() reads of it, bit for bit.
std::shared_ptr<const LargeMap> expectSame(const fs::path& path, SampleKind kind, std::optional<int> unknown_code = {},
                                           std::optional<int> band = {}) {
    SCOPED_TRACE(path.filename());
    const RawMap whole = geo::readMap(path, band);
    const auto map = openAny(path, band);
    EXPECT_TRUE(map);
    if (!map) return map;
    EXPECT_EQ(map->kind(), kind);
    EXPECT_EQ(map->unknownCode(), unknown_code);
    expectSameHead(map->head(), whole);
    expectWindows(*map, whole, 1);
    return map;
}

fs::path casePath(const std::string& name) {
    return fs::path(DSPHERE_SOURCE_DIR "/tests/data/cases/maps") / name;
}

/// Values over the type's whole range.
template <typename Sample>
std::vector<Sample> noise(int width, int height) {
    std::minstd_rand random(3);
    std::vector<Sample> samples(std::size_t(width) * std::size_t(height));
    for (Sample& sample : samples) {
        const std::uint32_t bits = random();
        sample = std::is_floating_point_v<Sample> ? Sample(bits) / Sample(7) : Sample(bits >> 3);
    }
    return samples;
}

/// A VRT of a file's band that says where the file lies: west, dx, north, dy in degrees.
std::string vrtOf(const std::string& file, const char* type, int width, int height, std::array<double, 4> place,
                  const std::string& more = "") {
    return fmt::format(
        "<VRTDataset rasterXSize=\"{0}\" rasterYSize=\"{1}\"><GeoTransform>{2}, {3}, 0, {4}, 0, {5}</GeoTransform>"
        "<VRTRasterBand dataType=\"{6}\" band=\"1\">{7}<SimpleSource><SourceFilename relativeToVRT=\"1\">{8}"
        "</SourceFilename><SourceBand>1</SourceBand></SimpleSource></VRTRasterBand></VRTDataset>",
        width, height, place[0], place[1], place[2], place[3], type, more, file);
}

class LargeMaps : public testing::Test {
  protected:
    template <typename Sample>
    fs::path writeTiff(const std::string& name, const TiffForm& form, int width = 300, int height = 150) {
        return folder_.write(name, tiffFile<Sample>(form, width, height, noise<Sample>(width, height)));
    }

    TempFolder folder_;
};

TEST_F(LargeMaps, TaggedTiffs) {
    expectSame(casePath("nodata_int16.tif"), SampleKind::Int16, -32768);
    expectSame(casePath("sparse.tif"), SampleKind::Int16, 0);
    expectSame(casePath("lon_0_360.tif"), SampleKind::Int16);
    expectSame(casePath("south_up.tif"), SampleKind::Int16);
    expectSame(casePath("gridline_w_plus_1.tif"), SampleKind::Float32);
    expectSame(casePath("scale_offset.tif"), SampleKind::Int16);
    expectSame(casePath("nbits12.tif"), SampleKind::UInt16);
    expectSame(casePath("lat_60.tif"), SampleKind::Float32);  // no code of 16 bits is left for the rows beyond
    expectSame(casePath("masked.tif"), SampleKind::Float32);
}

TEST_F(LargeMaps, WhatAFloatDoesNotHoldIsRoundedAndSaid) {
    for (const char* name : {"int32.tif", "float64.tif"}) {
        const auto map = expectSame(casePath(name), SampleKind::Float32);
        EXPECT_TRUE(holds(map->head().notices.back().text, "more than the 24 bits of a float are rounded"));
    }
}

TEST_F(LargeMaps, PlainTiffs) {
    const TiffForm strips{.mode = "wb"};
    const TiffForm tiles{.mode = "wl",
                         .compression = COMPRESSION_ADOBE_DEFLATE,
                         .predictor = PREDICTOR_HORIZONTAL,
                         .tile_width = 64,
                         .tile_height = 32};
    expectSame(writeTiff<std::uint16_t>("u16.tif", strips), SampleKind::UInt16);
    expectSame(writeTiff<std::uint8_t>("u8.tif", strips), SampleKind::UInt16);
    expectSame(writeTiff<std::int8_t>("s8.tif", tiles), SampleKind::Int16);
    expectSame(writeTiff<std::int16_t>("s16.tif", tiles), SampleKind::Int16);
    expectSame(writeTiff<float>("f32.tif", strips), SampleKind::Float32);
    TiffForm big = tiles;
    big.mode = "w8";
    const auto map = expectSame(writeTiff<std::int16_t>("big.tif", big), SampleKind::Int16);
    EXPECT_FALSE(map->head().longitude_origin);
    EXPECT_TRUE(map->head().facts.sources.empty());
}

TEST_F(LargeMaps, PlacesOfEveryKind) {
    constexpr int kWidth = 90, kHeight = 45, kInner = 43;  // 4 degrees a texel; a map of 86 degrees north and south
    const TiffForm form{.tile_width = 32, .tile_height = 16};
    writeTiff<std::int16_t>("s16.tif", form, kWidth + 1, kHeight);
    writeTiff<std::uint8_t>("u8.tif", form, kWidth + 1, kHeight);
    const auto place = [&](const std::string& name, const char* type, int width, int height,
                           std::array<double, 4> where, const std::string& more = "") {
        const std::string source = std::string(type) == "Byte" ? "u8.tif" : "s16.tif";
        return folder_.write(name, vrtOf(source, type, width, height, where, more));
    };
    const std::string nodata = "<NoDataValue>100</NoDataValue>";
    expectSame(place("west.vrt", "Int16", kWidth, kHeight, {360, -4, 90, -4}), SampleKind::Int16);
    expectSame(place("turned.vrt", "Int16", kWidth, kHeight, {180, -4, -90, 4}), SampleKind::Int16);
    expectSame(place("repeated.vrt", "Int16", kWidth + 1, kHeight, {-180, 4, 90, -4}), SampleKind::Int16);
    expectSame(place("repeated_west.vrt", "Int16", kWidth + 1, kHeight, {180, -4, 90, -4}), SampleKind::Int16);
    expectSame(place("inner.vrt", "Int16", kWidth, kInner, {0, 4, 86, -4}), SampleKind::Float32);
    expectSame(place("inner_nodata.vrt", "Int16", kWidth, kInner, {0, 4, 86, -4}, nodata), SampleKind::Int16, 100);
    expectSame(place("inner_turned.vrt", "Int16", kWidth, 30, {180, -4, -50, 4}, nodata), SampleKind::Int16, 100);
    expectSame(place("inner_byte.vrt", "Byte", kWidth, kInner, {0, 4, 86, -4}), SampleKind::UInt16, 65535);
}

TEST_F(LargeMaps, ANodataThatNoSampleHasMarksNothing) {
    writeTiff<std::int16_t>("s16.tif", {}, 90, 45);
    for (const char* nodata : {"-99999", "0.5", "1e300", "nan"}) {
        const std::string tag = fmt::format("<NoDataValue>{}</NoDataValue>", nodata);
        expectSame(folder_.write("m.vrt", vrtOf("s16.tif", "Int16", 90, 45, {0, 4, 90, -4}, tag)), SampleKind::Int16);
    }
    std::vector<float> floats(90 * 45, 5.0f);
    floats[7] = -3.4028226550889045e+38f;
    floats[9] = std::numeric_limits<float>::infinity();
    folder_.write("f32.tif", tiffFile<float>({}, 90, 45, floats));
    const std::string tag = "<NoDataValue>-3.4028226550889045e+38</NoDataValue>";
    const auto map = expectSame(folder_.write("f.vrt", vrtOf("f32.tif", "Float32", 90, 45, {0, 4, 90, -4}, tag)),
                                SampleKind::Float32);
    EXPECT_TRUE(std::isnan(windowOf(*map, 7, 0, 1, 1)[0]));
    EXPECT_TRUE(std::isinf(windowOf(*map, 9, 0, 1, 1)[0]));
}

TEST_F(LargeMaps, LabelsOfTheArchives) {
    const std::vector<std::int16_t> heights = twinHeights();
    const std::string unit = "UNIT = METER\r\nSCALING_FACTOR = 0.5\r\nOFFSET = 1737400.\r\n";
    folder_.write("LDEM.IMG", bytesOf(heights, false));
    const auto lola =
        expectSame(folder_.write("LDEM.LBL", pds3Label({.image = "LDEM.IMG", .more = unit})), SampleKind::Int16);
    EXPECT_TRUE(lola->head().facts.offset_is_radius);
    EXPECT_EQ(lola->head().facts.radius, 1737400.0);
    folder_.write("MEGR.IMG", bytesOf(heights, true));
    const auto mola =
        expectSame(folder_.write("MEGR.LBL", pds3Label({.image = "MEGR.IMG",
                                                        .sample_type = "MSB_INTEGER",
                                                        .more = "UNIT = METER\r\nOFFSET = 3396000.\r\n"
                                                                "SCALING_FACTOR = 1\r\nMISSING_CONSTANT = 13\r\n",
                                                        .radius_km = 3396.0,
                                                        .half = 0.5})),
                   SampleKind::Int16, 13);
    EXPECT_EQ(mola->head().facts.radius, 3396000.0);
    expectSame(folder_.write("dem.cub", isisCube(bytesOf(heights, false))), SampleKind::Int16, -32768);
    expectSame(folder_.write("dem.nc", netCdf(bytesOf(fromTheSouth(heights), true))), SampleKind::Int16, -32767);
    folder_.write("dem.img", bytesOf(heights, false));
    expectSame(folder_.write("dem.hdr", enviHeader()), SampleKind::Int16);
    const auto fits_map =
        expectSame(folder_.write("dem.fits", fits(bytesOf(fromTheSouth(heights), true))), SampleKind::Int16);
    EXPECT_TRUE(holds(fits_map->head().notices.back().text, "does not say where it lies"));
}

TEST_F(LargeMaps, SpecialFloatsOfArchivesAreUnknown) {
    std::string bytes;
    for (int k = 0; k < kTwinWidth * kTwinHeight; ++k) {
        const float height = k == 70 ? std::bit_cast<float>(0xff7ffffbu) : float(k);  // PDS's value for "null"
        bytes.append(reinterpret_cast<const char*>(&height), 4);
    }
    folder_.write("F.IMG", bytes);
    const std::string more = "UNIT = KILOMETER\r\nSCALING_FACTOR = 1\r\nOFFSET = 1737.4\r\n";
    const auto map = expectSame(
        folder_.write("F.LBL", pds3Label({.image = "F.IMG", .sample_type = "PC_REAL", .more = more, .bits = 32})),
        SampleKind::Float32);
    EXPECT_TRUE(std::isnan(windowOf(*map, 6, 1, 1, 1)[0]));
    EXPECT_TRUE(map->head().facts.offset_is_radius) << "it is about the datum's";
}

TEST_F(LargeMaps, ABandIsChosenByItsNumber) {
    TiffForm form{.samples = 3, .photometric = PHOTOMETRIC_RGB};
    std::vector<std::uint8_t> samples = noise<std::uint8_t>(3 * 40, 20);
    const fs::path path = folder_.write("rgb.tif", tiffFile<std::uint8_t>(form, 40, 20, samples));
    expectSame(path, SampleKind::UInt16, {}, 2);
    EXPECT_NE(openAny(path, 2)->identity(), openAny(path, 3)->identity());
    EXPECT_TRUE(holds(messageOf(ExitCode::InvalidInput, [&] { openAny(path, 4); }), "band 4 is asked for"));
    EXPECT_FALSE(openAny(path)) << "the mean of red, green and blue is no stored value";
}

TEST_F(LargeMaps, OthersAreLeftToReadMap) {
    EXPECT_FALSE(openAny(folder_.write("grey.pgm", "P5 2 1 255\nab")));
    EXPECT_FALSE(openAny(folder_.write("dem.asc", asciiGrid(twinHeights()))));
    EXPECT_FALSE(openAny(casePath("trns_16.png")));
    std::vector<std::uint16_t> greys(256);
    for (std::size_t k = 0; k < greys.size(); ++k) greys[k] = std::uint16_t(257 * (255 - k));
    EXPECT_FALSE(openAny(writeTiff<std::uint8_t>("palette.tif", {.photometric = PHOTOMETRIC_PALETTE, .grey = greys})));
    EXPECT_FALSE(openAny(writeTiff<std::uint8_t>("turned.tif", {.orientation = ORIENTATION_BOTLEFT})));
    EXPECT_FALSE(geo::openLargeMap(casePath("lat_60.tif"), {}, 128 * 64 + 1));
    EXPECT_TRUE(geo::openLargeMap(casePath("lat_60.tif"), {}, 128 * 64)) << "rows that are not in the file count";
    const fs::path plain = writeTiff<std::int16_t>("plain.tif", {});
    EXPECT_FALSE(geo::openLargeMap(plain, {}, 300 * 150 + 1));
    EXPECT_TRUE(geo::openLargeMap(plain, {}, 300 * 150));
}

TEST_F(LargeMaps, FourThreadsAtOnce) {
    const TiffForm tiles{.compression = COMPRESSION_ADOBE_DEFLATE, .tile_width = 128, .tile_height = 128};
    const std::vector<std::int16_t> heights = twinHeights();
    for (const fs::path& path : {writeTiff<std::int16_t>("tiles.tif", tiles, 1000, 500),
                                 folder_.write("dem.nc", netCdf(bytesOf(fromTheSouth(heights), true)))}) {
        const RawMap whole = geo::readMap(path);
        const auto map = openAny(path);
        std::vector<std::thread> threads;
        for (unsigned k = 0; k < 4; ++k) threads.emplace_back([&, k] { expectWindows(*map, whole, k + 1); });
        for (std::thread& thread : threads) thread.join();
    }
}

TEST_F(LargeMaps, TruncatedFilesAreRefused) {
    const std::string bytes = readBytes(writeTiff<std::int16_t>("whole.tif", {.tile_width = 64, .tile_height = 64}));
    // libtiff writes the directory last: its table of tiles now points beyond the end.
    std::string cut = bytes;
    const std::uint32_t beyond = std::uint32_t(bytes.size()) - 5;
    const auto tag = cut.find(std::string("\x44\x01\x04\x00", 4));  // TileOffsets, of type LONG
    ASSERT_NE(tag, std::string::npos);
    std::uint32_t table;
    std::memcpy(&table, &cut[tag + 8], 4);
    std::memcpy(&cut[table + 4 * 3], &beyond, 4);
    const fs::path path = folder_.write("cut.tif", cut);
    EXPECT_TRUE(holds(messageOf(ExitCode::InvalidInput, [&] { openAny(path); }),
                      fmt::format("cut.tif: TIFF: truncated or damaged: tile 3 has 8192 bytes at byte {}", beyond)));

    const std::string cube = isisCube(bytesOf(twinHeights(), false));
    for (const std::size_t length : {cube.size() - 1, cube.size() / 2}) {
        const fs::path shorter = folder_.write("cut.cub", cube.substr(0, length));
        EXPECT_TRUE(holds(messageOf(ExitCode::InvalidInput, [&] { openAny(shorter); }), "cut.cub: ISIS cube: "));
    }
}

TEST_F(LargeMaps, ADamagedBlockIsAnErrorThatSaysWhere) {
    const fs::path path = writeTiff<std::int16_t>(
        "map.tif", {.compression = COMPRESSION_ADOBE_DEFLATE, .tile_width = 64, .tile_height = 64});
    std::string bytes = readBytes(path);
    std::fill_n(bytes.begin() + 200, 300, '\x55');  // in the first tile
    folder_.write("map.tif", bytes);
    const auto map = openAny(path);
    std::vector<std::int16_t> samples(300 * 150);
    EXPECT_NO_THROW(map->read(64, 64, 64, 64, samples.data()));
    for (const auto& [width, height] : {std::pair{64, 64}, std::pair{300, 150}})
        EXPECT_TRUE(holds(messageOf(ExitCode::InvalidInput, [&] { map->read(0, 0, width, height, samples.data()); }),
                          "map.tif: TIFF: rows 0 to 63 of columns 0 to 63 cannot be read: ZIPDecode"))
            << "also where several blocks are decoded at once";
    EXPECT_NO_THROW(map->read(64, 64, 64, 64, samples.data())) << "the handle is free again";
}

TEST_F(LargeMaps, AbsurdSizesAreRefused) {
    for (const auto& [width, height] : {std::pair{262144, 131072}, std::pair{131073, 2}, std::pair{131072, 65537}}) {
        const fs::path path = folder_.write(
            "m.vrt", vrtOf("none.tif", "Byte", width, height, {-180, 360.0 / width, 90, -180.0 / height}));
        EXPECT_TRUE(holds(messageOf(ExitCode::InvalidInput, [&] { openAny(path); }),
                          fmt::format("the size is {}x{}, expected sides of at most 131072 and at most 8589934592 "
                                      "texels",
                                      width, height)));
    }
}

TEST_F(LargeMaps, IdentityIsThatOfAllItsFiles) {
    const std::string unit = "UNIT = METER\r\n";
    std::string samples = bytesOf(twinHeights(), false);
    folder_.write("A.IMG", samples);
    const fs::path label = folder_.write("A.LBL", pds3Label({.image = "A.IMG", .more = unit}));
    const auto map = openAny(label);
    const std::string first = map->identity();
    EXPECT_EQ(map->identity(), first);
    EXPECT_EQ(openAny(label)->identity(), first);

    const auto time = fs::last_write_time(folder_.path() / "A.IMG");
    samples[1000] ^= 1;
    folder_.write("A.IMG", samples);
    fs::last_write_time(folder_.path() / "A.IMG", time);
    const std::string other_bytes = map->identity();
    EXPECT_NE(other_bytes, first);
    fs::last_write_time(folder_.path() / "A.IMG", time + std::chrono::nanoseconds(100));
    const std::string other_time = map->identity();
    EXPECT_NE(other_time, other_bytes);
    fs::last_write_time(folder_.path() / "A.IMG", time);
    EXPECT_EQ(map->identity(), other_bytes);
    folder_.write("A.LBL", pds3Label({.image = "A.IMG", .more = "UNIT = KILOMETER\r\n"}));
    EXPECT_NE(map->identity(), other_bytes);

    const fs::path tiff = writeTiff<std::int16_t>("map.tif", {}, 36, 18);
    const std::string plain = openAny(tiff)->identity();
    folder_.write("map.tfw", "10\n0\n0\n-10\n5\n85\n");
    const std::string placed = openAny(tiff)->identity();
    EXPECT_NE(placed, plain);
    folder_.write("map.tfw", "10\n0\n0\n-10\n-175\n85\n");
    EXPECT_NE(openAny(tiff)->identity(), placed);
}

}  // namespace
}  // namespace dsphere::test
