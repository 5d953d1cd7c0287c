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

}  // namespace
}  // namespace dsphere::test
