#include "surface/heightmap.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/support/expecterror.h"
#include "tests/support/pngwriter.h"
#include "tests/support/tempfolder.h"
#include "tests/surface/grids.h"

namespace dsphere::test {
namespace {

const SourceLocation kWhere{"planet.pbrt", 7, 3};

/// A shape of radius 2 whose k is 1 (50 %).
DisplacedSphere shapeOf() {
    DisplacedSphere shape;
    shape.radius = 2.0;
    shape.max_displacement = 50.0;
    shape.map_path = "map.pfm";
    return shape;
}

DisplacedSphere gridlineShape() {
    DisplacedSphere shape = shapeOf();
    shape.registration = Registration::Gridline;
    return shape;
}

TEST(Heightmap, PolesAreTheMeansOfTheirRows) {
    const Heightmap map = makeHeightmap(rawOf(4, 2, {1, 2, 3, 6, -1, -1, -1, -2}), shapeOf());
    EXPECT_EQ(map.registration, Registration::Texel);
    EXPECT_EQ(map.north_pole, 3.0f);
    EXPECT_EQ(map.south_pole, -1.25f);
    EXPECT_EQ(map.samples, (std::vector<float>{1, 2, 3, 6, -1, -1, -1, -2}));
    EXPECT_EQ(map.at(3, 0), 6.0f);
    EXPECT_EQ(map.at(0, 1), -1.0f);
    EXPECT_EQ(map.least, -2.0f);
    EXPECT_EQ(map.greatest, 6.0f);
    EXPECT_EQ(map.longitude_origin, -180.0);
    EXPECT_EQ(map.path, "map.pfm");
}

TEST(Heightmap, TheMeanOfEqualValuesIsExact) {
    const Heightmap map = makeHeightmap(rawOf(999, 1, std::vector<float>(999, 0.1f)), shapeOf());
    EXPECT_EQ(float(map.stored(map.north_pole)), 0.1f);
    EXPECT_EQ(float(map.stored(map.south_pole)), 0.1f);
}

TEST(Heightmap, ValuesFarFromZeroCountFromTheLeast) {
    const std::vector<float> values{30007, 30000, 30200, 30003};
    const Heightmap map = makeHeightmap(rawOf(4, 1, values), shapeOf());
    EXPECT_EQ(map.zero, 30000.0);
    EXPECT_EQ(map.samples, (std::vector<float>{7, 0, 200, 3}));
    EXPECT_EQ(map.north_pole, 52.5f);
    EXPECT_EQ(map.storedLeast(), 30000.0);
    EXPECT_EQ(map.storedGreatest(), 30200.0);
    for (double sign : {1.0, -1.0}) {
        DisplacedSphere shape = shapeOf();
        shape.height_scale = 1e-3;
        shape.midlevel = sign * 30100.0;
        std::vector<float> signed_values;
        for (float value : values) signed_values.push_back(float(sign) * value);
        const Heightmap signed_map = makeHeightmap(rawOf(4, 1, signed_values), shape);
        const Relief relief = makeRelief(shape, signed_map, kWhere);
        for (int i = 0; i < 4; ++i) {
            const double sample = signed_map.at(i, 0);
            EXPECT_EQ(signed_map.stored(sample), signed_values[std::size_t(i)]);
            EXPECT_NEAR(relief.base + relief.scale * sample,
                        shape.radius + 1e-3 * (double(signed_values[std::size_t(i)]) - shape.midlevel), 1e-12);
            EXPECT_NEAR(relief.h_offset + relief.h_scale * sample, double(signed_values[std::size_t(i)]), 1e-9);
        }
    }
    EXPECT_EQ(makeHeightmap(rawOf(2, 1, {100, 150}), shapeOf()).zero, 100.0);
    EXPECT_EQ(makeHeightmap(rawOf(2, 1, {100, 250}), shapeOf()).zero, 0.0);
    EXPECT_EQ(makeHeightmap(rawOf(2, 1, {-1, 1}), shapeOf()).zero, 0.0);
}

TEST(Heightmap, GridlineRowsAtThePolesAreReplaced) {
    const Heightmap map = makeHeightmap(rawOf(2, 3, {1, 9, 4, 5, -8, -2}), gridlineShape());
    EXPECT_EQ(map.registration, Registration::Gridline);
    EXPECT_EQ(map.samples, (std::vector<float>{5, 5, 4, 5, -5, -5}));
    EXPECT_EQ(map.north_pole, 5.0f);
    EXPECT_EQ(map.south_pole, -5.0f);
    EXPECT_EQ(map.least, -5.0f);
    EXPECT_EQ(map.greatest, 5.0f);
}

TEST(Heightmap, GridlineNeedsARowAtEachPole) {
    const std::string message = messageOf(ExitCode::InvalidInput, [] {
        makeHeightmap(rawOf(2, 1, {1, 2}), gridlineShape());
    });
    EXPECT_TRUE(holds(message, "map.pfm"));
    EXPECT_TRUE(holds(message, "at least 2"));
    EXPECT_EQ(makeHeightmap(rawOf(1, 2, {1, 2}), gridlineShape()).south_pole, 2.0f);
}

TEST(Heightmap, TheSceneOverridesTheFile) {
    RawMap raw = rawOf(1, 2, {1, 2});
    raw.gridline = true;
    raw.longitude_origin = 0.0;
    raw.full_scale = 255.0;
    raw.type = "float32 GTX";
    const Heightmap own = makeHeightmap(raw, shapeOf());
    EXPECT_EQ(own.registration, Registration::Gridline);
    EXPECT_EQ(own.longitude_origin, 0.0);
    EXPECT_EQ(own.full_scale, 255.0);
    EXPECT_EQ(own.type, "float32 GTX");
    DisplacedSphere shape = shapeOf();
    shape.registration = Registration::Texel;
    shape.longitude_origin = 30.0;
    const Heightmap overridden = makeHeightmap(raw, shape);
    EXPECT_EQ(overridden.registration, Registration::Texel);
    EXPECT_EQ(overridden.longitude_origin, 30.0);
}

TEST(Heightmap, LoadsTheShapesFile) {
    const TempFolder folder;
    DisplacedSphere shape = shapeOf();
    shape.map_path = folder.write("map.png", pngFile(2, 1, 16, PngColour::Grey, {1, 40000})).string();
    const Heightmap map = loadHeightmap(shape);
    EXPECT_EQ(map.samples, (std::vector<float>{1, 40000}));
    EXPECT_EQ(map.full_scale, 65535.0);
    EXPECT_EQ(map.path, shape.map_path);
    shape.map_path += "x";
    EXPECT_TRUE(holds(messageOf(ExitCode::InvalidInput, [&] { loadHeightmap(shape); }), shape.map_path));
}

TEST(Heightmap, NoMapIsAFlatOne) {
    DisplacedSphere shape = gridlineShape();
    shape.map_path = "";
    const Heightmap map = loadHeightmap(shape);
    EXPECT_EQ(map.width, 1);
    EXPECT_EQ(map.height, 1);
    EXPECT_EQ(map.samples, (std::vector<float>{0}));
    EXPECT_EQ(map.registration, Registration::Texel);
    shape.midlevel = 0.5;
    const Relief relief = makeRelief(shape, map, kWhere);
    EXPECT_EQ(relief.least_radius, 1.5);
    EXPECT_EQ(relief.greatest_radius, 1.5);
}

TEST(Relief, IntegersSpanTheFullScale) {
    RawMap raw = rawOf(2, 1, {0, 1000});
    raw.full_scale = 1000.0;
    DisplacedSphere shape = shapeOf();
    shape.midlevel = 0.25;
    const Relief relief = makeRelief(shape, makeHeightmap(raw, shape), kWhere);
    EXPECT_DOUBLE_EQ(relief.base, 1.75);
    EXPECT_DOUBLE_EQ(relief.scale, 0.001);
    EXPECT_DOUBLE_EQ(relief.least_radius, 1.75);
    EXPECT_DOUBLE_EQ(relief.greatest_radius, 2.75);
    EXPECT_DOUBLE_EQ(relief.h_scale, 0.001);
    EXPECT_EQ(relief.h_offset, 0.0);
}

TEST(Relief, HeightMinAndMaxSetTheRange) {
    DisplacedSphere shape = shapeOf();
    shape.height_min = -100.0;
    shape.height_max = 300.0;
    const Relief relief = makeRelief(shape, makeHeightmap(rawOf(2, 1, {-100, 100}), shape), kWhere);
    EXPECT_DOUBLE_EQ(relief.h_offset + relief.h_scale * -100.0, 0.0);
    EXPECT_DOUBLE_EQ(relief.h_offset + relief.h_scale * 300.0, 1.0);
    EXPECT_DOUBLE_EQ(relief.least_radius, 2.0);
    EXPECT_DOUBLE_EQ(relief.greatest_radius, 2.5);
}

TEST(Relief, HeightMinMayLieAboveHeightMax) {
    DisplacedSphere shape = shapeOf();
    shape.height_min = 1.0;
    shape.height_max = 0.0;
    const Relief relief = makeRelief(shape, makeHeightmap(rawOf(2, 1, {0.25f, 1}), shape), kWhere);
    EXPECT_DOUBLE_EQ(relief.least_radius, 2.0);
    EXPECT_DOUBLE_EQ(relief.greatest_radius, 2.75);
}

TEST(Relief, NegativeDisplacementDigs) {
    DisplacedSphere shape = shapeOf();
    shape.max_displacement = -25.0;
    const Relief relief = makeRelief(shape, makeHeightmap(rawOf(2, 1, {0.5f, 1}), shape), kWhere);
    EXPECT_DOUBLE_EQ(relief.scale, -0.5);
    EXPECT_DOUBLE_EQ(relief.least_radius, 1.5);
    EXPECT_DOUBLE_EQ(relief.greatest_radius, 1.75);
}

TEST(Relief, HeightScaleCountsStoredUnits) {
    DisplacedSphere shape = shapeOf();
    shape.radius = 6371000.0;
    shape.height_scale = 2.0;
    shape.midlevel = 10.0;
    shape.height_min = -100.0;
    shape.height_max = 100.0;
    const Relief relief = makeRelief(shape, makeHeightmap(rawOf(2, 1, {-100, 85}), shape), kWhere);
    EXPECT_DOUBLE_EQ(relief.least_radius, 6371000.0 - 220.0);
    EXPECT_DOUBLE_EQ(relief.greatest_radius, 6371000.0 + 150.0);
    EXPECT_DOUBLE_EQ(relief.h_offset + relief.h_scale * 0.0, 0.5);
}

TEST(Relief, RefusesAnEmptyRange) {
    DisplacedSphere shape = shapeOf();
    shape.height_min = shape.height_max = 5.0;
    const Heightmap map = makeHeightmap(rawOf(1, 1, {5}), shape);
    const std::string message = messageOf(ExitCode::InvalidInput, [&] { makeRelief(shape, map, kWhere); });
    EXPECT_TRUE(holds(message, "planet.pbrt:7:3"));
    EXPECT_TRUE(holds(message, "heightmin is 5 and heightmax 5"));
    shape.height_min = 1.0;  // floats: heightmax is 1 unless set
    shape.height_max.reset();
    EXPECT_NE(messageOf(ExitCode::InvalidInput, [&] { makeRelief(shape, map, kWhere); }), "");
}

TEST(Relief, NamesTheTexelOfARadiusBelowZero) {
    DisplacedSphere shape = shapeOf();
    const Heightmap map = makeHeightmap(rawOf(4, 3, {0, 0, 0, 0, 0, 0, -3, 0, 0, -2, 0, 0}), shape);
    const std::string message = messageOf(ExitCode::InvalidInput, [&] { makeRelief(shape, map, kWhere); });
    EXPECT_TRUE(holds(message, "planet.pbrt:7:3"));
    EXPECT_TRUE(holds(message, "radius is -1 "));
    EXPECT_TRUE(holds(message, "column 2, row 1 (latitude 0, longitude 45 degrees)"));
}

TEST(Relief, NamesTheNodeOfAGridlineMap) {
    DisplacedSphere shape = gridlineShape();
    shape.longitude_origin = 0.0;
    shape.max_displacement = -50.0;
    const Heightmap map =
        makeHeightmap(rawOf(4, 5, {0, 0, 0, 0, 0, 0, 0, 2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}), shape);
    const std::string message = messageOf(ExitCode::InvalidInput, [&] { makeRelief(shape, map, kWhere); });
    EXPECT_TRUE(holds(message, "radius is 0 "));
    EXPECT_TRUE(holds(message, "column 3, row 1 (latitude 45, longitude 270 degrees)"));
}

TEST(Relief, RefusesARadiusThatIsNotFinite) {
    DisplacedSphere shape = shapeOf();
    shape.height_scale = 1e300;
    const Heightmap map = makeHeightmap(rawOf(2, 1, {0, 3e38f}), shape);
    const std::string message = messageOf(ExitCode::InvalidInput, [&] { makeRelief(shape, map, kWhere); });
    EXPECT_TRUE(holds(message, "radius is inf at column 1, row 0"));
}

TEST(Heightmap, ASingleTexelIsASphere) {
    const DisplacedSphere shape = shapeOf();
    const Heightmap map = makeHeightmap(rawOf(1, 1, {0.5f}), shape);
    EXPECT_EQ(map.stored(map.north_pole), 0.5);
    EXPECT_EQ(map.stored(map.south_pole), 0.5);
    const Relief relief = makeRelief(shape, map, kWhere);
    EXPECT_DOUBLE_EQ(relief.least_radius, 2.5);
    EXPECT_DOUBLE_EQ(relief.greatest_radius, 2.5);
}

}  // namespace
}  // namespace dsphere::test
