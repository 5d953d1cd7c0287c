#include "image/metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace dsphere::test {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
constexpr float kNaN = std::numeric_limits<float>::quiet_NaN();

/// A row of pixels that begins at (3, 2), in one channel "t".
Image row(const std::vector<float>& values) {
    Image image;
    image.data = image.display = {3, 2, 3 + int(values.size()), 3};
    image.addFloat("t").floats() = values;
    return image;
}

Comparison compare(const std::vector<float>& a, const std::vector<float>& b) {
    return comparePictures(row(a), row(b), {"t"});
}

TEST(Metrics, OfKnownDifferences) {
    const Comparison c = compare({1, 2, 3, 4}, {1, 2.5, 3, 3});
    EXPECT_DOUBLE_EQ(c.mae, 1.5 / 4);
    EXPECT_DOUBLE_EQ(c.rmse, std::sqrt(1.25 / 4));
    EXPECT_DOUBLE_EQ(c.psnr, 10.0 * std::log10(4 / 1.25));
    EXPECT_DOUBLE_EQ(c.max, 1.0);
    ASSERT_TRUE(c.worst);
    EXPECT_EQ(c.worst->x, 6);
    EXPECT_EQ(c.worst->y, 2);
    EXPECT_EQ(c.worst->channel, "t");
    EXPECT_EQ(c.worst->a, 4.0);
    EXPECT_EQ(c.worst->b, 3.0);
}

TEST(Metrics, OfEqualPictures) {
    const Comparison c = compare({1, kInfinity, -kInfinity, kNaN}, {1, kInfinity, -kInfinity, kNaN});
    EXPECT_EQ(c.mae, 0.0);
    EXPECT_EQ(c.rmse, 0.0);
    EXPECT_EQ(c.psnr, double(kInfinity));
    EXPECT_EQ(c.max, 0.0);
    EXPECT_EQ(c.non_finite, 0u);
    EXPECT_FALSE(c.worst);
}

TEST(Metrics, AnInfinityInOneOnlyIsInfinitelyFar) {
    for (float other : {1.0f, -kInfinity}) {
        const Comparison c = compare({5, kInfinity}, {1, other});
        EXPECT_EQ(c.mae, double(kInfinity));
        EXPECT_EQ(c.max, double(kInfinity));
        EXPECT_EQ(c.psnr, -double(kInfinity));
        EXPECT_EQ(c.non_finite, 1u);
        EXPECT_EQ(c.worst->x, 4);
    }
}

TEST(Metrics, ANaNInOneOnlyIsTheWorst) {
    for (bool nan_first : {false, true}) {
        const Comparison c = nan_first ? compare({kNaN, kInfinity}, {1, 1}) : compare({kInfinity, 1}, {1, kNaN});
        EXPECT_EQ(c.worst->x, nan_first ? 3 : 4);
        EXPECT_EQ(c.non_finite, 2u);
        EXPECT_EQ(c.max, double(kInfinity));
    }
}

TEST(Metrics, OfSeveralChannelsAndIntegers) {
    Image a = row({1, 1}), b = row({1, 1.5});
    a.addUint("id").uints() = {4000000000u, 1};
    b.addUint("id").uints() = {4000000003u, 1};
    const Comparison c = comparePictures(a, b, {"t", "id"});
    EXPECT_DOUBLE_EQ(c.mae, 3.5 / 4);
    EXPECT_EQ(c.worst->channel, "id");
    EXPECT_EQ(c.max, 3.0);
}

TEST(Metrics, DifferencePictureIsSigned) {
    const Image a = row({1, 3, kInfinity, kInfinity, kNaN, kNaN}), b = row({2, 1, kInfinity, 1, kNaN, 1});
    const Image difference = differencePicture(a, b, {"t"});
    const std::vector<float>& values = difference.at("t").floats();
    EXPECT_EQ(difference.data, a.data);
    EXPECT_EQ(std::vector<float>(values.begin(), values.begin() + 5), (std::vector<float>{1, -2, 0, -kInfinity, 0}));
    EXPECT_TRUE(std::isnan(values[5]));
}

}  // namespace
}  // namespace dsphere::test
