// What the compiler must not drop: see cmake/Compiler.cmake.

#include "base/math.h"

#include <gtest/gtest.h>

namespace dsphere {
namespace {

/// Not known to the compiler.
volatile double someValues[] = {0.1, 0.2, 0.3};

struct Split {
    dvec3 high{0.0}, low{0.0};
};

[[gnu::noinline]] Split splitOf(const dvec3& v) {
    Split split;
    split.high = dvec3(glm::vec3(v));
    split.low = v - dvec3(glm::vec3(v));
    return split;
}

[[gnu::noinline]] void splitPair(float* __restrict high, float* __restrict low, const double* __restrict from) {
    for (int i = 0; i < 2; ++i) {
        high[i] = float(from[i]);
        low[i] = float(from[i] - double(high[i]));
    }
}

TEST(Rounding, DoublesSideBySideAreRoundedToFloats) {
    const dvec3 v(someValues[0], someValues[1], someValues[2]);
    const Split split = splitOf(v);
    for (int i = 0; i < 3; ++i) {
        EXPECT_NE(split.high[i], v[i]);
        EXPECT_NEAR(split.high[i], v[i], 3e-8);
        EXPECT_NE(split.low[i], 0.0);
    }
    const double from[2] = {someValues[0], someValues[1]};
    float high[2], low[2];
    splitPair(high, low, from);
    for (int i = 0; i < 2; ++i) {
        EXPECT_NE(low[i], 0.0f);
        EXPECT_NEAR(double(high[i]) + double(low[i]), from[i], 1e-15);
    }
}

}  // namespace
}  // namespace dsphere
