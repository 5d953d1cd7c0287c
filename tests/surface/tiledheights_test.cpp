// Maps that stay in their file against the same ones in memory: bounds, levels, gaps, windows; and the cache of
// surveys.

#include "surface/tiledheights.h"

#include "reference/surface.h"
#include "surface/bounds.h"
#include "surface/heldmap.h"
#include "surface/levels.h"
#include "surface/spline.h"
#include "surface/surveycache.h"
#include "tests/support/expecterror.h"
#include "tests/support/scopedvariable.h"
#include "tests/support/tempfolder.h"
#include "tests/surface/grids.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <random>

namespace dsphere::test {
namespace {

namespace fs = std::filesystem;
using geo::SampleKind;

struct TiledCase {
    const char* map;
    int width, height;
    Registration registration;
    SampleKind kind;
    double max_displacement = 20.0, longitude_origin = -180.0;
    bool far_from_zero = false;
};

void PrintTo(const TiledCase& c, std::ostream* out) {
    *out << c.map << ' ' << c.width << 'x' << c.height << (c.registration == Registration::Texel ? " texel" : " grid")
         << " kind " << int(c.kind) << ", " << c.max_displacement << " % from " << c.longitude_origin;
}

/// The case's map in memory, and in a file, on one shape.
struct Twins {
    std::unique_ptr<Planet> held;
    Heightmap tiled;
    Relief relief;

