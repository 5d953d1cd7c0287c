// Maps that are too large to be held in memory.

#include "tests/cli/fixture.h"
#include "tests/image/tiffwriter.h"

#include <nlohmann/json.hpp>

#include <map>

namespace dsphere::test {
namespace {

class LargeMapsCli : public CliTest {
  protected:
    static constexpr int kTile = 512;

    /// Height in row j and column i of a tile that is written: 1 + i - 2 j.
    static std::vector<std::int16_t> ramp() {
        std::vector<std::int16_t> samples;
        for (int j = 0; j < kTile; ++j)
            for (int i = 0; i < kTile; ++i) samples.push_back(std::int16_t(1 + i - 2 * j));
        return samples;
    }

    /// From 0 to 360 degrees, nodata 0 where no tile is written.
    void writeMap(const std::string& name, int width, int height, std::initializer_list<std::uint32_t> tiles) {
        std::map<std::uint32_t, std::vector<std::int16_t>> written;
        for (const std::uint32_t tile : tiles) written[tile] = ramp();
        folder_.write(name + ".tif", sparseTiffFile<std::int16_t>(width, height, kTile, written));
        const double step = 360.0 / width;
        folder_.write(name + ".tfw", fmt::format("{0}\n0\n0\n-{0}\n{1}\n{2}\n", step, 0.5 * step, 90.0 - 0.5 * step));
        folder_.write(name + ".tif.aux.xml",
                      "<PAMDataset><PAMRasterBand band=\"1\"><NoDataValue>0</NoDataValue><UnitType>m</UnitType>"
                      "</PAMRasterBand></PAMDataset>");
    }

    nlohmann::json info(std::vector<std::string> words) {
        words.insert(words.begin(), "info");
        words.push_back("--json");
        const Outcome outcome = run(words);
        EXPECT_EQ(outcome.code, 0) << outcome.err;
        return nlohmann::json::parse(outcome.out);
    }
};

TEST_F(LargeMapsCli, InfoDoesNotReadTheTexels) {
    writeMap("moon", 92160, 46080, {0});
    std::string bytes = readBytes(path("moon.tif"));
    std::fill_n(bytes.begin() + 100, 300, '\x55');  // of tile 0
    folder_.write("moon.tif", bytes);
    const nlohmann::json json = info({"moon.tif"});
    EXPECT_EQ(json["width"], 92160);
    EXPECT_EQ(json["height"], 46080);
    EXPECT_EQ(json["type"], "signed 16-bit TIFF");
    EXPECT_EQ(json["longitude_origin"], 0.0);
    EXPECT_EQ(json["extent"]["south"], -90.0);
    EXPECT_EQ(json["registration"], "texel");
    EXPECT_EQ(json["unit"], "m");
    EXPECT_EQ(json["sources"]["nodata"], "tag");
    EXPECT_EQ(json["scanned"], false);
    for (const char* key : {"least", "greatest", "mean", "unknown_texels", "non_finite_texels", "height_range"})
        EXPECT_TRUE(json[key].is_null()) << key;
    EXPECT_GT(json["device_bytes"], 2ull * 92160 * 46080);
    const Outcome text = run({"info", "moon.tif"});
    EXPECT_TRUE(holds(text.err, "dsphere: note: moon.tif: its 4246732800 texels are not read: --scan reads them"));
    EXPECT_TRUE(holds(text.out, "scanned"));
    expectFailure(run({"info", "moon.tif", "--scan"}), 3, "moon.tif: TIFF: rows 0 to 511 of columns 0 to");
}

TEST_F(LargeMapsCli, ScanTellsWhatTheTexelsAre) {
    constexpr int kWidth = 11776, kHeight = 5888;  // 23 tiles in a row; 69 million texels
    writeMap("moon", kWidth, kHeight, {1, 2 * 23 + 5});
    const nlohmann::json json = info({"moon.tif", "--scan"});
    EXPECT_EQ(json["scanned"], true);
    EXPECT_EQ(json["least"]["value"], 1.0 - 2.0 * 511);
    EXPECT_EQ(json["least"]["column"], kTile) << "the first of the two tiles'";
    EXPECT_EQ(json["least"]["row"], kTile - 1);
    EXPECT_EQ(json["greatest"]["value"], 512.0);
    EXPECT_EQ(json["greatest"]["column"], 2 * kTile - 1);
    EXPECT_EQ(json["greatest"]["row"], 0);
    EXPECT_DOUBLE_EQ(json["greatest"]["longitude"], (2 * kTile - 0.5) * 360.0 / kWidth);
    EXPECT_EQ(json["height_range"], (nlohmann::json{-1021.0, 512.0}));
    // 1 + i - 2 j is 0, which is unknown, where i is odd and j is (1 + i) / 2.
    const int known = 2 * (kTile * kTile - kTile / 2);
    EXPECT_EQ(json["unknown_texels"], kWidth * kHeight - known);
    EXPECT_DOUBLE_EQ(json["mean"], 2.0 * kTile * kTile * (1.0 + 0.5 * 511 - 511.0) / known);
    EXPECT_EQ(json["non_finite_texels"], 0);
}

TEST_F(LargeMapsCli, ScanIsAboutMaps) {
    folder_.write("map.pgm", "P5 2 1 255\nab");
    folder_.write("scene.pbrt", "WorldBegin Shape \"sphere\"");
    EXPECT_EQ(info({"map.pgm", "--scan"}), info({"map.pgm"})) << "a small map is always read";
    EXPECT_EQ(info({"map.pgm"})["scanned"], true);
    expectFailure(run({"info", "scene.pbrt", "--scan"}), 2, "--scan");
}

}  // namespace
}  // namespace dsphere::test
