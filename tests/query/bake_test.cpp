// Maps of what holds at the surface, against closed forms and the reference.

#include "query/bake.h"
#include "query/geography.h"
#include "reference/tracer.h"
#include "tests/query/fixture.h"
#include "tests/support/expecterror.h"
#include "verify/nearby.h"

#include <cmath>
#include <random>

namespace dsphere::query {
namespace {

class Bake : public QueryTest {
  protected:
    Baker baker(const World& world, const BakeGrid& grid) {
        return {device_, world.scene, world.maps, world.packed, world.on_device, grid, none_};
    }
    // Texels of a map of that size.
    static BakeGrid ownGrid(int width, int height) { return {.width = width, .height = height}; }

  private:
    Progress none_;
};

TEST_F(Bake, AFlatSphere) {
    const World flat = world("Shape \"displacedsphere\" \"float radius\" 3\n");
    Baker baker = this->baker(flat, ownGrid(16, 8));
    const BakeGrid grid = ownGrid(16, 8);
    const std::vector<float> sky = baker.sky(100), slope = baker.slope(), aspect = baker.aspect();
    const std::vector<float> horizon = baker.horizon(30.0, 0.01), x = baker.normal(0), y = baker.normal(1);
    for (std::size_t k = 0; k < grid.count(); ++k) {
        const double lat = glm::radians(grid.latitude(int(k / 16))), lon = glm::radians(grid.longitude(int(k % 16)));
        EXPECT_NEAR(sky[k], 1.0f, 1e-5f);
        EXPECT_EQ(slope[k], 0.0f);
        EXPECT_TRUE(std::isnan(aspect[k]));
        EXPECT_NEAR(y[k], std::sin(lat), 1e-7);
        EXPECT_NEAR(x[k], std::cos(lat) * std::sin(lon), 1e-7);
        // 1e-6 R above the ground the horizon stands 0.081 degrees low; a hair of 1e-6 R is excused.
        EXPECT_GT(horizon[k], -0.115f - 0.01f);
        EXPECT_LT(horizon[k], 0.0f + 0.01f);
    }
    const std::vector<float> lit = baker.lit({.longitude = 90.0, .latitude = 0.0}, 1);
    for (std::size_t k = 0; k < grid.count(); ++k) EXPECT_EQ(lit[k], x[k] > 0.0f ? 1.0f : 0.0f) << k;
}

// One meridian of texels is high: seen along the equator, the crest is the horizon.
TEST_F(Bake, ARidgesHorizonIsItsClosedForm) {
    constexpr int kWidth = 720, kHeight = 361, kCrest = 400;
    RawMap raw = test::constantMap(kWidth, kHeight, 0.0f);
    for (int j = 0; j < kHeight; ++j) raw.samples[std::size_t(j * kWidth + kCrest)] = 65535.0f;
    test::writePgm16(folder_.path() / "ridge.pgm", raw);
    const World ridge = world(planet("\"float maxdispl\" 1", "ridge.pgm"));
    constexpr double kBound = 0.001;
    Baker baker = this->baker(ridge, ownGrid(kWidth, kHeight));
    const std::vector<float> east = baker.horizon(90.0, kBound), west = baker.horizon(270.0, kBound);
    const std::size_t row = std::size_t(kHeight / 2) * kWidth;  // its centre is the equator
    for (int away : {2, 5, 9, 14}) {
        const double angle = glm::radians(0.5 * away), crest = 1.01;
        const double truth = glm::degrees(std::atan2(crest * std::cos(angle) - 1.0, crest * std::sin(angle)));
        // The start is 1e-6 R high, which takes off that over the distance.
        const double tolerance = kBound + glm::degrees(2e-6 / angle);
        EXPECT_NEAR(east[row + kCrest - std::size_t(away)], truth, tolerance) << away;
        EXPECT_NEAR(west[row + kCrest + std::size_t(away)], truth, tolerance) << away;
    }
}

TEST_F(Bake, SlopesPointDownhill) {
    RawMap raw = test::constantMap(64, 33, 0.0f);
    for (int j = 0; j < 33; ++j)
        for (int i = 0; i < 64; ++i) raw.samples[std::size_t(j * 64 + i)] = float(1000 * j);
    test::writePgm16(folder_.path() / "south.pgm", raw);
    const World rising = world(planet("\"float maxdispl\" 10", "south.pgm"));
    Baker baker = this->baker(rising, ownGrid(64, 33));
    const std::vector<float> slope = baker.slope(), aspect = baker.aspect(), height = baker.height();
    for (int j = 2; j < 31; ++j) {
        const std::size_t k = std::size_t(j * 64 + 5);
        EXPECT_EQ(height[k], 1000.0f * float(j));
        const double r = 1.0 + 0.1 * 1000.0 * j / 65535.0, rise = 0.1 * 1000.0 / 65535.0 / (kPi / 33.0);
        EXPECT_NEAR(slope[k], glm::degrees(std::atan(rise / r)), 1e-5);
        EXPECT_NEAR(std::remainder(aspect[k], 360.0f), 0.0f, 1e-5f) << "it falls to the north";
    }
}

// Every texel's light is the reference's, but where a move of 1e-6 R changes it.
TEST_F(Bake, LightIsTheReferences) {
    const World planet_world = world(planet("\"float maxdispl\" 5"));
    const BakeGrid grid = ownGrid(256, 128);
    Baker baker = this->baker(planet_world, grid);
    const Sun suns[] = {{.longitude = 40.0, .latitude = 3.0},
                        {.longitude = -130.0, .latitude = -80.0, .distance = 1.5}};
    const SceneMaps& maps = planet_world.maps;
    const reference::Tracer tracer(planet_world.scene, maps.perShape(), maps.reliefs, maps.imagePerShape());
    const reference::Surface& surface = *tracer.surface(0);
    const double unit = maps.reliefs[0].greatest_radius;
    for (const Sun& sun : suns) {
        const std::vector<float> lit = baker.lit(sun, 1);
        const LocalAxes towards(sun.latitude, sun.longitude);
        int different = 0;
        for (std::size_t k = 0; k < grid.count(); k += 3) {
            const LocalAxes axes(grid.latitude(int(k / 256)), grid.longitude(int(k % 256)));
            const dvec3 start = (surface.radius(axes.up) + 1e-6 * unit) * axes.up;
            const dvec3 offset = sun.distance ? *sun.distance * unit * towards.up - start : towards.up;
            const double end = sun.distance ? 1.0 : std::numeric_limits<double>::infinity();
            const auto isLit = [&](const dvec3& from) {
                return tracer.occluded(from, offset, end, 0, from) ? 0.0f : 1.0f;
            };
            if (lit[k] == isLit(start)) continue;
            ++different;
            bool excused = false;
            for (const dvec3& move : verify::ringOffsets(offset, 1e-6 * unit))
                excused = excused || isLit(start + move) == lit[k];
            EXPECT_TRUE(excused) << "texel " << k;
        }
        EXPECT_LE(different, 3);
        EXPECT_GT(std::count(lit.begin(), lit.end(), 1.0f), 5000);
    }
}

// At the terminator of a flat sphere the horizon cuts the disc.
TEST_F(Bake, ADiscIsSeenInPart) {
    const World flat = world("Shape \"displacedsphere\"\n");
    const BakeGrid grid{.width = 9, .height = 1, .west = -94.5, .east = -85.5, .south = -0.5, .north = 0.5};
    const std::vector<float> lit = baker(flat, grid).lit({.longitude = 0.0, .latitude = 0.0, .radius = 3.0}, 400);
    EXPECT_EQ(lit[0], 0.0f);
    EXPECT_NEAR(lit[4], 0.5f, 0.05f);
    EXPECT_NEAR(lit[8], 1.0f, 1e-5f);
    for (std::size_t i = 1; i < lit.size(); ++i) EXPECT_GE(lit[i] + 1e-5f, lit[i - 1]);
    // A segment of a circle, 2 of 3 of its radius away from the middle.
    const double share = 1.0 - (std::acos(2.0 / 3.0) - 2.0 / 3.0 * std::sqrt(1.0 - 4.0 / 9.0)) / kPi;
    EXPECT_NEAR(lit[6], share, 0.03);
}

// Lambert's law on a flat sphere, whose own normal is that of a plane under the sun.
TEST_F(Bake, ColourOfAFlatSphereIsLamberts) {
    const World flat = world("Material \"diffuse\" \"rgb reflectance\" [.5 .25 .125] Shape \"displacedsphere\"\n");
    const BakeGrid grid = ownGrid(24, 12);
    const auto colour = baker(flat, grid).colour(64);
    const dvec3 sun = glm::normalize(dvec3(2.0, 1.0, 0.0));
    for (std::size_t k = 0; k < grid.count(); ++k) {
        const double cosine = glm::dot(LocalAxes(grid.latitude(int(k / 24)), grid.longitude(int(k % 24))).up, sun);
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(colour[c][k], 0.5 / double(1 << c) / kPi * std::max(cosine, 0.0), 2e-4 / double(1 << c)) << k;
    }
}

// A texel's colour is the mean of what the reference shades at its four points, with shadows.
TEST_F(Bake, ColourIsTheReferences) {
    const World hills = world("Material \"diffuse\" \"rgb reflectance\" [.5 .3 .2] " + planet("\"float maxdispl\" 5"));
    const BakeGrid grid = ownGrid(256, 128);
    const auto colour = baker(hills, grid).colour(64);
    const SceneMaps& maps = hills.maps;
    const reference::Tracer tracer(hills.scene, maps.perShape(), maps.reliefs, maps.imagePerShape());
    int dark = 0, different = 0;
    for (std::size_t k = 0; k < grid.count(); k += 7) {
        dvec3 sum(0.0);
        for (const dvec2& side : {dvec2(-0.01, -0.01), {0.01, -0.01}, {-0.01, 0.01}, {0.01, 0.01}}) {
            const dvec3 up =
                LocalAxes(grid.latitude(double(k / 256) + side.y), grid.longitude(double(k % 256) + side.x)).up;
            const reference::WorldHit hit = tracer.firstHit(2.0 * up, -up);
            const reference::ShadingPoint point = tracer.shadingPoint(hit, -up);
            sum += 0.25 * tracer.directLight(point, {}, tracer.litLights(point, {}));
        }
        dark += sum == dvec3(0.0);
        for (std::size_t c = 0; c < 3; ++c) different += std::abs(colour[c][k] - sum[int(c)]) > 1e-4;
    }
    EXPECT_LE(different, 6) << "points whose shadow a move of 1e-6 R changes";
    EXPECT_GT(dark, 1500);
    EXPECT_LT(dark, 3500);
}

// A sky that is white all around lights a convex body's ground fully.
TEST_F(Bake, ColourDrawsSamplesOfASky) {
    const Scene scene = parseScene(
        "WorldBegin LightSource \"infinite\" \"rgb L\" [1 1 1] "
        "Material \"diffuse\" \"rgb reflectance\" [.5 .5 .5] Shape \"displacedsphere\"",
        "test.pbrt", folder_.path());
    const World bright(device_, scene, {});
    const auto colour = baker(bright, ownGrid(12, 6)).colour(256);
    for (const float value : colour[0]) EXPECT_NEAR(value, 0.5f, 0.05f);
}

TEST_F(Bake, WhatCannotBeIsRefused) {
    const World two = world("Shape \"displacedsphere\" Translate 3 0 0 Shape \"sphere\"\n");
    test::expectError(ExitCode::InvalidInput, "2 shapes", [&] { baker(two, ownGrid(4, 2)).horizon(0.0, 0.1); });
    const World none = world("Shape \"sphere\"\n");
    test::expectError(ExitCode::InvalidInput, "needs a displacedsphere", [&] { baker(none, ownGrid(4, 2)); });
}

}  // namespace
}  // namespace dsphere::query
