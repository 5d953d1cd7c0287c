// The device's tables of pixel filters against the reference's kernels.

#include "render/filtertable.h"

#include "reference/pixelfilter.h"
#include "shaders/layout.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace dsphere {
namespace {

using Kind = PixelFilter::Kind;

PixelFilter filterOf(Kind kind, double radius) {
    PixelFilter filter;
    filter.kind = kind;
    filter.radius = dvec2(radius);
    return filter;
}

// The mean of x^power over the filter: by the table, and by the kernel.
double tableMoment(const FilterTable& table, int power) {
    double sum = 0.0;
    for (std::size_t i = 0; i < table.weights.size(); ++i) {
        const double a = table.places[i], b = table.places[i + 1];
        const double mean = (std::pow(b, power + 1) - std::pow(a, power + 1)) / ((power + 1) * (b - a));
        sum += table.weights[i] * mean / FILTER_INTERVALS;
    }
    return sum;
}

double kernelMoment(const PixelFilter& filter, double radius, int power) {
    constexpr int kPieces = 200000;
    double sum = 0.0, all = 0.0;
    for (int i = 0; i < kPieces; ++i) {
        const double x = radius * (2.0 * (i + 0.5) / kPieces - 1.0);
        const double value = reference::filterKernel(filter, radius, x);
        sum += value * std::pow(x, power);
        all += value;
    }
    return sum / all;
}

TEST(FilterTable, HasTheKernelsMoments) {
    for (Kind kind : {Kind::Gaussian, Kind::Triangle, Kind::Mitchell, Kind::Sinc})
        for (double radius : {0.5, 1.0, 2.0, 4.0, 8.0}) {
            SCOPED_TRACE(nameOf(kind) + std::string(" ") + std::to_string(radius));
            // Beyond, its ends hold less than an interval.
            if (kind == Kind::Gaussian && radius > 2.0) continue;
            const PixelFilter filter = filterOf(kind, radius);
            const FilterTable table = filterTable(filter, radius);
            ASSERT_EQ(table.places.size(), std::size_t(FILTER_INTERVALS) + 1);
            ASSERT_EQ(table.weights.size(), std::size_t(FILTER_INTERVALS));
            EXPECT_EQ(table.places.front(), float(-radius));
            EXPECT_EQ(table.places.back(), float(radius));
            EXPECT_TRUE(std::is_sorted(table.places.begin(), table.places.end()));
            for (int power = 0; power <= 4; ++power)
                EXPECT_NEAR(tableMoment(table, power), kernelMoment(filter, radius, power),
                            2e-3 * std::pow(radius, power))
                    << power;
        }
}

TEST(FilterTable, WeighsSignedKernelsAlone) {
    EXPECT_EQ(filterKind(filterOf(Kind::Box, 1.0)), FILTER_BOX);
    EXPECT_EQ(filterKind(filterOf(Kind::Triangle, 1.0)), FILTER_POSITIVE);
    EXPECT_EQ(filterKind(filterOf(Kind::Sinc, 1.0)), FILTER_SIGNED);
    for (float weight : filterTable(filterOf(Kind::Gaussian, 2.0), 2.0).weights) EXPECT_EQ(weight, 1.0f);
    const FilterTable mitchell = filterTable(filterOf(Kind::Mitchell, 2.0), 2.0);
    EXPECT_LT(mitchell.weights.front(), 0.0f);
    EXPECT_GT(mitchell.weights[FILTER_INTERVALS / 2], 1.0f);
}

}  // namespace
}  // namespace dsphere
