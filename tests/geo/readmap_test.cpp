// TIFFs whose tags say where they lie, what their values mean or which are unknown.

#include "geo/readmap.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/image/tiffwriter.h"
#include "tests/support/expecterror.h"
#include "tests/support/tempfolder.h"

namespace dsphere::test {
namespace {

RawMap readCase(const std::string& name) {
    return geo::readMap(DSPHERE_SOURCE_DIR "/tests/data/cases/maps/" + name);
}

std::string refusedCase(const std::string& name) {
    return messageOf(ExitCode::InvalidInput, [&] { readCase(name); });
}

struct Place {
    float value;
    double latitude, longitude;
};

Place placeOf(const RawMap& map, std::size_t index) {
    const double i = double(index % std::size_t(map.width)), j = double(index / std::size_t(map.width));
    const double half = map.gridline ? 0.0 : 0.5;
    const double longitude = map.longitude_origin.value_or(-180.0) + (i + half) * 360.0 / map.width;
    return {map.samples[index], 90.0 - (j + half) * 180.0 / (map.gridline ? map.height - 1 : map.height),
            longitude - 360.0 * std::floor((longitude + 180.0) / 360.0)};
}

std::size_t unknownTexels(const RawMap& map) {
    return std::size_t(std::ranges::count_if(map.samples, [](float s) { return std::isnan(s); }));
}

/// Olympus Mons and Hellas stand where they do on Mars, to within a texel.
void expectMars(const RawMap& map, double tolerance) {
    const auto known = [](float a, float b) { return !std::isnan(b) && (std::isnan(a) || a < b); };
    const auto top = std::max_element(map.samples.begin(), map.samples.end(), known);
    const Place peak = placeOf(map, std::size_t(top - map.samples.begin()));
    EXPECT_NEAR(peak.latitude, 18.28, tolerance);
    EXPECT_NEAR(peak.longitude, -133.59, tolerance);
    const auto below = [](float a, float b) { return !std::isnan(a) && (std::isnan(b) || a < b); };
    const auto bottom = std::min_element(map.samples.begin(), map.samples.end(), below);
    const Place pit = placeOf(map, std::size_t(bottom - map.samples.begin()));
    EXPECT_NEAR(pit.latitude, -42.0, tolerance);
    EXPECT_NEAR(pit.longitude, 70.0, tolerance);
}

TEST(PlacedTiff, LiesWhereItsTagsSay) {
    for (const char* name : {"lon_0_360.tif", "south_up.tif", "lat_60.tif", "nodata_int16.tif", "int32.tif"}) {
        SCOPED_TRACE(name);
        const RawMap map = readCase(name);
        EXPECT_EQ(map.width, 128);
        EXPECT_EQ(map.height, 64);
        expectMars(map, 2.9);
        EXPECT_EQ(*std::ranges::max_element(map.samples, {}, [](float s) { return std::isnan(s) ? -1e9f : s; }),
                  20472.0f);
        EXPECT_EQ(map.facts.radius, 3396190.0);
        EXPECT_EQ(map.facts.sources.at("longitude_origin"), "tag");
    }
    EXPECT_EQ(readCase("lon_0_360.tif").longitude_origin, 0.0);
    EXPECT_EQ(readCase("south_up.tif").samples, readCase("int32.tif").samples);
}

TEST(PlacedTiff, OtherSamples) {
    expectMars(readCase("float64.tif"), 8.0);
    EXPECT_EQ(readCase("float64.tif").type, "float64 TIFF");
    const RawMap bits = readCase("nbits12.tif");
    expectMars(bits, 2.9);
    EXPECT_EQ(bits.full_scale, 4095.0);
    EXPECT_EQ(readCase("int32.tif").full_scale, 2147483647.0);
}

TEST(PlacedTiff, UnknownTexels) {
    const RawMap nodata = readCase("nodata_int16.tif");
    EXPECT_TRUE(nodata.unknown_are_nan);
    EXPECT_EQ(unknownTexels(nodata), 462u);
    const RawMap band = readCase("lat_60.tif");
    EXPECT_TRUE(band.unknown_are_nan);
    EXPECT_EQ(unknownTexels(band), 22u * 128u);
    EXPECT_TRUE(std::isnan(band.samples[10 * 128]) && !std::isnan(band.samples[11 * 128]));
    ASSERT_EQ(band.notices.size(), 1u);
    EXPECT_TRUE(holds(band.notices[0].text, "the 22 rows beyond are unknown"));
    const RawMap sparse = readCase("sparse.tif");
    EXPECT_EQ(unknownTexels(sparse) % (32 * 32), 0u) << "whole tiles";
    EXPECT_GT(unknownTexels(sparse), 0u);
}

TEST(PlacedTiff, NodesWithARepeatedColumn) {
    const RawMap map = readCase("gridline_w_plus_1.tif");
    EXPECT_TRUE(map.gridline);
    EXPECT_EQ(map.width, 64);
    EXPECT_EQ(map.height, 33);
    EXPECT_EQ(placeOf(map, 16 * 64 + 48).longitude, 90.0);
    EXPECT_EQ(placeOf(map, 16 * 64 + 48).latitude, 0.0);
}

TEST(PlacedTiff, ScaleAndOffset) {
    const RawMap map = readCase("scale_offset.tif");
    EXPECT_EQ(map.facts.value_scale, 0.5);
    EXPECT_EQ(map.facts.value_offset, 1737400.0);
    EXPECT_EQ(map.facts.radius, 1737400.0);
    EXPECT_EQ(map.facts.unit, "m");
    EXPECT_EQ(map.facts.heightOf(-6127.0), -3063.5);
}

TEST(PlacedTiff, RefusesWhatIsNoWholeSphereAndNamesImport) {
    EXPECT_TRUE(holds(refusedCase("regional.tif"), "covers longitudes -154 to -114, latitudes -2 to 38"));
    EXPECT_TRUE(holds(refusedCase("regional.tif"), "dsphere import"));
    EXPECT_TRUE(holds(refusedCase("web_mercator.tif"), "Pseudo-Mercator"));
    EXPECT_TRUE(holds(refusedCase("web_mercator.tif"), "dsphere import"));
}

TEST(PlacedTiff, AnAsciiGrid) {
    const RawMap map = readCase("grid.asc");
    expectMars(map, 12.0);
    EXPECT_EQ(map.facts.sources.at("extent"), "label");
}

TEST(PlainTiff, IsReadAsItEverWas) {
    const TempFolder folder;
    const std::vector<std::int16_t> samples{-5, 7, 0, 32767, -32768, 2};
    const auto path = folder.write("map.tif", tiffFile<std::int16_t>({}, 3, 2, samples));
    const RawMap map = geo::readMap(path);
    EXPECT_EQ(map.type, "signed 16-bit TIFF");
    EXPECT_FALSE(map.longitude_origin);
    EXPECT_TRUE(map.facts.sources.empty());
    EXPECT_TRUE(std::equal(samples.begin(), samples.end(), map.samples.begin(), map.samples.end()));
    folder.write("map.tfw", "120\n0\n0\n-90\n60\n45\n");
    EXPECT_EQ(geo::readMap(path).longitude_origin, 0.0) << "a world file beside it places it";
}

TEST(PlainMap, AWorldFileBesideItIsWarnedOf) {
    const TempFolder folder;
    const auto path = folder.write("map.pgm", "P5 2 1 255\nab");
    EXPECT_TRUE(geo::readMap(path).notices.empty());
    folder.write("map.pmw", "180\n0\n0\n-180\n90\n0\n");
    const RawMap map = geo::readMap(path);
    ASSERT_EQ(map.notices.size(), 1u);
    EXPECT_TRUE(holds(map.notices[0].text, "map.pmw beside it says where it lies"));
}

TEST(PlainTiff, ManyBits) {
    const TempFolder folder;
    const std::vector<double> samples{0.1, 7.0, 0.5, 1.0};
    const RawMap map = geo::readMap(folder.write("map.tif", tiffFile<double>({}, 2, 2, samples)));
    EXPECT_EQ(map.samples, (std::vector<float>{0.1f, 7.0f, 0.5f, 1.0f}));
    ASSERT_EQ(map.notices.size(), 1u);
    EXPECT_TRUE(holds(map.notices[0].text, "1 of its values"));
    EXPECT_FALSE(map.longitude_origin);
}

TEST(Bands, AreChosenByNumber) {
    const TempFolder folder;
    TiffForm form;
    form.samples = 3;
    form.photometric = PHOTOMETRIC_RGB;
    const auto path = folder.write("rgb.tif", tiffFile<std::uint8_t>(form, 2, 1, {1, 2, 3, 40, 50, 60}));
    EXPECT_EQ(geo::readMap(path, 2).samples, (std::vector<float>{2.0f, 50.0f}));
    EXPECT_TRUE(
        holds(messageOf(ExitCode::InvalidInput, [&] { geo::readMap(path, 4); }), "band 4 is asked for, but it has 3"));
    const auto grey = folder.write("map.pgm", "P5 2 1 255\nab");
    EXPECT_EQ(geo::readMap(grey, 1).samples.size(), 2u);
    EXPECT_TRUE(holds(messageOf(ExitCode::InvalidInput, [&] { geo::readMap(grey, 2); }), "band 2"));
}

TEST(PlainTiff, AMaskOnAnotherPage) {
    const RawMap map = readCase("masked.tif");
    EXPECT_EQ(map.samples[0], 0.0f);
    EXPECT_EQ(map.samples[127], 127.0f);
    EXPECT_EQ(unknownTexels(map), 3u);
    EXPECT_TRUE(map.unknown_are_nan && std::isnan(map.samples[2 * 16 + 3]));
}

TEST(Bands, AlphaIsAMask) {
    const TempFolder folder;
    TiffForm form;
    form.samples = 2;
    const auto path = folder.write("alpha.tif", tiffFile<std::uint16_t>(form, 2, 1, {500, 65535, 600, 0}));
    const RawMap map = geo::readMap(path, 1);
    EXPECT_EQ(map.samples[0], 500.0f);
    EXPECT_TRUE(std::isnan(map.samples[1]) && map.unknown_are_nan);
}

}  // namespace
}  // namespace dsphere::test