    explicit Twins(const TiledCase& c, RawMap raw, std::optional<int> unknown = {}) {
        if (c.kind == SampleKind::Int16)
            for (float& sample : raw.samples) sample = std::floor(sample / 2.0f) - 16384.0f;
        if (c.far_from_zero)
            for (float& sample : raw.samples) sample = 30000.0f + std::floor(sample / 300.0f);
        RawMap known = raw;
        if (unknown) {
            known.unknown_are_nan = true;
            for (float& sample : known.samples)
                if (sample == float(*unknown)) sample = std::numeric_limits<float>::quiet_NaN();
        }
        held = makePlanet(std::move(known), c.registration, c.max_displacement, c.longitude_origin);
        tiled = makeTiledHeightmap(holdMap(std::move(raw), c.kind, unknown), held->shape);
        relief = makeRelief(held->shape, tiled, {});
    }
};

class TiledTest : public testing::TestWithParam<TiledCase> {
  protected:
    TempFolder cache_;
    ScopedVariable variable_{"XDG_CACHE_HOME", cache_.path().c_str()};
};

TEST_P(TiledTest, HasTheHeightsPolesAndRangeOfTheMapInMemory) {
    const Twins twins(GetParam(), namedMap(GetParam().map, GetParam().width, GetParam().height));
    const Heightmap &held = twins.held->map, &tiled = twins.tiled;
    EXPECT_EQ(tiled.north_pole, held.north_pole);
    EXPECT_EQ(tiled.south_pole, held.south_pole);
    for (int j = 0; j < held.height; ++j)
        for (int i = 0; i < held.width; ++i) ASSERT_EQ(tiled.at(i, j), held.at(i, j)) << i << ", " << j;
    EXPECT_LE(tiled.least, held.least);
    EXPECT_GE(tiled.greatest, held.greatest);
    if (held.registration == Registration::Gridline) return;  // in memory its pole rows hold their mean alone
    EXPECT_EQ(tiled.least, held.least);
    EXPECT_EQ(tiled.greatest, held.greatest);
}

TEST_P(TiledTest, HasTheBoundsOfTheMapInMemory) {
    const Twins twins(GetParam(), namedMap(GetParam().map, GetParam().width, GetParam().height));
    const Bounds held = buildBounds(NodeGrid(twins.held->map), twins.held->relief);
    const Bounds tiled = buildBounds(NodeGrid(twins.tiled), twins.held->relief);
    EXPECT_EQ(held.side, tiled.side);
    EXPECT_EQ(held.squared, tiled.squared);
}

TEST_P(TiledTest, TheReferencesBoundsHoldAndItsValuesAreTheSame) {
    const Twins twins(GetParam(), namedMap(GetParam().map, GetParam().width, GetParam().height));
    std::mt19937 random(3);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (const Filter filter : {Filter::Bilinear, Filter::BSpline}) {
        Relief relief = twins.held->relief;
        relief.filter = filter;
        const reference::Surface held(twins.held->map, relief), tiled(twins.tiled, relief);
        for (int k = 0; k < 1000; ++k) {
            const double u = uniform(random), v = k % 3 == 0 ? 1e-3 * uniform(random) : uniform(random);
            const double du = std::exp2(-12.0 * uniform(random)), dv = std::exp2(-12.0 * uniform(random));
            const double v1 = std::min(1.0, v + dv);
            const reference::RadiusBounds bounds = tiled.bounds(u, u + du, v, v1);
            for (int n = 0; n < 20; ++n) {
                const double phi = 2.0 * kPi * (u + du * uniform(random)) - kPi,
                             theta = kPi * (v + (v1 - v) * uniform(random));
                const dvec3 p(std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi));
                ASSERT_EQ(held.stored(p), tiled.stored(p));
                ASSERT_LE(bounds.lower, held.radius(p)) << u << ' ' << v << ' ' << du << ' ' << dv;
                ASSERT_GE(bounds.upper, held.radius(p)) << u << ' ' << v << ' ' << du << ' ' << dv;
            }
        }
    }
}

// The level is that of halving again and again (up to rounding); its error no less than the true one, and hardly more.
TEST_P(TiledTest, TheReducedMapsErrorIsNoLessThanTheTrueOne) {
    const Twins twins(GetParam(), namedMap(GetParam().map, GetParam().width, GetParam().height));
    const std::optional<Heightmap> reduced = reducedMap(twins.tiled);
    const bool divisible =
        GetParam().width % 2 == 0 && GetParam().height % 2 == (GetParam().registration == Registration::Texel ? 0 : 1);
    ASSERT_EQ(reduced.has_value(), divisible && GetParam().width >= 1024);
    if (!reduced) return;
    const double truth = greatestDifference(NodeGrid(twins.held->map), NodeGrid(*reduced));
    const double told = twins.tiled.tiled->survey().reduced_error;
    EXPECT_GE(told, truth);
    EXPECT_LE(told, truth * 1.001 + 0.5);
}

/// The case's map under a spline.
Relief splineOf(const Twins& twins) {
    Relief relief = twins.held->relief;
    relief.filter = Filter::BSpline;
    return relief;
}

TEST_P(TiledTest, ItsSplineHasTheNodesOfTheMapInMemory) {
    const Twins twins(GetParam(), namedMap(GetParam().map, GetParam().width, GetParam().height));
    const NodeGrid held(twins.held->map), tiled(twins.tiled);
    const SplineNodes of_held(held), of_tiled(tiled);
    for (int j : {0, 1, 2, 3, 255, 256, 257, held.rows() - 2, held.rows() - 1, held.rows()}) {
        const std::vector<SplineNodes::Node> row = of_held.row(j);
        for (int i : {0, 1, 255, 256, 511, 512, 700, held.width() - 2, held.width() - 1})
            EXPECT_EQ(of_tiled.at(i, j), row[std::size_t(i)]) << i << ", " << j;
    }
}

// They are those of the control points around, which never lie below the spline's own.
TEST_P(TiledTest, TheSplinesBoundsAreNoLessThanThoseOfTheMapInMemory) {
    const Twins twins(GetParam(), namedMap(GetParam().map, GetParam().width, GetParam().height));
    const Bounds held = buildBounds(NodeGrid(twins.held->map), splineOf(twins));
    const Bounds tiled = buildBounds(NodeGrid(twins.tiled), splineOf(twins));
    for (int face = 0; face < 6; ++face)
        for (int j = 0; j < held.side; ++j)
            for (int i = 0; i < held.side; ++i)
                ASSERT_GE(tiled.at(face, 0, i, j), held.at(face, 0, i, j) - 2e-7f) << face << ' ' << i << ' ' << j;
}

TEST_P(TiledTest, TheSplinesBlocksHoldItsValuesAndSlopes) {
    const Twins twins(GetParam(), namedMap(GetParam().map, GetParam().width, GetParam().height));
    const NodeGrid grid(twins.tiled);
    const BlockExtremes blocks = splineBlocks(twins.tiled.tiled->survey().blocks, grid);
    const Relief relief = splineOf(twins);
    const reference::Surface surface(twins.held->map, relief);
    std::mt19937 random(4);
    std::uniform_real_distribution<double> uniform(0.0, 1.0);
    for (int k = 0; k < 30000; ++k) {
        // A third of them within some rows of a pole.
        const double share = k % 3 == 0 ? 0.01 * uniform(random) : uniform(random);
        const double phi = 2.0 * kPi * uniform(random) - kPi, theta = kPi * (k % 2 ? share : 1.0 - share);
        const dvec3 p(std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi));
        const double column = grid.column(phi) - grid.width() * std::floor(grid.column(phi) / grid.width());
        const int i = std::min(int(column), grid.width() - 1);
        const int j = std::clamp(int(std::floor(grid.nodeRow(theta))), 0, grid.rows() - 1);
        const std::size_t block = blocks.index(i >> blocks.shift, j >> blocks.shift);
        const double value = surface.stored(p), size = 1e-6 * (1.0 + std::abs(value));
        const dvec3 gradient = surface.gradient(p);
        const double slope = glm::length(gradient - glm::dot(gradient, p) * p) / std::abs(relief.scale);
        ASSERT_GE(value, double(blocks.least[block]) - size) << phi << ' ' << theta;
        ASSERT_LE(value, double(blocks.greatest[block]) + size) << phi << ' ' << theta;
        ASSERT_LE(slope, double(blocks.steepest[block]) * 1.00001 + 1e-3) << phi << ' ' << theta;
    }
}

