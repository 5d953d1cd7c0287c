// Views of a globe that the camera is put to, and steps over its ground.

#include <algorithm>
#include <cmath>

#include "viewer/camera.h"

namespace dsphere::viewer {

namespace {

constexpr double kFill = 0.9;      // share of the window's shorter side that a whole globe takes
constexpr double kStep = 0.1;      // of moveOver: radians, from the height of a radius up
constexpr double kNear = 0.5;      // R: below this height the horizon is what is level
constexpr double kDownward = 0.9;  // cosine to straight down: nearer to it a map is seen, not a landscape

}  // namespace

Pose CameraControl::facing(const dvec3& eye, const dvec3& ahead, const dvec3& upward) const {
    const dvec3 up = glm::normalize(upward - glm::dot(upward, ahead) * ahead);
    return {eye, glm::length(pose_.right) * pose_.handedness() * glm::cross(up, ahead), glm::length(pose_.up) * up,
            glm::length(pose_.ahead) * ahead};
}

void CameraControl::showWhole(const dvec3& outward, const dvec3& upward) {
    const double tangent = std::tan(0.5 * glm::radians(camera_.fov_degrees));
    const bool flat = camera_.projection == Projection::Orthographic;
    const double distance = flat ? 3.0 * globe().radius() : globe().radius() / std::sin(std::atan(kFill * tangent));
    Pose pose = facing(globe().centre() + distance * outward, -outward, upward);
    if (flat) {
        pose.right = globe().radius() / kFill * glm::normalize(pose.right);
        pose.up = globe().radius() / kFill * glm::normalize(pose.up);
    }
    place(pose);
}

void CameraControl::axisView(Side side) {
    dvec3 outward = globe().origin(), up = globe().north();
    if (side == Side::Back) outward = -globe().origin();
    if (side == Side::Right) outward = globe().east();
    if (side == Side::Left) outward = -globe().east();
    if (side == Side::North) outward = globe().north(), up = -globe().origin();
    if (side == Side::South) outward = -globe().north(), up = globe().origin();
    if (side == Side::Corner) outward = glm::normalize(globe().origin() + globe().east() + globe().north());
    showWhole(outward, up);
}

// Along the ground; at the poles, where there is none, as the views of them have it.
dvec3 CameraControl::northAt(const dvec3& outward) const {
    const dvec3& north = globe().north();
    const dvec3 along = north - glm::dot(north, outward) * outward;
    if (glm::length(along) > 1e-6) return glm::normalize(along);
    return glm::dot(north, outward) > 0.0 ? -globe().origin() : globe().origin();
}

void CameraControl::frame() {
    const dvec3 offset = pose_.eye - globe().centre();
    const dvec3 outward = glm::length(offset) > 0.0 ? glm::normalize(offset) : globe().origin();
    showWhole(outward, northAt(outward));
}

void CameraControl::northUp() {
    const dvec3 offset = pose_.eye - globe().centre();
    if (!(glm::length(offset) > 0.0)) return;
    const dvec3 outward = glm::normalize(offset), ahead = glm::normalize(pose_.ahead);
    const double rise = glm::dot(ahead, outward);
    if (altitude() > kNear * globe().radius() || rise < -kDownward || camera_.projection == Projection::Orthographic) {
        place(facing(pose_.eye, ahead, northAt(-ahead)));
    } else {
        const dvec3 level = std::sqrt(std::max(1.0 - rise * rise, 1e-6)) * northAt(outward);
        place(facing(pose_.eye, glm::normalize(rise * outward + level), outward));
    }
}

// To the right about the axis where north is up, so that it stays there.
void CameraControl::moveOver(const dvec2& steps) {
    const dvec3 offset = pose_.eye - globe().centre();
    if (!(glm::length(offset) > 0.0)) return;
    const dvec3 outward = glm::normalize(offset), &north = globe().north();
    const double step = kStep * std::clamp(altitude() / globe().radius(), kLowest, 1.0);
    dvec3 right = glm::normalize(pose_.right - glm::dot(pose_.right, outward) * outward);
    dvec3 up = glm::cross(right, outward);
    if (glm::dot(up, pose_.up + pose_.ahead) < 0.0) up = -up;
    const dvec3 east = glm::cross(north, outward);
    Pose pose = pose_;
    pose.turn(rotationAbout(glm::normalize(glm::cross(outward, up)), step * steps.y), globe().centre());
    if (std::abs(glm::dot(right, north)) < 0.5 && glm::length(east) > 0.1)
        pose.turn(rotationAbout(north, glm::dot(east, right) > 0.0 ? step * steps.x : -step * steps.x),
                  globe().centre());
    else
        pose.turn(rotationAbout(glm::normalize(glm::cross(outward, right)), step * steps.x), globe().centre());
    moveTo(pose, pose_.eye);
}

Pose CameraControl::poseAbove(double latitude, double longitude, double altitude) const {
    const dvec3 outward = globe().direction(latitude, longitude);
    const double height = std::max(altitude, kLowest * globe().radius());
    return facing(globe().centre() + outward * (globe().ground(outward) + height), -outward, northAt(outward));
}

void CameraControl::setPose(const Pose& pose) {
    Pose free = pose;
    free.eye = bodies_->outOfGround(pose.eye, kLowest);
    place(free);
}

}  // namespace dsphere::viewer
