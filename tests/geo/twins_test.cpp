// The same heights in every format that they are published in, read bit for bit.

#include <gtest/gtest.h>

#include "geo/readmap.h"
#include "tests/geo/twins.h"
#include "tests/support/expecterror.h"
#include "tests/support/tempfolder.h"

namespace dsphere::test {
namespace {

void expectTwin(const RawMap& map, const std::string& type) {
    EXPECT_EQ(map.width, kTwinWidth);
    EXPECT_EQ(map.height, kTwinHeight);
    EXPECT_EQ(map.type, type);
    EXPECT_FALSE(map.gridline);
    EXPECT_EQ(map.longitude_origin.value_or(0.0), 0.0);
    const std::vector<std::int16_t> heights = twinHeights();
    EXPECT_TRUE(std::equal(map.samples.begin(), map.samples.end(), heights.begin(), heights.end()));
}

class Twins : public testing::Test {
  protected:
    RawMap read(const std::string& name) const { return geo::readMap(folder_.path() / name); }

    TempFolder folder_;
    std::vector<std::int16_t> heights_ = twinHeights();
};

TEST_F(Twins, LolaWithADetachedLabel) {
    const std::string unit = "UNIT = METER\r\nSCALING_FACTOR = 0.5\r\nOFFSET = 1737400.\r\n";
    folder_.write("LDEM.LBL", pds3Label({.image = "LDEM.IMG", .more = unit}));
    folder_.write("LDEM.IMG", bytesOf(heights_, false));
    for (const char* name : {"LDEM.LBL", "LDEM.IMG"}) {
        const RawMap map = read(name);
        expectTwin(map, "signed 16-bit PDS3");
        EXPECT_EQ(map.longitude_origin, 0.0);
        EXPECT_EQ(map.full_scale, 32767.0);
        EXPECT_FALSE(map.unknown_are_nan) << "the label has no value for it, whatever GDAL says";
        EXPECT_EQ(map.facts.value_scale, 0.5);
        EXPECT_EQ(map.facts.value_offset, 1737400.0);
        EXPECT_EQ(map.facts.unit, "m");
        EXPECT_EQ(map.facts.radius, 1737400.0);
        EXPECT_TRUE(map.facts.offset_is_radius);
        EXPECT_EQ(map.facts.heightOf(8.0), 4.0);
        EXPECT_EQ(map.facts.sources.at("unit"), "label");
        EXPECT_TRUE(map.notices.empty());
    }
}

TEST_F(Twins, TheLeastSixteenBitsAreAHeightUnlessTheLabelSaysOtherwise) {
    heights_[5] = -32768;
    folder_.write("A.IMG", bytesOf(heights_, true));
    folder_.write("A.LBL", pds3Label({.image = "A.IMG", .sample_type = "MSB_INTEGER"}));
    EXPECT_EQ(read("A.LBL").samples[5], -32768.0f);
    folder_.write("A.LBL",
                  pds3Label({.image = "A.IMG", .sample_type = "MSB_INTEGER", .more = "MISSING_CONSTANT = -32768\r\n"}));
    const RawMap map = read("A.LBL");
    EXPECT_TRUE(std::isnan(map.samples[5]));
    EXPECT_TRUE(map.unknown_are_nan);
}

TEST_F(Twins, MolaCountsItsOffsetsFromTheFirstTexelsCorner) {
    folder_.write("MEGR.IMG", bytesOf(heights_, true));
    folder_.write("MEGR.LBL", pds3Label({.image = "MEGR.IMG",
                                         .sample_type = "MSB_INTEGER",
                                         .more = "UNIT = METER\r\nOFFSET = 3396000.\r\nSCALING_FACTOR = 1\r\n",
                                         .radius_km = 3396.0,
                                         .half = 0.5}));
    const RawMap map = read("MEGR.LBL");
    expectTwin(map, "signed 16-bit PDS3");
    EXPECT_EQ(map.facts.radius, 3396000.0);
    EXPECT_EQ(map.facts.extent->north, 90.0);
}

TEST_F(Twins, KilometresOfFloats) {
    std::string bytes;
    for (const std::int16_t height : heights_) {
        const float km = float(height) * 0.0005f;
        bytes.append(reinterpret_cast<const char*>(&km), 4);
    }
    folder_.write("F.IMG", bytes);
    const std::string unit = "SCALING_FACTOR = 1\r\nOFFSET = 1737.4\r\n";
    for (const std::string& more : {unit + "UNIT = KILOMETER\r\n", unit}) {
        folder_.write("F.LBL", pds3Label({.image = "F.IMG", .sample_type = "PC_REAL", .more = more, .bits = 32}));
        const RawMap map = read("F.LBL");
        EXPECT_EQ(map.samples[7], float(heights_[7]) * 0.0005f);
        EXPECT_EQ(map.facts.unit, "m");
        EXPECT_EQ(map.facts.value_scale, 1000.0);
        EXPECT_EQ(map.facts.radius, 1737400.0);
        EXPECT_TRUE(map.facts.offset_is_radius);
    }
}

TEST_F(Twins, AnIsisCube) {
    folder_.write("dem.cub", isisCube(bytesOf(heights_, false)));
    const RawMap map = read("dem.cub");
    expectTwin(map, "signed 16-bit ISIS cube");
    EXPECT_EQ(map.longitude_origin, 0.0);
    EXPECT_EQ(map.facts.radius, 3396190.0);
    EXPECT_EQ(map.facts.projection, "equirectangular");
}

TEST_F(Twins, NetCdfFromTheSouth) {
    folder_.write("dem.nc", netCdf(bytesOf(fromTheSouth(heights_), true)));
    const RawMap map = read("dem.nc");
    expectTwin(map, "signed 16-bit netCDF");
    EXPECT_EQ(map.longitude_origin, 0.0);
    EXPECT_EQ(map.facts.unit, "m");
}

TEST_F(Twins, EnviByItsHeaderAndByItsSamples) {
    folder_.write("dem.img", bytesOf(heights_, false));
    folder_.write("dem.hdr", enviHeader());
    for (const char* name : {"dem.img", "dem.hdr"}) {
        const RawMap map = read(name);
        expectTwin(map, "signed 16-bit ENVI");
        EXPECT_EQ(map.longitude_origin, 0.0);
    }
}

TEST_F(Twins, AnAsciiGrid) {
    folder_.write("dem.asc", asciiGrid(heights_));
    const RawMap map = read("dem.asc");
    expectTwin(map, "signed 32-bit ASCII grid");
    EXPECT_EQ(map.longitude_origin, 0.0);
    EXPECT_TRUE(map.unknown_are_nan);
}

TEST_F(Twins, FitsWhoseFirstRowIsTheSouth) {
    folder_.write("dem.fits", fits(bytesOf(fromTheSouth(heights_), true)));
    const RawMap map = read("dem.fits");
    expectTwin(map, "signed 16-bit FITS");
    ASSERT_EQ(map.notices.size(), 1u);
    EXPECT_TRUE(holds(map.notices[0].text, "does not say where it lies"));
}

TEST_F(Twins, AVrtOfTheOthers) {
    folder_.write("dem.asc", asciiGrid(heights_));
    const std::string band =
        "<VRTRasterBand dataType=\"Int16\" band=\"1\"><SimpleSource><SourceFilename relativeToVRT=\"1\">{}"
        "</SourceFilename><SourceBand>1</SourceBand></SimpleSource></VRTRasterBand></VRTDataset>";
    const std::string head =
        "<VRTDataset rasterXSize=\"64\" rasterYSize=\"32\"><GeoTransform>0, 5.625, 0, 90, 0, -5.625</GeoTransform>";
    folder_.write("dem.vrt", head + fmt::format(fmt::runtime(band), "dem.asc"));
    expectTwin(read("dem.vrt"), "signed 16-bit VRT");
    for (const char* far_away : {"/vsicurl/http://127.0.0.1:1/a.tif", "NETCDF:http://127.0.0.1:1/a.nc:z"}) {
        folder_.write("far.vrt", head + "\n" + fmt::format(fmt::runtime(band), far_away));
        EXPECT_TRUE(holds(messageOf(ExitCode::InvalidInput, [&] { read("far.vrt"); }), "files of this machine"));
    }
}

TEST_F(Twins, EveryTruncationIsAnError) {
    const std::string unit = "UNIT = METER\r\n";
    folder_.write("T.LBL", pds3Label({.image = "T.IMG", .more = unit}));
    const std::map<std::string, std::string> files = {{"T.IMG", bytesOf(heights_, false)},
                                                      {"t.cub", isisCube(bytesOf(heights_, false))},
                                                      {"t.nc", netCdf(bytesOf(fromTheSouth(heights_), true))},
                                                      {"t.fits", fits(bytesOf(heights_, true))},
                                                      {"t.asc", asciiGrid(heights_)}};
    for (const auto& [name, bytes] : files) {
        folder_.write(name, bytes);
        EXPECT_NO_THROW(read(name)) << name;
        for (const std::size_t length : {bytes.size() / 8, bytes.size() / 2, bytes.size() * 7 / 8}) {
            folder_.write(name, bytes.substr(0, length));
            EXPECT_TRUE(holds(messageOf(ExitCode::InvalidInput, [&] { read(name); }), folder_.path().string()))
                << name << " of " << length << " bytes";
        }
    }
}

}  // namespace
}  // namespace dsphere::test