INSTANTIATE_TEST_SUITE_P(
    Maps, TiledTest,
    testing::Values(TiledCase{"fractal", 1024, 512, Registration::Texel, SampleKind::UInt16},
                    TiledCase{"fractal", 1024, 512, Registration::Texel, SampleKind::UInt16, 20.0, -180.0, true},
                    TiledCase{"fractal", 1024, 512, Registration::Texel, SampleKind::Int16, -15.0, 0.0},
                    TiledCase{"random", 1030, 515, Registration::Texel, SampleKind::UInt16, 10.0, -37.5},
                    TiledCase{"spikes", 1024, 513, Registration::Gridline, SampleKind::UInt16, 50.0},
                    TiledCase{"random", 1025, 520, Registration::Gridline, SampleKind::Float32, 5.0, 10.0},
                    TiledCase{"checkerboard", 2048, 1024, Registration::Texel, SampleKind::Float32, 5.0}));

class TiledGapsTest : public testing::Test {
  protected:
    TempFolder cache_;
    ScopedVariable variable_{"XDG_CACHE_HOME", cache_.path().c_str()};
};

/// Unknown texels of all kinds: single ones, runs across the seam, whole rows at both poles and in between.
RawMap mapWithGaps(float code) {
    RawMap raw = fractalMap(1024, 512);
    const auto set = [&](int row, int first, int count) {
        for (int i = first; i < first + count; ++i)
            raw.samples[std::size_t(row) * 1024 + std::size_t((i + 1024) % 1024)] = code;
    };
    for (int row : {0, 1, 2, 40, 41, 255, 256, 257, 258, 511}) set(row, 0, 1024);
    for (int row : {3, 39, 42, 254, 259}) set(row, -7, 20);
    set(100, 1, 1022);
    set(101, 500, 1);
    set(102, 0, 1023);
    for (int i = 0; i < 1024; i += 2) set(103, i, 1);
    return raw;
}

TEST_F(TiledGapsTest, AreFilledAsInMemory) {
    const TiledCase c{"", 1024, 512, Registration::Texel, SampleKind::UInt16};
    const Twins twins(c, mapWithGaps(65535.0f), 65535);
    EXPECT_EQ(twins.tiled.nodata_count, twins.held->map.nodata_count);
    for (int j = 0; j < 512; ++j)
        for (int i = 0; i < 1024; ++i) ASSERT_EQ(twins.tiled.at(i, j), twins.held->map.at(i, j)) << i << ", " << j;
    EXPECT_EQ(buildBounds(NodeGrid(twins.tiled), twins.held->relief).squared,
              buildBounds(NodeGrid(twins.held->map), twins.held->relief).squared);
}

