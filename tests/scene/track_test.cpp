// A track meets its keys, has a continuous slope, and is exact on the curves that it is made for.

#include "scene/track.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dsphere {
namespace {

Track trackOf(std::initializer_list<std::pair<double, double>> keys, Between between = Between::Linear) {
    Track track(between);
    for (const auto& [frame, value] : keys) track.add(frame, value);
    return track;
}

TEST(Track, HoldsItsEnds) {
    const Track track = trackOf({{2.0, 5.0}, {4.0, 9.0}});
    EXPECT_EQ(track.at(-10.0), 5.0);
    EXPECT_EQ(track.at(2.0), 5.0);
    EXPECT_EQ(track.at(3.0), 7.0) << "two keys: a straight line";
    EXPECT_EQ(track.at(4.0), 9.0);
    EXPECT_EQ(track.at(100.0), 9.0);
    EXPECT_EQ(trackOf({{3.0, 8.0}}).at(0.0), 8.0);
}

TEST(Track, FollowsAParabolaThroughUnequalKeys) {
    const auto parabola = [](double x) { return 3.0 - 2.0 * x + 0.5 * x * x; };
    Track track;
    for (const double frame : {0.0, 1.0, 5.0, 7.0, 20.0}) track.add(frame, parabola(frame));
    for (double frame = 1.0; frame <= 7.0; frame += 0.25)  // not the ends, whose slopes are those of their pieces
        EXPECT_NEAR(track.at(frame), parabola(frame), 1e-12) << frame;
}

TEST(Track, HasNoJumpOfValueOrSlopeAtAKey) {
    const Track track = trackOf({{0.0, 1.0}, {3.0, -4.0}, {4.0, 7.0}, {30.0, 6.0}, {31.0, 0.0}});
    constexpr double kStep = 1e-5;
    for (const double key : {3.0, 4.0, 30.0}) {
        const double before = (track.at(key) - track.at(key - kStep)) / kStep;
        const double after = (track.at(key + kStep) - track.at(key)) / kStep;
        EXPECT_NEAR(before, after, 2e-3) << key;
    }
}

TEST(Track, AnglesGoTheShortWay) {
    const Track track = trackOf({{0.0, 170.0}, {10.0, -170.0}, {20.0, -150.0}}, Between::Angle);
    EXPECT_NEAR(std::remainder(track.at(5.0) - 180.0, 360.0), 0.0, 1e-12);
    EXPECT_NEAR(std::remainder(track.at(10.0) + 170.0, 360.0), 0.0, 1e-12);
    EXPECT_NEAR(std::remainder(track.at(15.0) + 160.0, 360.0), 0.0, 1e-12);
}

TEST(Track, AltitudesShrinkByEqualFactors) {
    const Track track = trackOf({{0.0, 100.0}, {4.0, 0.01}}, Between::Logarithm);
    EXPECT_NEAR(track.at(1.0), 10.0, 1e-9);
    EXPECT_NEAR(track.at(2.0), 1.0, 1e-12);
    EXPECT_GT(track.at(4.0), 0.0);
}

}  // namespace
}  // namespace dsphere
