#include "reference/sampler.h"
#include "tests/shaders/cpp_shaders.h"

#include <gtest/gtest.h>

#include <array>

namespace dsphere::test {
namespace {

TEST(Samples, LieInThePixelAndFillItEvenly) {
    constexpr int kSide = 8, kSamples = 1024;
    std::array<int, kSide * kSide> counts{};
    for (int k = 0; k < kSamples; ++k) {
        glsl32::vec2 p = glsl32::samplePosition(17, 42, k, 7u) + glsl32::vec2(0.5f);
        ASSERT_GE(std::min(p.x, p.y), 0.0f);
        ASSERT_LT(std::max(p.x, p.y), 1.0f);
        ++counts[std::size_t(int(p.y * kSide) * kSide + int(p.x * kSide))];
    }
    for (int count : counts) EXPECT_NEAR(count, kSamples / (kSide * kSide), 4);
}

TEST(Samples, DependOnSeedAndPixel) {
    glsl32::vec2 a = glsl32::samplePosition(3, 4, 0, 1u);
    EXPECT_EQ(a, glsl32::samplePosition(3, 4, 0, 1u));
    EXPECT_NE(a, glsl32::samplePosition(3, 4, 0, 2u));
    EXPECT_NE(a, glsl32::samplePosition(4, 3, 0, 1u));
}

TEST(Samples, AreTheReferencesBitForBit) {
    for (std::uint32_t k = 0; k < 4096; ++k) {
        const reference::SampleSource source{37 * k % 1009, 11 * k % 719, k % 5, k};
        const std::uint32_t pair = k % 200;
        const dvec2 expected = source.pair(pair);
        const std::uint32_t key = glsl32::pixelKey(int(source.x), int(source.y), source.seed);
        const glsl32::vec2 found = glsl32::samplePoint(key, int(k), pair);
        ASSERT_EQ(double(found.x), expected.x) << k;
        ASSERT_EQ(double(found.y), expected.y) << k;
    }
}

}  // namespace
}  // namespace dsphere::test