TEST_F(TiledGapsTest, AWindowWrapsAndRepeatsTheOuterRows) {
    const TiledCase c{"", 1024, 512, Registration::Texel, SampleKind::UInt16};
    const Twins twins(c, mapWithGaps(65535.0f), 65535);
    std::mt19937 random(5);
    const auto below = [&](int n) { return int(random() % unsigned(n)); };
    for (int k = 0; k < 200; ++k) {
        const int x = below(1024), y = below(530) - 10, width = 1 + below(1030), height = 1 + below(40);
        std::vector<std::uint16_t> window(std::size_t(width) * std::size_t(height));
        twins.tiled.tiled->read(x, y, width, height, window.data());
        for (int n = 0; n < 50; ++n) {
            const int i = below(width), j = below(height);
            ASSERT_EQ(float(window[std::size_t(j) * std::size_t(width) + std::size_t(i)]),
                      twins.held->map.at((x + i) % 1024, std::clamp(y + j, 0, 511)));
        }
    }
}

TEST_F(TiledGapsTest, AMapInMemoryIsHeldInAsFewBitsAsItNeeds) {
    const auto kindOf = [](std::vector<float> samples) { return holdMap(rawOf(2, 1, std::move(samples)))->kind(); };
    EXPECT_EQ(kindOf({0.0f, 65535.0f}), SampleKind::UInt16);
    EXPECT_EQ(kindOf({-1.0f, 32767.0f}), SampleKind::Int16);
    EXPECT_EQ(kindOf({-1.0f, 32768.0f}), SampleKind::Float32);
    EXPECT_EQ(kindOf({0.5f, 1.0f}), SampleKind::Float32);
    EXPECT_EQ(kindOf({std::numeric_limits<float>::quiet_NaN(), 1.0f}), SampleKind::Float32);
}

TEST_F(TiledGapsTest, AnOverviewHasTheSamplesNearestItsMiddles) {
    const auto map = holdMap(rawOf(6, 2, {0, 1, 2, 3, 4, 5, 10, 11, 12, 13, 14, 15}), SampleKind::UInt16, 14);
    const std::vector<float> overview = map->overview(3, 1);
    EXPECT_EQ(overview[0], 11.0f);
    EXPECT_EQ(overview[1], 13.0f);
    EXPECT_EQ(map->overview(6, 2)[5], 5.0f);
    EXPECT_TRUE(std::isnan(map->overview(6, 2)[10]));
}

TEST_F(TiledGapsTest, AMapOfNothingElseIsRefused) {
    RawMap raw = rawOf(1024, 512, std::vector<float>(1024 * 512, 7.0f));
    DisplacedSphere shape;
    shape.map_path = "empty.tif";
    expectError(ExitCode::InvalidInput, "empty.tif: every one of the 1024x512 texels is unknown",
                [&] { makeTiledHeightmap(holdMap(std::move(raw), SampleKind::UInt16, 7), shape); });
}

TEST_F(TiledGapsTest, NumbersThatAreNoHeightsAreUnknown) {
    RawMap raw = fractalMap(1024, 512);
    raw.samples[5000] = std::numeric_limits<float>::infinity();
    raw.samples[6000] = -3.4028235e38f;
    raw.samples[7000] = std::numeric_limits<float>::quiet_NaN();
    DisplacedSphere shape;
    shape.map_path = "floats.tif";
    const Heightmap map = makeTiledHeightmap(holdMap(raw, SampleKind::Float32), shape);
    EXPECT_EQ(map.nodata_count, 3u);
    EXPECT_EQ(map.at(5000 % 1024, 5000 / 1024), map.at(5000 % 1024 - 1, 5000 / 1024));
}

