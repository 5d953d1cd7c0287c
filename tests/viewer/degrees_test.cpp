#include "viewer/degrees.h"

#include <gtest/gtest.h>

namespace dsphere::viewer {
namespace {

TEST(Degrees, AreReadWithTheirDirection) {
    EXPECT_EQ(degreesIn("45.5", "NS", 90.0), 45.5);
    EXPECT_EQ(degreesIn("-45.5", "NS", 90.0), -45.5);
    EXPECT_EQ(degreesIn(" 45.5 S", "NS", 90.0), -45.5);
    EXPECT_EQ(degreesIn("45.5s", "NS", 90.0), -45.5);
    EXPECT_EQ(degreesIn("45.5° N", "NS", 90.0), 45.5);
    EXPECT_EQ(degreesIn("20W", "EW", 360.0), -20.0);
    EXPECT_EQ(degreesIn("340 e", "EW", 360.0), 340.0);
}

TEST(Degrees, WhatIsNoneIsRefused) {
    for (const char* text : {"", "north", "45 W", "45.5 S 3", "91", "-200", "nan", "inf", "45,5"})
        EXPECT_FALSE(degreesIn(text, "NS", 90.0)) << text;
}

TEST(Degrees, AreWrittenAsTheyAreRead) {
    EXPECT_EQ(degreesText(-42.25, "EW", 2), "42.25° W");
    EXPECT_EQ(degreesText(0.0, "NS", 1), "0.0° N");
    EXPECT_EQ(degreesIn(degreesText(-12.34567, "NS"), "NS", 90.0), -12.34567);
}

}  // namespace
}  // namespace dsphere::viewer
