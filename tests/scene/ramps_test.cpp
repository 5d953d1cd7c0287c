#include "scene/ramps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace dsphere {
namespace {

double linearFromSrgb(double code) {
    return code <= 0.04045 ? code / 12.92 : std::pow((code + 0.055) / 1.055, 2.4);
}

TEST(Ramps, AreFoundByName) {
    std::vector<std::string_view> names;
    for (const Ramp& ramp : ramps()) names.push_back(ramp.name);
    EXPECT_EQ(names, (std::vector<std::string_view>{"terrain", "viridis", "geoid", "grey"}));
    for (int i = 0; i < int(names.size()); ++i) EXPECT_EQ(findRamp(names[i]), i);
    EXPECT_EQ(findRamp("Terrain"), -1);
    EXPECT_EQ(findRamp(""), -1);
}

TEST(Ramps, ControlPointsAreHitExactlyAndColoursAreReflectances) {
    for (const Ramp& ramp : ramps())
        for (int i = 0; i < kRampPoints; ++i) {
            EXPECT_EQ(rampColour(ramp, i / 16.0), ramp.points[i]) << ramp.name << " " << i;
            for (int c = 0; c < 3; ++c) EXPECT_TRUE(ramp.points[i][c] >= 0.0 && ramp.points[i][c] <= 1.0);
        }
}

TEST(Ramps, AreLinearBetween) {
    for (const Ramp& ramp : ramps())
        for (int i = 0; i + 1 < kRampPoints; ++i) {
            dvec3 quarter = rampColour(ramp, (i + 0.25) / 16.0);
            dvec3 expected = 0.75 * ramp.points[i] + 0.25 * ramp.points[i + 1];
            for (int c = 0; c < 3; ++c) EXPECT_NEAR(quarter[c], expected[c], 1e-15) << ramp.name << " " << i;
        }
}

TEST(Ramps, ClampAndSurviveNaN) {
    constexpr double kInf = std::numeric_limits<double>::infinity();
    for (const Ramp& ramp : ramps()) {
        for (double low : {-1e-300, -0.5, -1e300, -kInf}) EXPECT_EQ(rampColour(ramp, low), ramp.points[0]);
        for (double high : {1.0 + 1e-15, 2.0, 1e300, kInf}) EXPECT_EQ(rampColour(ramp, high), ramp.points[16]);
        EXPECT_EQ(rampColour(ramp, std::numeric_limits<double>::quiet_NaN()), ramp.points[0]);
    }
}

TEST(Ramps, GreyIsTheHeightItself) {
    const Ramp& grey = ramps()[findRamp("grey")];
    for (double x : {0.0, 0.1, 0.37, 0.99, 1.0}) EXPECT_NEAR(rampColour(grey, x).g, x, 1e-15);
}

TEST(Ramps, ViridisIsThePublishedOne) {
    const Ramp& viridis = ramps()[findRamp("viridis")];
    // The published table's first, 64th (of 256, at 63.75 read between two) and last entries, sRGB.
    const std::pair<int, dvec3> published[] = {
        {0, {0.267004, 0.004874, 0.329415}}, {4, {0.230223, 0.321297, 0.545488}}, {16, {0.993248, 0.906157, 0.143936}}};
    for (const auto& [i, srgb] : published)
        for (int c = 0; c < 3; ++c) EXPECT_NEAR(viridis.points[i][c], linearFromSrgb(srgb[c]), 0.005) << i;
}

TEST(Ramps, TerrainIsSeaBelowAndLandAbove) {
    const Ramp& terrain = ramps()[findRamp("terrain")];
    for (double sea : {0.0, 0.2, 0.45}) EXPECT_GT(rampColour(terrain, sea).b, rampColour(terrain, sea).r) << sea;
    for (double land : {0.57, 0.7, 0.85}) EXPECT_LT(rampColour(terrain, land).b, rampColour(terrain, land).g) << land;
    EXPECT_EQ(rampColour(terrain, 1.0), dvec3(1.0));
}

}  // namespace
}  // namespace dsphere
