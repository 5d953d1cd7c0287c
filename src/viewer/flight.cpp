#include "viewer/flight.h"

#include <algorithm>
#include <cmath>

#include <glm/gtc/quaternion.hpp>

namespace dsphere::viewer {

namespace {

constexpr double kRise = 0.5;  // of the distance, midway to the far side

glm::dquat turnOf(const Pose& pose) {
    return glm::quat_cast(
        dmat3(pose.handedness() * glm::normalize(pose.right), glm::normalize(pose.up), glm::normalize(pose.ahead)));
}

double mixLengths(const dvec3& from, const dvec3& to, double share) {
    return std::exp(glm::mix(std::log(glm::length(from)), std::log(glm::length(to)), share));
}

}  // namespace

Flight::Flight(const Pose& from, const Pose& to, const dvec3& centre, double start)
    : from_(from), to_(to), centre_(centre), start_(start) {}

Pose Flight::at(double now) const {
    if (over(now)) return to_;
    const double passed = std::clamp((now - start_) / kSeconds, 0.0, 1.0);
    const double share = passed * passed * (3.0 - 2.0 * passed);
    const dvec3 begin = from_.eye - centre_, end = to_.eye - centre_;
    const dvec3 first = glm::normalize(begin), last = glm::normalize(end), across = glm::cross(first, last);
    const double angle = std::atan2(glm::length(across), glm::dot(first, last));
    dvec3 outward = first;
    if (glm::length(across) > 1e-12) outward = rotationAbout(glm::normalize(across), share * angle) * first;
    const double rise = 1.0 + kRise * angle / kPi * std::sin(kPi * share);
    const dmat3 axes = glm::mat3_cast(glm::slerp(turnOf(from_), turnOf(to_), share));
    Pose pose;
    pose.eye = centre_ + rise * mixLengths(begin, end, share) * outward;
    pose.right = from_.handedness() * mixLengths(from_.right, to_.right, share) * axes[0];
    pose.up = mixLengths(from_.up, to_.up, share) * axes[1];
    pose.ahead = mixLengths(from_.ahead, to_.ahead, share) * axes[2];
    return pose;
}

}  // namespace dsphere::viewer
