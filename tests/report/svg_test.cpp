#include "report/plot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace dsphere::report {
namespace {

TEST(LogScale, EndsAndMiddle) {
    LogScale scale{1.0, 100.0, 0.0, 200.0};
    EXPECT_DOUBLE_EQ(scale.at(1.0), 0.0);
    EXPECT_DOUBLE_EQ(scale.at(10.0), 100.0);
    EXPECT_DOUBLE_EQ(scale.at(100.0), 200.0);
}

TEST(LogScale, HoldsEveryValue) {
    for (const std::vector<double>& values : {std::vector<double>{5.0},
                                              {1e-8, 1e-3},
                                              {0.0, -1.0, 3.0},
                                              {},
                                              {std::numeric_limits<double>::infinity(), 2.0}}) {
        LogScale scale = logScale(values, 10.0, 20.0);
        EXPECT_GT(scale.low, 0.0);
        EXPECT_GE(scale.high / scale.low, 10.0 * (1.0 - 1e-9));
        for (double value : values) {
            if (!(value > 0.0) || !std::isfinite(value)) continue;
            EXPECT_GT(scale.at(value), 10.0);
            EXPECT_LT(scale.at(value), 20.0);
        }
        EXPECT_FALSE(logTicks(scale).empty());
    }
}

TEST(LogTicks, LieInsideAndGrow) {
    for (double high : {12.0, 80.0, 1e4, 1e9}) {
        LogScale scale{1.1, high, 0.0, 1.0};
        std::vector<double> ticks = logTicks(scale);
        ASSERT_FALSE(ticks.empty());
        for (std::size_t k = 0; k < ticks.size(); ++k) {
            EXPECT_GE(ticks[k], scale.low);
            EXPECT_LE(ticks[k], scale.high);
            EXPECT_GT(ticks[k], k > 0 ? ticks[k - 1] : 0.0);
        }
    }
}

TEST(TickLabel, PlainNearOneAndPowersAfar) {
    EXPECT_EQ(tickLabel(1.0), "1");
    EXPECT_EQ(tickLabel(0.05), "0.05");
    EXPECT_EQ(tickLabel(8192.0), "8192");
    EXPECT_NE(tickLabel(1e-6).find(">\xE2\x88\x92"
                                   "6<"),
              std::string::npos)
        << tickLabel(1e-6);
    EXPECT_EQ(tickLabel(2e-5).rfind("2·10", 0), 0u) << tickLabel(2e-5);
}

TEST(EscapeXml, EveryCharacterThatMatters) {
    EXPECT_EQ(escapeXml("a<b> & \"c\""), "a&lt;b&gt; &amp; &quot;c&quot;");
}

}  // namespace
}  // namespace dsphere::report
