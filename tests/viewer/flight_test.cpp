#include "viewer/flight.h"

#include <gtest/gtest.h>

namespace dsphere::viewer {
namespace {

/// Looks at the centre from `eye`, in a mirrored scene.
Pose looking(const dvec3& eye, const dvec3& up) {
    const dvec3 ahead = -glm::normalize(eye);
    return {eye, -glm::cross(up, ahead), up, ahead};
}

TEST(Flight, GoesFromOnePoseToTheOther) {
    const Pose from = looking({0.0, 0.0, 3.0}, {0.0, 1.0, 0.0}), to = looking({2.0, 0.0, 0.0}, {0.0, 1.0, 0.0});
    const Flight flight(from, to, dvec3(0.0), 5.0);
    EXPECT_LT(glm::length(flight.at(5.0).eye - from.eye), 1e-12);
    EXPECT_EQ(flight.at(5.0 + Flight::kSeconds).eye, to.eye);
    EXPECT_TRUE(flight.over(5.0 + Flight::kSeconds));
    const Pose midway = flight.at(5.0 + 0.5 * Flight::kSeconds);
    EXPECT_LT(midway.handedness(), 0.0) << "the scene stays mirrored";
    EXPECT_NEAR(glm::dot(glm::normalize(midway.ahead), -glm::normalize(midway.eye)), 1.0, 1e-9)
        << "still at the centre";
    EXPECT_NEAR(midway.eye.x, midway.eye.z, 1e-9);
    EXPECT_GT(glm::length(midway.eye), std::sqrt(6.0)) << "a little higher on the way";
}

}  // namespace
}  // namespace dsphere::viewer
