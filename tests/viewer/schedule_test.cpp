#include "viewer/schedule.h"

#include <gtest/gtest.h>

namespace dsphere::viewer {
namespace {

using Want = Schedule::Want;

TEST(Schedule, RefinesAStillViewToTheTargetThenRests) {
    Schedule schedule;
    EXPECT_EQ(schedule.want(0.0, 2), Want::Still);
    schedule.beginStill();
    for (int i = 0; i < 2; ++i) {
        EXPECT_EQ(schedule.want(0.0, 2), Want::Still);
        schedule.sampleDone();
    }
    EXPECT_EQ(schedule.want(0.0, 2), Want::Nothing);
    EXPECT_EQ(schedule.want(0.0, 3), Want::Still) << "the target rose";
}

TEST(Schedule, DraftsWhileMovingAndAStillAfterwards) {
    Schedule schedule;
    schedule.change(1.0, true);
    EXPECT_EQ(schedule.want(1.0, 16), Want::Draft);
    schedule.beginDraft();
    EXPECT_EQ(schedule.want(1.05, 16), Want::Nothing) << "the draft shows the present view";
    schedule.change(1.1, true);
    EXPECT_EQ(schedule.want(1.1, 16), Want::Draft);
    schedule.beginDraft();
    EXPECT_EQ(schedule.want(1.1 + 1.01 * Schedule::kSettle, 16), Want::Still);
    schedule.settle();
    EXPECT_EQ(schedule.want(1.1, 16), Want::Still) << "the button was let go";
    EXPECT_EQ(schedule.samples(), 0);
}

TEST(Schedule, AChangeDropsTheStill) {
    Schedule schedule;
    schedule.beginStill();
    schedule.sampleDone();
    EXPECT_TRUE(schedule.current());
    schedule.change(1.0, false);
    EXPECT_FALSE(schedule.current());
    EXPECT_EQ(schedule.want(1.0, 1), Want::Still);
}

/// A device that renders a full-size picture in `full` seconds, half of it shadows.
double settledFrame(Schedule& schedule, double full, double overhead) {
    double seconds = 0.0;
    for (int i = 0; i < 60; ++i) {
        seconds = full * schedule.scale() * schedule.scale() * (schedule.shadows() ? 1.0 : 0.5);
        schedule.draftTook(seconds, overhead);
    }
    return seconds + overhead;
}

TEST(Schedule, FindsTheSharpestDraftInTime) {
    Schedule fast;
    EXPECT_LT(settledFrame(fast, 0.010, 0.002), Schedule::kFrameTarget);
    EXPECT_EQ(fast.scale(), 1.0);
    EXPECT_TRUE(fast.shadows());
    Schedule middling;
    double frame = settledFrame(middling, 0.060, 0.004);
    EXPECT_LE(frame, Schedule::kFrameTarget);
    EXPECT_GT(frame, 0.6 * Schedule::kFrameTarget);
    EXPECT_TRUE(middling.shadows());
}

TEST(Schedule, NeverGoesBelowHalfTheSides) {
    Schedule slow;
    settledFrame(slow, 10.0, 0.004);
    EXPECT_EQ(slow.scale(), Schedule::kLeastScale);
    EXPECT_FALSE(slow.shadows()) << "shadows go before the picture is too late";
    settledFrame(slow, 0.010, 0.004);
    EXPECT_TRUE(slow.shadows()) << "and come back";
    EXPECT_EQ(slow.scale(), 1.0);
}

TEST(Schedule, DoesNotWaver) {
    Schedule schedule;
    settledFrame(schedule, 0.055, 0.004);
    const double scale = schedule.scale();
    const bool shadows = schedule.shadows();
    for (int i = 0; i < 40; ++i) {
        double cost = (i % 2 ? 0.053 : 0.057) * (schedule.shadows() ? 1.0 : 0.5);
        schedule.draftTook(cost * schedule.scale() * schedule.scale(), 0.004);
        EXPECT_NEAR(schedule.scale(), scale, 1.0 / 16.0);
        EXPECT_EQ(schedule.shadows(), shadows);
    }
}

}  // namespace
}  // namespace dsphere::viewer
