// Levels of detail: means within their texels' bounds, poles kept, and a difference that no place exceeds.

#include "surface/levels.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace dsphere {
namespace {

Heightmap mapOf(int width, int height, Registration registration, float (*value)(int, int)) {
    RawMap raw;
    raw.width = width;
    raw.height = height;
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) raw.samples.push_back(value(i, j));
    DisplacedSphere shape;
    shape.registration = registration;
    return makeHeightmap(std::move(raw), shape);
}

float noise(int i, int j) {
    return float((unsigned(i) * 7919u + unsigned(j) * 104729u) * 2654435761u >> 8) * 0x1p-24f;
}

float row(int, int j) {
    return float(j);
}

// The surface in double, by another path than levels.cpp's.
double valueAt(const NodeGrid& grid, double longitude, double colatitude) {
    double y = colatitude / grid.cellHeight(), x = grid.column(longitude);
    int j = int(std::floor(y)), rows = grid.rows();
    double fv = y - j;
    if (grid.halfCaps()) {
        double last = rows - 1.5;  // row of the last circle, in whole cells
        j = y < 0.5 ? 0 : (y >= last + 0.5 ? rows - 1 : int(std::floor(y + 0.5)));
        fv = y < 0.5 ? 2.0 * y : (y >= last + 0.5 ? 2.0 * (y - last - 0.5) : y + 0.5 - j);
    }
    j = std::min(j, rows - 1);
    int i = int(std::floor(x)), w = grid.width();
    double fu = x - i;
    i = (i % w + w) % w;
    int next = (i + 1) % w;
    double north = grid.row(j)[i] + fu * (grid.row(j)[next] - grid.row(j)[i]);
    double south = grid.row(j + 1)[i] + fu * (grid.row(j + 1)[next] - grid.row(j + 1)[i]);
    return north + fv * (south - north);
}

TEST(Levels, ATexelIsTheMeanOfFour) {
    Heightmap map = mapOf(1024, 512, Registration::Texel, noise);
    std::optional<Heightmap> half = halved(map);
    ASSERT_TRUE(half);
    EXPECT_EQ(half->width, 512);
    EXPECT_EQ(half->height, 256);
    EXPECT_FLOAT_EQ(half->at(3, 5), (map.at(6, 10) + map.at(7, 10) + map.at(6, 11) + map.at(7, 11)) / 4.0f);
    EXPECT_EQ(half->north_pole, map.north_pole);
    EXPECT_EQ(half->south_pole, map.south_pole);
}

TEST(Levels, ANodeIsATentOverItsNeighboursAndWraps) {
    Heightmap map = mapOf(1024, 513, Registration::Gridline, noise);
    std::optional<Heightmap> half = halved(map);
    ASSERT_TRUE(half);
    EXPECT_EQ(half->height, 257);
    auto across = [&](int j) { return 0.25 * map.at(1023, j) + 0.5 * map.at(0, j) + 0.25 * map.at(1, j); };
    EXPECT_FLOAT_EQ(half->at(0, 7), float(0.25 * across(13) + 0.5 * across(14) + 0.25 * across(15)));
    for (int i : {0, 100, 511}) {
        EXPECT_EQ(half->at(i, 0), map.north_pole);
        EXPECT_EQ(half->at(i, 256), map.south_pole);
    }
}

TEST(Levels, OddOrSmallMapsHaveNone) {
    EXPECT_FALSE(halved(mapOf(1026, 511, Registration::Texel, row)));
    EXPECT_FALSE(halved(mapOf(1025, 512, Registration::Texel, row)));
    EXPECT_FALSE(halved(mapOf(1024, 512, Registration::Gridline, row)));
    EXPECT_FALSE(halved(mapOf(1022, 512, Registration::Texel, row)));
    EXPECT_FALSE(halved(mapOf(1024, 510, Registration::Texel, row)));
}

class LevelsOf : public testing::TestWithParam<Registration> {};

TEST_P(LevelsOf, NoPlaceDiffersMoreThanTheGreatestDifference) {
    Heightmap map = mapOf(2048, GetParam() == Registration::Texel ? 1024 : 1025, GetParam(), noise);
    std::optional<Heightmap> half = halved(map), quarter = halved(*half);
    ASSERT_TRUE(quarter);
    NodeGrid whole(map);
    for (const Heightmap* level : {&*half, &*quarter}) {
        NodeGrid grid(*level);
        double bound = greatestDifference(whole, grid), greatest = 0.0;
        EXPECT_DOUBLE_EQ(bound, greatestDifference(grid, whole));
        std::mt19937 random(3);
        std::uniform_real_distribution<double> share(0.0, 1.0);
        for (int k = 0; k < 200000; ++k) {
            double longitude = 2.0 * kPi * share(random), colatitude = kPi * share(random);
            greatest = std::max(greatest,
                                std::abs(valueAt(whole, longitude, colatitude) - valueAt(grid, longitude, colatitude)));
        }
        EXPECT_LE(greatest, bound * (1.0 + 1e-9));
        EXPECT_GT(greatest, 0.8 * bound);  // noise everywhere: a bound far from it would be another's
    }
    EXPECT_EQ(greatestDifference(whole, whole), 0.0);
}

INSTANTIATE_TEST_SUITE_P(Registrations, LevelsOf, testing::Values(Registration::Texel, Registration::Gridline),
                         [](const auto& info) { return info.param == Registration::Texel ? "texel" : "gridline"; });

}  // namespace
}  // namespace dsphere
