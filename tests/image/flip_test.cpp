// FLIP against what its definition says of plain pictures.

#include "image/flip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dsphere::test {
namespace {

Image plain(int width, int height, float r, float g, float b) {
    Image image;
    image.data = image.display = {0, 0, width, height};
    const float colour[] = {r, g, b};
    const char* const names[] = {"R", "G", "B"};
    for (int c = 0; c < 3; ++c) std::ranges::fill(image.addFloat(names[c]).floats(), colour[c]);
    return image;
}

/// A square of grey `level` in the middle of darker grey.
Image square(float level) {
    Image image = plain(48, 32, 0.2f, 0.2f, 0.2f);
    for (Channel& channel : image.channels)
        for (int y = 12; y < 20; ++y)
            for (int x = 20; x < 28; ++x) channel.floats()[std::size_t(y * 48 + x)] = level;
    return image;
}

double mean(const std::vector<float>& values) {
    double sum = 0.0;
    for (float value : values) sum += double(value);
    return sum / double(values.size());
}

TEST(Flip, EqualPicturesDifferByNothing) {
    for (float value : flip(square(0.7f), square(0.7f))) EXPECT_EQ(value, 0.0f);
}

// The two colours between which the paper spans its range.
TEST(Flip, GreenAgainstBlueIsOne) {
    for (float value : flip(plain(24, 24, 0, 1, 0), plain(24, 24, 0, 0, 1))) EXPECT_NEAR(value, 1.0f, 1e-6f);
}

// By hand: L* differs by 100, so HyAB^0.7 is 25.119 of the greatest, green against blue, 41.27: past the knee at 0.4.
TEST(Flip, BlackAgainstWhite) {
    for (float value : flip(plain(24, 24, 0, 0, 0), plain(24, 24, 1, 1, 1))) EXPECT_NEAR(value, 0.9674f, 2e-4f);
}

TEST(Flip, IsSymmetricAndInRange) {
    const std::vector<float> there = flip(square(0.7f), square(0.3f)), back = flip(square(0.3f), square(0.7f));
    EXPECT_EQ(there, back);
    for (float value : there) EXPECT_TRUE(value >= 0.0f && value <= 1.0f) << value;
}

TEST(Flip, GrowsWithTheDifferenceAndLiesWhereItIs) {
    const std::vector<float> small = flip(square(0.2f), square(0.25f)), great = flip(square(0.2f), square(0.6f));
    EXPECT_GT(mean(small), 0.0);
    EXPECT_GT(mean(great), mean(small));
    EXPECT_GT(great[16 * 48 + 24], 0.3f);
    EXPECT_EQ(great[0], 0.0f);  // beyond the reach of all filters
}

// From farther away a pixel is a smaller part of a degree, and a fine pattern melts into grey.
TEST(Flip, FinePatternsVanishFromFarAway) {
    Image pattern = plain(64, 64, 0, 0, 0);
    for (Channel& channel : pattern.channels)
        for (std::size_t k = 0; k < channel.floats().size(); ++k) channel.floats()[k] = float((k + k / 64) % 2);
    const Image grey = plain(64, 64, 0.5f, 0.5f, 0.5f);
    EXPECT_LT(mean(flip(grey, pattern, 200.0)), 0.5 * mean(flip(grey, pattern, 20.0)));
}

TEST(Flip, ClampsAndTakesNaNForBlack) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
    const std::vector<float> value = flip(plain(16, 16, nan, -3, nan), plain(16, 16, infinity, 1, 2));
    EXPECT_EQ(value, flip(plain(16, 16, 0, 0, 0), plain(16, 16, 1, 1, 1)));
}

TEST(Flip, PicturesOfOnePixel) {
    EXPECT_NEAR(flip(plain(1, 1, 0, 1, 0), plain(1, 1, 0, 0, 1))[0], 1.0f, 1e-6f);
}

}  // namespace
}  // namespace dsphere::test
