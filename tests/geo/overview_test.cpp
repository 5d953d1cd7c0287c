// Maps in their files, read coarsely.

#include "geo/largemap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "geo/readmap.h"
#include "tests/image/tiffwriter.h"
#include "tests/support/tempfolder.h"

namespace dsphere::test {
namespace {

namespace fs = std::filesystem;

bool sameSample(float a, float b) {
    return a == b || (std::isnan(a) && std::isnan(b));
}

/// A third of the columns and rows: the middle one of each three by three samples.
void expectMiddles(const fs::path& path) {
    SCOPED_TRACE(path.filename());
    const RawMap whole = geo::readMap(path);
    const auto map = geo::openLargeMap(path, {}, 1);
    ASSERT_TRUE(map);
    ASSERT_TRUE(whole.width % 3 == 0 && whole.height % 3 == 0) << whole.width << 'x' << whole.height;
    const int width = whole.width / 3, height = whole.height / 3;
    const std::vector<float> overview = map->overview(width, height);
    ASSERT_EQ(overview.size(), std::size_t(width) * std::size_t(height));
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) {
            const float is = overview[std::size_t(j * width + i)];
            const float should = whole.samples[std::size_t((3 * j + 1) * whole.width + 3 * i + 1)];
            ASSERT_TRUE(sameSample(is, should)) << is << " instead of " << should << " at " << i << ", " << j;
        }
}

class Overviews : public testing::Test {
  protected:
    template <typename Sample>
    fs::path write(const std::string& name, const TiffForm& form) {
        constexpr int kWidth = 300, kHeight = 150;
        std::vector<Sample> samples(std::size_t(kWidth) * kHeight);
        for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = Sample(i * 7919 % 251);
        return folder_.write(name, tiffFile<Sample>(form, kWidth, kHeight, samples));
    }
    /// A VRT of int16.tif's first rows, where 100 is unknown; `place`: "west, dx, 0, north, 0, dy" in degrees.
    fs::path placed(const std::string& name, int rows, const std::string& place) {
        write<std::int16_t>("int16.tif", {});
        return folder_.write(name, "<VRTDataset rasterXSize=\"300\" rasterYSize=\"" + std::to_string(rows) +
                                       "\"><GeoTransform>" + place +
                                       "</GeoTransform><VRTRasterBand dataType=\"Int16\" band=\"1\"><NoDataValue>100"
                                       "</NoDataValue><SimpleSource><SourceFilename relativeToVRT=\"1\">int16.tif"
                                       "</SourceFilename><SourceBand>1</SourceBand></SimpleSource></VRTRasterBand>"
                                       "</VRTDataset>");
    }

    TempFolder folder_;
};

TEST_F(Overviews, AreSamplesOfTheMap) {
    const TiffForm tiles{.tile_width = 64, .tile_height = 32};
    expectMiddles(write<std::uint16_t>("strips.tif", {}));
    expectMiddles(write<std::int8_t>("bytes.tif", tiles));
    expectMiddles(write<float>("floats.tif", tiles));
}

TEST_F(Overviews, LieAsTheMapDoes) {
    expectMiddles(placed("east.vrt", 150, "-180, 1.2, 0, 90, 0, -1.2"));
    expectMiddles(placed("west.vrt", 150, "180, -1.2, 0, 90, 0, -1.2"));
    expectMiddles(placed("turned.vrt", 150, "180, -1.2, 0, -90, 0, 1.2"));
}

/// Rows that the file does not have are unknown: here those of the last 38.
TEST_F(Overviews, EndWhereTheFileDoes) {
    constexpr int kColumns = 60, kRows = 30, kCovered = 112;
    const auto map = geo::openLargeMap(placed("north.vrt", kCovered, "-180, 1.2, 0, 90, 0, -1.2"), {}, 1);
    ASSERT_TRUE(map);
    const std::vector<float> overview = map->overview(kColumns, kRows);
    for (int row = 0; row < kRows; ++row) {
        const bool covered = (row + 0.5) * 150 / kRows < kCovered;
        bool known = false;
        for (int i = 0; i < kColumns; ++i) known = known || !std::isnan(overview[std::size_t(row * kColumns + i)]);
        EXPECT_EQ(known, covered) << "row " << row;
    }
}

}  // namespace
}  // namespace dsphere::test
