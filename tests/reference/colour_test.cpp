// Colours of images, worked out by hand: where row and column 0 lie on each shape, what is between texels, and poles.

#include "reference/colour.h"
#include "tests/support/testcolours.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dsphere::reference::test {
namespace {

// Red is 10 i + j / 10 in units of 1/100: column and row can be read from it. 4x2 texels of 90 degrees.
ColourMap numbered() {
    std::vector<float> light;
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 4; ++i) light.insert(light.end(), {float(0.1 * i + 0.01 * j), 0.5f, 0.0f});
    return ColourMap(dsphere::test::lightOf(4, 2, light), "numbered");
}

double redAt(const Geometry& geometry, const dvec3& p, double scale = 1.0, double longitude_origin = -180.0) {
    Shape shape;
    shape.geometry = geometry;
    return imageColour(shape, {"numbered", dvec3(scale), longitude_origin, {}}, numbered(), p).r;
}

dvec3 at(double longitude, double latitude) {
    const double lon = glm::radians(longitude), lat = glm::radians(latitude);
    return {std::cos(lat) * std::sin(lon), std::sin(lat), std::cos(lat) * std::cos(lon)};
}

constexpr double kClose = 1e-7;  // the texels are floats

// Column centres at -135, -45, 45 and 135 degrees, row centres at 45 and -45.
TEST(ImageColour, OnAPlanetRowZeroIsNorthAndColumnZeroWest) {
    const DisplacedSphere planet;
    EXPECT_NEAR(redAt(planet, at(-135, 45)), 0.00, kClose);
    EXPECT_NEAR(redAt(planet, at(-45, 45)), 0.10, kClose);
    EXPECT_NEAR(redAt(planet, at(45, 45)), 0.20, kClose);
    EXPECT_NEAR(redAt(planet, at(135, -45)), 0.31, kClose);
    EXPECT_NEAR(redAt(planet, 7.0 * at(45, -45)), 0.21, kClose);
}

TEST(ImageColour, IsBilinearAndWrapsAround) {
    const DisplacedSphere planet;
    EXPECT_NEAR(redAt(planet, at(0, 0)), 0.155, kClose) << "the mean of columns 1 and 2, rows 0 and 1";
    EXPECT_NEAR(redAt(planet, at(22.5, 22.5)), 0.1775, kClose) << "3/4 of column 2, 1/4 of row 1";
    EXPECT_NEAR(redAt(planet, at(180, 45)), 0.15, kClose) << "half-way from column 3 to column 0";
    EXPECT_NEAR(redAt(planet, at(-157.5, 45)), 0.075, kClose) << "3/4 of column 0, 1/4 of column 3";
}

// The rows' means are 0.15 and 0.16.
TEST(ImageColour, APlanetsPolesAreTheMeansOfTheirRows) {
    const DisplacedSphere planet;
    EXPECT_NEAR(redAt(planet, {0, 1, 0}), 0.15, kClose);
    EXPECT_NEAR(redAt(planet, {0, -1, 0}), 0.16, kClose);
    EXPECT_NEAR(redAt(planet, at(135, 67.5)), 0.225, kClose) << "half-way from 0.3 to the pole";
    EXPECT_NEAR(redAt(planet, at(-135, -78.75)), 0.1225, kClose) << "3/4 of the way from 0.01 to the pole";
}

// At longitude 0 the image's left edge: column 0 is centred at 45 degrees.
TEST(ImageColour, LongitudeOriginIsTheImagesOwn) {
    DisplacedSphere planet;
    EXPECT_NEAR(redAt(planet, at(45, 45), 1.0, 0.0), 0.0, kClose);
    EXPECT_NEAR(redAt(planet, at(-135, 45), 1.0, 0.0), 0.2, kClose);
    EXPECT_NEAR(redAt(planet, at(-105, 45), 1.0, -150.0), 0.0, kClose);
    planet.longitude_origin = 0.0;  // of the heights
    EXPECT_NEAR(redAt(planet, at(-135, 45)), 0.0, kClose);
}

// u runs counterclockwise about +z from +x: column centres at 45, 135, 225 and 315 degrees. Row 0 is at +z.
TEST(ImageColour, SpheresKeepPbrtsCoordinates) {
    const double s = std::sqrt(0.5);
    const Sphere sphere;
    EXPECT_NEAR(redAt(sphere, {s * s, s * s, s}), 0.00, kClose);
    EXPECT_NEAR(redAt(sphere, {-s * s, s * s, s}), 0.10, kClose);
    EXPECT_NEAR(redAt(sphere, {s * s, -s * s, -s}), 0.31, kClose);
    EXPECT_NEAR(redAt(sphere, {1, 0, 0}), 0.155, kClose) << "columns 3 and 0, rows 0 and 1";
    EXPECT_NEAR(redAt(sphere, {0, 0, 1}), 0.155, kClose) << "repeated: beyond row 0 lies row 1; at +x";
}

// From the inner edge, row 0, to the outer one.
TEST(ImageColour, DisksKeepPbrtsCoordinates) {
    const double s = std::sqrt(0.5);
    const Disk disk{.height = 3.0, .radius = 5.0, .inner_radius = 1.0};
    EXPECT_NEAR(redAt(disk, {2 * s, 2 * s, 3}), 0.00, kClose) << "row 0 is centred 2 from the axis";
    EXPECT_NEAR(redAt(disk, {-4 * s, -4 * s, 3}), 0.21, kClose) << "row 1 is centred 4 from the axis";
    EXPECT_NEAR(redAt(disk, {3 * s, -3 * s, 3}), 0.305, kClose);
    EXPECT_NEAR(redAt(disk, {5 * s, 5 * s, 3}), 0.005, kClose) << "repeated: beyond row 1 lies row 0";
}

TEST(ImageColour, TheScaledColourIsCutToOne) {
    EXPECT_NEAR(redAt(DisplacedSphere{}, at(45, 45), 3.0), 0.6, kClose);
    EXPECT_EQ(redAt(DisplacedSphere{}, at(135, 45), 9.0), 1.0);
    EXPECT_EQ(redAt(DisplacedSphere{}, at(135, 45), 0.0), 0.0);
}

TEST(ColourMap, CodesAreDecoded) {
    RawColour raw;
    raw.width = 2;
    raw.height = 1;
    raw.srgb = {0, 255, 188, 255, 0, 0};
    const ColourMap image(raw, "codes");
    EXPECT_EQ(image.texel(0, 0).r, 0.0);
    EXPECT_EQ(image.texel(0, 0).g, 1.0);
    EXPECT_NEAR(image.texel(0, 0).b, 0.5028864580325687, 1e-15) << "((188 / 255 + 0.055) / 1.055)^2.4";
    EXPECT_EQ(image.north(), dvec3(0.5, 0.5, 0.5 * image.texel(0, 0).b));
}

}  // namespace
}  // namespace dsphere::reference::test
