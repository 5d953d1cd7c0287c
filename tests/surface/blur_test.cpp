#include "surface/blur.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "surface/heightmap.h"

namespace dsphere::test {
namespace {

std::vector<float> blurred(std::vector<float> samples, int width, int height, double sigma) {
    blurMap(samples, width, height, sigma);
    return samples;
}

void expectNear(const std::vector<float>& read, const std::vector<double>& expected) {
    ASSERT_EQ(read.size(), expected.size());
    for (std::size_t k = 0; k < read.size(); ++k) EXPECT_NEAR(read[k], expected[k], 2e-7 * std::abs(expected[k])) << k;
}

// sigma = 1/3 reaches one texel: exp(-4.5) = 0.011108996538242306 on each side of 1, so that
constexpr double kSide = 0.010867541574775536, kMiddle = 0.978264916850449;  // sum to 1

TEST(Blur, SpreadsAPointAndWraps) {
    const double c = kMiddle * kMiddle, e = kMiddle * kSide, d = kSide * kSide;
    expectNear(blurred({0, 0, 0, 0, 0,  //
                        1, 0, 0, 0, 0,  //
                        0, 0, 0, 0, 0},
                       5, 3, 1.0 / 3.0),
               {e, d, 0, 0, d,  //
                c, e, 0, 0, e,  //
                e, d, 0, 0, d});
}

TEST(Blur, HoldsTheRowsAtThePoles) {
    const double a = kMiddle + kSide, b = kSide;
    expectNear(blurred({1, 1, 1, 1, 1,  //
                        0, 0, 0, 0, 0,  //
                        3, 3, 3, 3, 3},
                       5, 3, 1.0 / 3.0),
               {a, a, a, a, a,                      //
                4 * b, 4 * b, 4 * b, 4 * b, 4 * b,  //
                3 * a, 3 * a, 3 * a, 3 * a, 3 * a});
}

TEST(Blur, EqualValuesStay) {
    for (const double sigma : {1e-300, 0.1, 1.0, 7.3, 1000.0})
        EXPECT_EQ(blurred(std::vector<float>(15, 0.1f), 5, 3, sigma), std::vector<float>(15, 0.1f)) << sigma;
}

TEST(Blur, TheLeastOfSigmasChangesNothing) {
    const std::vector<float> samples{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15};
    EXPECT_EQ(blurred(samples, 5, 3, 1e-300), samples);
    EXPECT_EQ(blurred(samples, 5, 3, 5e-324), samples);
}

/// The definition, term by term.
double blurredAt(const std::vector<float>& samples, int width, int height, double sigma, int i, int j) {
    const int radius = int(std::ceil(3.0 * sigma));
    double sum = 0.0, weights = 0.0;
    for (int dj = -radius; dj <= radius; ++dj)
        for (int di = -radius; di <= radius; ++di) {
            const double weight = std::exp(-0.5 * (di * di + dj * dj) / (sigma * sigma));
            const int column = ((i + di) % width + width) % width, row = std::clamp(j + dj, 0, height - 1);
            sum += weight * double(samples[std::size_t(row * width + column)]);
            weights += weight;
        }
    return sum / weights;
}

TEST(Blur, IsTheDefinition) {
    std::mt19937 random(5);
    for (const auto& [width, height, sigma] :
         {std::tuple{5, 3, 2.0}, {1, 1, 3.0}, {33, 17, 1.3}, {16, 40, 0.7}, {50, 2, 5.5}}) {
        std::vector<float> samples(std::size_t(width * height));
        for (float& sample : samples) sample = 1.0f + float(random() % 1000) / 1000.0f;
        const std::vector<float> result = blurred(samples, width, height, sigma);
        for (int j = 0; j < height; ++j)
            for (int i = 0; i < width; ++i)
                EXPECT_NEAR(result[std::size_t(j * width + i)], blurredAt(samples, width, height, sigma, i, j), 4e-7)
                    << width << "x" << height << " at " << i << ", " << j;
    }
}

TEST(Blur, ComesAfterTheFillAndBeforeThePoles) {
    RawMap raw;
    raw.width = 1;
    raw.height = 3;
    raw.samples = {1, -9999, 4};  // filled: 1 1 4
    DisplacedSphere shape;
    shape.nodata = -9999.0;
    shape.blur = 1.0 / 3.0;
    const Heightmap map = makeHeightmap(raw, shape);
    expectNear(map.samples, {1.0, 1.0 + 3.0 * kSide, 4.0 - 3.0 * kSide});
    EXPECT_EQ(map.south_pole, map.samples[2]);
    EXPECT_EQ(map.greatest, map.samples[2]);
}

}  // namespace
}  // namespace dsphere::test
