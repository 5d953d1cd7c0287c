#include "base/image.h"

#include <gtest/gtest.h>

namespace dsphere {
namespace {

Image picture() {
    Image image;
    image.data = {2, 3, 6, 5};
    image.display = {0, 0, 10, 10};
    return image;
}

TEST(Image, BoxesAreHalfOpen) {
    Box box{2, 3, 6, 5};
    EXPECT_EQ(box.width(), 4);
    EXPECT_EQ(box.height(), 2);
    EXPECT_EQ(box, (Box{2, 3, 6, 5}));
    EXPECT_NE(box, (Box{2, 3, 6, 6}));
    EXPECT_EQ(Box{}.width(), 0);
}

TEST(Image, CountsThePixelsOfItsData) {
    EXPECT_EQ(picture().pixelCount(), 8u);
    EXPECT_EQ(Image{}.pixelCount(), 0u);
    Image large;
    large.data = {0, 0, 65536, 65536};
    EXPECT_EQ(large.pixelCount(), std::size_t(1) << 32);
}

TEST(Image, AddsZeroedChannels) {
    Image image = picture();
    EXPECT_EQ(image.addFloat("R").floats(), std::vector<float>(8, 0.0f));
    EXPECT_EQ(image.addUint("id").uints(), std::vector<std::uint32_t>(8, 0));
    ASSERT_EQ(image.channels.size(), 2u);
    EXPECT_TRUE(image.at("R").isFloat());
    EXPECT_FALSE(image.at("id").isFloat());
}

TEST(Image, FindsChannelsByTheirWholeName) {
    Image image = picture();
    image.addFloat("P.X").floats()[3] = 7.0f;
    ASSERT_NE(image.find("P.X"), nullptr);
    EXPECT_EQ(image.find("P.X")->floats()[3], 7.0f);
    EXPECT_EQ(image.find("P"), nullptr);
    EXPECT_EQ(&image.at("P.X"), image.find("P.X"));
}

TEST(ImageDeathTest, AMissingPromisedChannelIsABrokenInvariant) {
    GTEST_FLAG_SET(death_test_style, "threadsafe");
    EXPECT_DEATH(picture().at("R"), "lacks a channel");
}

}  // namespace
}  // namespace dsphere
