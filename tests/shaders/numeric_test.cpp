#include "tests/shaders/cpp_shaders.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace dsphere::test {
namespace {

double ulpsApart(float value, double truth) {
    float nearest = float(truth);
    double ulp = double(std::nextafter(std::abs(nearest), 10.0f)) - std::abs(nearest);
    return std::abs(double(value) - truth) / ulp;
}

TEST(Numeric, Atan2IsWithinFourUlpAllRound) {
    double worst = 0.0;
    for (int k = 0; k < 100000; ++k) {
        double angle = (k + 0.5) / 100000.0 * 2.0 * M_PI - M_PI;
        float y = float(std::sin(angle)), x = float(std::cos(angle));
        worst = std::max(worst, ulpsApart(glsl32::atan2Precise(y, x), std::atan2(double(y), double(x))));
    }
    EXPECT_LE(worst, 4.0);
}

TEST(Numeric, Atan2OnTheAxes) {
    EXPECT_EQ(glsl32::atan2Precise(0.0f, 1.0f), 0.0f);
    EXPECT_FLOAT_EQ(glsl32::atan2Precise(1.0f, 0.0f), float(M_PI / 2));
    EXPECT_FLOAT_EQ(glsl32::atan2Precise(-1.0f, 0.0f), float(-M_PI / 2));
    EXPECT_FLOAT_EQ(glsl32::atan2Precise(0.0f, -1.0f), float(M_PI));
    EXPECT_EQ(glsl32::atan2Precise(0.0f, 0.0f), 0.0f);
}

TEST(Numeric, AtanSmallServesTheWidestCell) {
    double widest = std::tan(2.0 * M_PI / 512.0);
    for (int k = 0; k <= 1000; ++k) {
        float q = float(widest * k / 1000.0);
        EXPECT_LE(ulpsApart(glsl32::atanSmall(q), std::atan(double(q))), 2.0) << q;
    }
}

TEST(Numeric, FirstRootIsTheFirstPositiveOne) {
    EXPECT_FLOAT_EQ(glsl32::firstRoot(6.0f, -5.0f, 1.0f), 2.0f);    // (t - 2)(t - 3)
    EXPECT_FLOAT_EQ(glsl32::firstRoot(6.0f, 1.0f, -1.0f), 3.0f);    // -(t - 3)(t + 2)
    EXPECT_FLOAT_EQ(glsl32::firstRoot(1.0f, -2.0f, 0.0f), 0.5f);    // a line
    EXPECT_EQ(glsl32::firstRoot(0.0f, -1.0f, 3.0f), 0.0f);          // starts on the surface, going in
    EXPECT_FLOAT_EQ(glsl32::firstRoot(1e-8f, -1.0f, 1.0f), 1e-8f);  // no cancellation for a near root
    EXPECT_FLOAT_EQ(glsl32::firstRoot(1.0f, -2.0f, 1.0f), 1.0f);    // double root
    EXPECT_FLOAT_EQ(glsl32::firstRoot(-1.0f, 3.0f, -2.0f), 1.0f);   // -(2t - 1)(t - 1): rises from below 0 first
}

TEST(Numeric, ExactSumLosesNothing) {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> value(-1.0f, 1.0f);
    for (int k = 0; k < 10000; ++k) {
        float a = value(random), b = value(random) * 1e-3f;
        glsl32::Pair sum = glsl32::exactSum(a, b, 0.0f);
        EXPECT_EQ(double(sum.hi) + double(sum.lo), double(a) + double(b));
    }
}

TEST(Numeric, TurnPairKeepsTheSmallCoordinate) {
    std::mt19937 random(2);
    std::uniform_real_distribution<double> turn(0.0, 2.0 * M_PI), offset(-0.012, 0.012);
    double worst = 0.0;
    for (int k = 0; k < 20000; ++k) {
        double angle = turn(random), beyond = offset(random);
        double a = std::sin(angle + beyond), b = std::cos(angle + beyond);
        double sine = std::sin(angle), cosine = std::cos(angle);
        float s1 = glsl32::leadingBits(float(sine)), c1 = glsl32::leadingBits(float(cosine));
        glsl32::vec4 edge(s1, c1, float(sine - s1), float(cosine - c1));
        glsl32::Pair pa{float(a), float(a - double(float(a)))}, pb{float(b), float(b - double(float(b)))};
        glsl32::Rotated turned = glsl32::rotatePair(pa, pb, edge);
        worst = std::max(worst, std::abs(double(turned.first) - std::sin(beyond)));
        worst = std::max(worst, std::abs(double(turned.second.hi) + double(turned.second.lo) - std::cos(beyond)));
    }
    EXPECT_LE(worst, 2e-9);  // plain float: 1e-7
}

// For films up to the widest, 2^20 pixels. Plain float: 6e-8.
TEST(Numeric, PairLinearIsExactForPixelCounts) {
    const auto pair = [](double v) { return glsl32::Pair{float(v), float(v - double(float(v)))}; };
    for (const int width : {4000, 100'000, 1 << 20}) {
        const double base = 0.123456789012, step_x = -1.23456789 / width, step_y = 0.987654321 / width;
        double worst = 0.0;
        for (int x = -width; x <= width; x += width / 1000 + 1) {
            const int y = (x - width) / 3;
            const glsl32::Pair sum = glsl32::pairLinear(pair(base), float(x), pair(step_x), float(y), pair(step_y));
            worst = std::max(worst, std::abs(double(sum.hi) + double(sum.lo) - (base + x * step_x + y * step_y)));
            EXPECT_EQ(sum.hi, float(double(sum.hi) + sum.lo));
        }
        EXPECT_LE(worst, 1e-10) << width;
    }
}

}  // namespace
}  // namespace dsphere::test
