// The sequences of docs/light.md: their first numbers, worked out apart from the program, the stratification that
// Owen's scrambling must leave as it is, and that no two sequences have to do with each other.

#include "reference/sampler.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

namespace dsphere::reference::test {
namespace {

std::vector<dvec2> firstPoints(SampleSource source, std::uint32_t pair, std::uint32_t count) {
    std::vector<dvec2> points;
    for (source.index = 0; source.index < count; ++source.index) points.push_back(source.pair(pair));
    return points;
}

// Every box 2^-a x 2^-(m - a) about multiples of its sides holds one of the first 2^m points.
TEST(Sampler, EachPowerOfTwoIsANet) {
    for (std::uint32_t pair : {0u, 1u, 65u, 4u})
        for (std::uint32_t pixel = 0; pixel < 5; ++pixel)
            for (int m = 0; m <= 10; ++m) {
                const auto points = firstPoints({pixel, 3 * pixel + 1, 7, 0}, pair, 1u << m);
                for (int a = 0; a <= m; ++a) {
                    std::set<std::pair<int, int>> boxes;
                    for (const dvec2& p : points) boxes.emplace(int(std::ldexp(p.x, a)), int(std::ldexp(p.y, m - a)));
                    ASSERT_EQ(boxes.size(), points.size()) << "pair " << pair << ", 2^" << m << " points, a = " << a;
                }
            }
}

// Also later ones: any 2^m points from a multiple of 2^m on.
TEST(Sampler, LaterPowersOfTwoAreNetsToo) {
    SampleSource source{11, 5, 0, 0};
    std::set<int> columns, rows;
    for (source.index = 768; source.index < 1024; ++source.index) {
        columns.insert(int(256.0 * source.pair(0).x));
        rows.insert(int(256.0 * source.pair(0).y));
    }
    EXPECT_EQ(columns.size(), 256u);
    EXPECT_EQ(rows.size(), 256u);
}

// Two sequences' numbers are as uncorrelated as 1024 independent ones: |r| < 4.5 / 32 fails once in 10^5.
TEST(Sampler, SequencesAreIndependent) {
    const SampleSource one{100, 200, 1, 0};
    const std::vector<std::pair<SampleSource, std::uint32_t>> others = {{one, 1},
                                                                        {one, 2},
                                                                        {one, 65},
                                                                        {{101, 200, 1, 0}, 0},
                                                                        {{100, 201, 1, 0}, 0},
                                                                        {{200, 100, 1, 0}, 0},
                                                                        {{100, 200, 2, 0}, 0},
                                                                        {{0, 0, 0, 0}, 0}};
    const auto a = firstPoints(one, 0, 1024);
    auto correlation = [&](auto first, auto second) {
        double sum = 0.0;
        for (std::size_t k = 0; k < a.size(); ++k) sum += (first(k) - 0.5) * (second(k) - 0.5);
        return 12.0 * sum / double(a.size());
    };
    for (const auto& [source, pair] : others) {
        const auto b = firstPoints(source, pair, 1024);
        for (int c = 0; c < 2; ++c)
            for (int d = 0; d < 2; ++d)
                EXPECT_LT(std::abs(correlation([&](auto k) { return a[k][c]; }, [&](auto k) { return b[k][d]; })), 0.14)
                    << source.x << ' ' << source.y << ' ' << source.seed << ' ' << pair;
    }
    EXPECT_LT(std::abs(correlation([&](auto k) { return a[k].x; }, [&](auto k) { return a[k].y; })), 0.14);
}

// The first number of 65,536 pixels is uniform: chi-squared over 64 x 64 boxes, 5 standard deviations.
TEST(Sampler, PixelsAreUniform) {
    std::vector<int> boxes(64 * 64);
    for (std::uint32_t y = 0; y < 256; ++y)
        for (std::uint32_t x = 0; x < 256; ++x) {
            const dvec2 u = SampleSource{x, y, 0, 0}.pair(4);
            ASSERT_TRUE(u.x >= 0.0 && u.x < 1.0 && u.y >= 0.0 && u.y < 1.0);
            ++boxes[std::size_t(64.0 * u.y) * 64 + std::size_t(64.0 * u.x)];
        }
    double chi2 = 0.0;
    for (int count : boxes) chi2 += (count - 16.0) * (count - 16.0) / 16.0;
    EXPECT_NEAR(chi2, 4095.0, 5.0 * std::sqrt(2.0 * 4095.0));
}

// From a program of its own, in another language.
TEST(Sampler, FirstNumbers) {
    auto expect = [](const SampleSource& source, std::uint32_t pair, double first, double second) {
        EXPECT_EQ(std::ldexp(source.pair(pair).x, 24), first);
        EXPECT_EQ(std::ldexp(source.pair(pair).y, 24), second);
    };
    expect({0, 0, 0u, 0u}, 0u, 183779, 11208193);
    expect({0, 0, 0u, 1u}, 0u, 10980176, 3520182);
    expect({5, 3, 0u, 2u}, 1u, 5097610, 5057943);
    expect({1279, 719, 42u, 63u}, 68u, 14105446, 12690169);
    expect({5, 3, 4294967295u, 4000000000u}, 4294967295u, 2081161, 5791098);
}

}  // namespace
}  // namespace dsphere::reference::test
