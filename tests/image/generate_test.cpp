#include "image/generate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "image/greymap.h"
#include "image/rawmap.h"
#include "tests/support/expecterror.h"
#include "tests/support/tempfolder.h"

namespace dsphere::test {
namespace {

constexpr MapKind kKinds[] = {MapKind::Moon,   MapKind::Fractal,      MapKind::Terraces,
                              MapKind::Spikes, MapKind::Checkerboard, MapKind::Random};

std::vector<std::uint16_t> rowOf(const MapGenerator& generator, int j) {
    std::vector<std::uint16_t> row(std::size_t(generator.width()));
    generator.fillRow(j, row);
    return row;
}

std::vector<std::uint16_t> allRows(MapKind kind, int width, int height, std::uint32_t seed) {
    const MapGenerator generator(kind, width, height, seed);
    std::vector<std::uint16_t> all;
    for (int j = 0; j < height; ++j) {
        const std::vector<std::uint16_t> row = rowOf(generator, j);
        all.insert(all.end(), row.begin(), row.end());
    }
    return all;
}

TEST(Generate, TheSameSeedMakesTheSameMap) {
    for (MapKind kind : kKinds) {
        EXPECT_EQ(allRows(kind, 64, 32, 7), allRows(kind, 64, 32, 7)) << int(kind);
        EXPECT_EQ(allRows(kind, 64, 32, 7) == allRows(kind, 64, 32, 8), kind == MapKind::Checkerboard) << int(kind);
    }
}

TEST(Generate, AnySize) {
    for (MapKind kind : kKinds) {
        EXPECT_EQ(allRows(kind, 1, 1, 1).size(), 1u);
        EXPECT_EQ(allRows(kind, 3, 1, 1).size(), 3u);
        EXPECT_EQ(allRows(kind, 1, 3, 1).size(), 3u);
    }
}

// A kind made on the sphere changes no more across the seam, and along the rows beside the poles, than elsewhere.
TEST(Generate, NoSeamAndNoPole) {
    constexpr int kWidth = 512, kHeight = 256;
    for (MapKind kind : {MapKind::Moon, MapKind::Fractal}) {
        const std::vector<std::uint16_t> map = allRows(kind, kWidth, kHeight, 3);
        const auto at = [&](int i, int j) { return int(map[std::size_t(j * kWidth + i)]); };
        double inside = 0.0, seam = 0.0, polar = 0.0;
        for (int j = 0; j < kHeight; ++j) {
            seam += std::abs(at(kWidth - 1, j) - at(0, j));
            for (int i = 100; i < 110; ++i) inside += std::abs(at(i, j) - at(i - 1, j)) / 10.0;
        }
        for (int i = 1; i < kWidth; ++i)
            polar = std::max({polar, std::abs(double(at(i, 0) - at(i - 1, 0))),
                              std::abs(double(at(i, kHeight - 1) - at(i - 1, kHeight - 1)))});
        EXPECT_LT(seam, 2.0 * inside) << int(kind);
        EXPECT_LT(polar, 200.0) << int(kind);
    }
}

TEST(Generate, TheMoonUsesItsRangeAndKeepsItsCratersAsItGrows) {
    const std::vector<std::uint16_t> small = allRows(MapKind::Moon, 256, 128, 1);
    const auto [least, greatest] = std::ranges::minmax(small);
    EXPECT_GT(least, 0);
    EXPECT_LT(greatest, 65535);
    EXPECT_GT(greatest - least, 20000);
    // The mean of each 2x2 block of the twice finer map is the coarse one's texel, but for the finer craters.
    const std::vector<std::uint16_t> fine = allRows(MapKind::Moon, 512, 256, 1);
    const std::vector<std::uint16_t> other = allRows(MapKind::Moon, 256, 128, 2);
    double same_land = 0.0, other_land = 0.0;
    for (std::size_t j = 0; j < 128; ++j)
        for (std::size_t i = 0; i < 256; ++i) {
            const std::size_t k = j * 256 + i, top = 2 * j * 512 + 2 * i, bottom = top + 512;
            const double mean = (fine[top] + fine[top + 1] + fine[bottom] + fine[bottom + 1]) / 4.0;
            same_land += std::abs(mean - small[k]);
            other_land += std::abs(mean - other[k]);
        }
    EXPECT_LT(same_land, 0.3 * other_land);
}

// Every format gives back what the generator made, also when the rows are no multiple of a block or a strip.
TEST(GreyMap, EveryFormatGivesTheRowsBack) {
    const TempFolder folder;
    const MapGenerator generator(MapKind::Random, 67, 75, 5);
    const std::vector<std::uint16_t> expected = allRows(MapKind::Random, 67, 75, 5);
    for (const char* name : {"map.png", "map.pgm", "map.tif", "MAP.TIFF"}) {
        const std::filesystem::path path = folder.path() / name;
        double share = 0.0;
        writeGreyMap(
            path, 67, 75, [&](int j, std::span<std::uint16_t> row) { generator.fillRow(j, row); },
            [&](double done) {
                EXPECT_GE(done, share);
                share = done;
                return true;
            });
        EXPECT_EQ(share, 1.0);
        const RawMap map = readRawMap(path);
        EXPECT_EQ(map.width, 67);
        EXPECT_EQ(map.height, 75);
        EXPECT_EQ(map.full_scale, 65535.0);
        EXPECT_TRUE(std::ranges::equal(map.samples, expected)) << name;
    }
    EXPECT_EQ(folder.entries(), 4u);
}

TEST(GreyMap, NothingIsLeftOfAnInterruptedMap) {
    const TempFolder folder;
    const auto zero = [](int, std::span<std::uint16_t> row) { std::ranges::fill(row, std::uint16_t(0)); };
    for (const char* name : {"map.png", "map.pgm", "map.tif"})
        messageOf(ExitCode::Interrupted,
                  [&] { writeGreyMap(folder.path() / name, 64, 200, zero, [](double) { return false; }); });
    EXPECT_EQ(folder.entries(), 0u);
}

TEST(GreyMap, RefusesOtherNamesAndPlaces) {
    const auto zero = [](int, std::span<std::uint16_t> row) { std::ranges::fill(row, std::uint16_t(0)); };
    const auto on = [](double) { return true; };
    EXPECT_TRUE(holds(messageOf(ExitCode::Usage, [&] { writeGreyMap("map.jpg", 4, 2, zero, on); }), "map.jpg"));
    const TempFolder folder;
    const std::filesystem::path nowhere = folder.path() / "no" / "map.png";
    EXPECT_TRUE(holds(messageOf(ExitCode::Failure, [&] { writeGreyMap(nowhere, 4, 2, zero, on); }), nowhere.string()));
}

}  // namespace
}  // namespace dsphere::test
