#include "report/statistics.h"

#include <gtest/gtest.h>

namespace dsphere::report {
namespace {

TEST(Statistics, SpreadOfOddAndEvenCounts) {
    Spread odd = spreadOf({3.0, 1.0, 2.0});
    EXPECT_EQ(odd.median, 2.0);
    EXPECT_EQ(odd.least, 1.0);
    EXPECT_EQ(odd.greatest, 3.0);
    EXPECT_EQ(odd.count, 3);
    EXPECT_EQ(spreadOf({4.0, 1.0, 2.0, 3.0}).median, 2.5);
}

TEST(Statistics, NothingIsNotMeasured) {
    EXPECT_FALSE(spreadOf({}).measured());
    EXPECT_FALSE(ratesOf(10.0, {}).measured());
}

TEST(Statistics, RatesTurnTimesAround) {
    Spread rates = ratesOf(10.0, {1.0, 2.0, 5.0});
    EXPECT_EQ(rates.median, 5.0);
    EXPECT_EQ(rates.least, 2.0);
    EXPECT_EQ(rates.greatest, 10.0);
}

// A difference of two times can come out negative on a noisy machine: no rate is infinite or negative, and leaving the
// quickest out would make the median slower than it is.
TEST(Statistics, TimesThatNoiseSwallowedAreTheQuickest) {
    Spread rates = ratesOf(10.0, {-1.0, 0.0, 2.0, 5.0, 10.0});
    EXPECT_EQ(rates.count, 5);
    EXPECT_EQ(rates.greatest, 5.0);
    EXPECT_EQ(rates.median, 5.0);
    EXPECT_EQ(rates.least, 1.0);
    EXPECT_FALSE(ratesOf(10.0, {-1.0, 0.0}).measured());
}

}  // namespace
}  // namespace dsphere::report