// Once made, and once from the cache.
TEST_F(TiledGapsTest, AMapIsBlurredAsInMemory) {
    for (const double blur : {0.4, 2.3, 2.3, 8.0}) {
        DisplacedSphere shape;
        shape.map_path = "blurred.tif";
        shape.blur = blur;
        RawMap raw = mapWithGaps(65535.0f), known = raw;
        known.unknown_are_nan = true;
        for (float& sample : known.samples)
            if (sample == 65535.0f) sample = std::numeric_limits<float>::quiet_NaN();
        const Heightmap held = makeHeightmap(std::move(known), shape);
        const Heightmap tiled = makeTiledHeightmap(holdMap(std::move(raw), SampleKind::UInt16, 65535), shape);
        EXPECT_EQ(tiled.nodata_count, held.nodata_count);
        EXPECT_EQ(tiled.north_pole, held.north_pole);
        EXPECT_EQ(tiled.greatest, held.greatest);
        for (int j = 0; j < 512; j += 3)
            for (int i = 0; i < 1024; ++i) ASSERT_EQ(tiled.at(i, j), held.at(i, j)) << blur << ": " << i << ", " << j;
        const Relief relief = makeRelief(shape, held, {});
        EXPECT_EQ(buildBounds(NodeGrid(tiled), relief).squared, buildBounds(NodeGrid(held), relief).squared);
    }
}

class SurveyCacheTest : public TiledGapsTest {
  protected:
    fs::path file() const { return *fs::directory_iterator(cache_.path() / "dsphere" / "maps"); }
};

TEST_F(SurveyCacheTest, ASurveyComesBackAsItWasKept) {
    const TiledCase c{"", 1024, 512, Registration::Texel, SampleKind::UInt16};
    const Twins made(c, mapWithGaps(65535.0f), 65535);
    const std::string before = fs::path(file()).string();
    const Twins read(c, mapWithGaps(65535.0f), 65535);
    EXPECT_EQ(file().string(), before);
    const Survey &a = made.tiled.tiled->survey(), &b = read.tiled.tiled->survey();
    EXPECT_EQ(a.cells.least, b.cells.least);
    EXPECT_EQ(a.cells.greatest, b.cells.greatest);
    EXPECT_EQ(a.blocks.least, b.blocks.least);
    EXPECT_EQ(a.reduced, b.reduced);
    EXPECT_EQ(a.reduced_error, b.reduced_error);
    EXPECT_EQ(read.tiled.nodata_count, made.tiled.nodata_count);
    EXPECT_EQ(read.tiled.at(100, 40), made.tiled.at(100, 40));
}

// Whatever is wrong with the file, the survey is made anew.
TEST_F(SurveyCacheTest, ADamagedOrShortenedFileCountsAsAbsent) {
    const TiledCase c{"", 1024, 512, Registration::Texel, SampleKind::UInt16};
    const Twins made(c, mapWithGaps(65535.0f), 65535);
    const fs::path kept = file();
    std::ifstream in(kept, std::ios::binary);
    const std::string whole((std::istreambuf_iterator<char>(in)), std::istreambuf_iterator<char>());
    const std::uint64_t key = std::stoull(kept.stem().string(), nullptr, 16);
    ASSERT_TRUE(SurveyCache::load(key));
    const auto write = [&](const std::string& bytes) {
        std::ofstream(kept, std::ios::binary | std::ios::trunc).write(bytes.data(), std::streamsize(bytes.size()));
    };
    std::mt19937 random(9);
    for (int k = 0; k < 60; ++k) {
        std::string damaged = whole;
        const std::size_t at = k < 30 ? std::size_t(k) : random() % whole.size();
        damaged[at] = char(damaged[at] ^ (1 << k % 8));
        write(damaged);
        EXPECT_FALSE(SurveyCache::load(key)) << "bit " << k % 8 << " of byte " << at;
        write(whole.substr(0, k < 30 ? std::size_t(k) : at));
        EXPECT_FALSE(SurveyCache::load(key)) << "cut to " << at;
    }
    write(whole + "x");
    EXPECT_FALSE(SurveyCache::load(key));
    const Twins again(c, mapWithGaps(65535.0f), 65535);
    EXPECT_TRUE(SurveyCache::load(key));
}

TEST_F(SurveyCacheTest, OtherNodataIsAnotherSurvey) {
    RawMap raw = fractalMap(1024, 512);
    DisplacedSphere shape;
    shape.map_path = "map.tif";
    shape.nodata = double(raw.samples[0]);
    const auto source = holdMap(raw, SampleKind::UInt16);
    EXPECT_GT(makeTiledHeightmap(source, shape).nodata_count, 0u);
    shape.nodata.reset();
    EXPECT_EQ(makeTiledHeightmap(source, shape).nodata_count, 0u);
}

}  // namespace
}  // namespace dsphere::test
