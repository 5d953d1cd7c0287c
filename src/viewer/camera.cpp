#include "viewer/camera.h"

#include <algorithm>
#include <cmath>

namespace dsphere::viewer {

namespace {

constexpr double kZoomStep = 0.85;  // of the distance, a notch of the wheel

CursorRay rayOf(const Raster& raster, const dvec2& cursor) {
    return {raster.start.at(cursor.x, cursor.y), glm::normalize(raster.direction.at(cursor.x, cursor.y))};
}

/// The shortest one that takes a to b, both unit.
dmat3 rotationBetween(const dvec3& a, const dvec3& b) {
    dvec3 across = glm::cross(a, b);
    double sine = glm::length(across);
    if (sine < 1e-15) return dmat3(1.0);
    return rotationAbout(across / sine, std::atan2(sine, glm::dot(a, b)));
}

double shorterSide(const Film& film) {
    return double(std::min(film.width, film.height));
}

}  // namespace

// Rodrigues.
dmat3 rotationAbout(const dvec3& axis, double angle) {
    double c = std::cos(angle), s = std::sin(angle);
    dmat3 cross(0.0, axis.z, -axis.y, -axis.z, 0.0, axis.x, axis.y, -axis.x, 0.0);
    return c * dmat3(1.0) + s * cross + (1.0 - c) * glm::outerProduct(axis, axis);
}

Pose Pose::of(const Camera& camera) {
    dmat4 m = glm::inverse(camera.camera_from_world);
    return {dvec3(m[3]), dvec3(m[0]), dvec3(m[1]), dvec3(m[2])};
}

dmat4 Pose::cameraFromWorld() const {
    return glm::inverse(dmat4(dvec4(right, 0.0), dvec4(up, 0.0), dvec4(ahead, 0.0), dvec4(eye, 1.0)));
}

double Pose::handedness() const {
    return glm::dot(glm::cross(up, ahead), right) < 0.0 ? -1.0 : 1.0;
}

void Pose::turn(const dmat3& rotation, const dvec3& about) {
    eye = about + rotation * (eye - about);
    right = rotation * right;
    up = rotation * up;
    ahead = rotation * ahead;
}

CameraControl::CameraControl(const Camera& camera, const Film& film, std::shared_ptr<const Bodies> bodies,
                             std::size_t target)
    : home_(camera),
      camera_(camera),
      film_(film),
      bodies_(std::move(bodies)),
      target_(target),
      pose_(Pose::of(camera)),
      home_is_outside_(altitude() >= 0.0) {}

CursorRay CameraControl::rayAt(const dvec2& cursor) const {
    return rayOf(makeRaster(camera_, film_), cursor);
}

void CameraControl::resize(int width, int height) {
    film_.width = width;
    film_.height = height;
}

bool CameraControl::setBodies(std::shared_ptr<const Bodies> bodies) {
    const Camera before = moved_out_ && moved_out_->to == camera_ ? moved_out_->from : camera_;
    moved_out_.reset();
    const dvec3 centre = globe().centre();
    const double radius = globe().radius();
    bodies_ = std::move(bodies);
    if (target_ >= bodies_->count()) target_ = 0;
    if (!(before == camera_)) setCamera(before);
    if (bodies_->outOfGround(pose_.eye, kLowest) == pose_.eye) return false;
    Pose pose = pose_;
    const double grown = std::max(globe().radius() / radius, 1.0);
    pose.eye = bodies_->outOfGround(centre + grown * (pose.eye - centre), kLowest);
    const double moved = glm::length(pose.eye - pose_.eye);
    place(pose);
    moved_out_ = {before, camera_};
    return moved > 0.1 * radius;
}

void CameraControl::setCamera(const Camera& camera) {
    camera_ = camera;
    pose_ = Pose::of(camera);
}

void CameraControl::reset() {
    setCamera(home_);
    if (home_is_outside_ && altitude() < 0.0) frame();
}

void CameraControl::place(const Pose& pose) {
    pose_ = pose;
    camera_.camera_from_world = pose.cameraFromWorld();
}

// Past nothing, out of the ground, and not farther than where the scene is still seen: or than it was before.
void CameraControl::moveTo(Pose pose, const dvec3& from) {
    if (pose.eye != from) pose.eye = bodies_->wayTo(from, pose.eye, kLowest);
    pose.eye = bodies_->outOfGround(pose.eye, kLowest);
    if (camera_.projection == Projection::Perspective) {
        const double pixel = 2.0 * std::tan(0.5 * glm::radians(camera_.fov_degrees)) / shorterSide(film_);
        const double own = glm::length(from - bodies_->middle());
        const double farthest = std::max(2.0 * bodies_->reach() / (kFewestPixels * pixel), own);
        const dvec3 outward = pose.eye - bodies_->middle();
        if (glm::length(outward) > farthest) pose.eye = bodies_->middle() + outward * (farthest / glm::length(outward));
    }
    place(pose);
}

std::optional<dvec3> CameraControl::onSphere(const CursorRay& ray, double radius) const {
    dvec3 from = ray.origin - globe().centre();
    double b = glm::dot(from, ray.direction);
    dvec3 nearest = from - b * ray.direction;
    double room = radius * radius - glm::dot(nearest, nearest);
    if (room < 0.0) return {};
    double s = -b - std::sqrt(room);
    if (s <= 0.0 && camera_.projection == Projection::Perspective) return {};
    return globe().centre() + nearest - std::sqrt(room) * ray.direction;
}

dvec3 CameraControl::pivot(const dvec2& cursor, const std::optional<dvec3>& hit) const {
    if (!hit) return globe().centre();
    // The cursor's own ray, not the pixel's that was traced.
    CursorRay ray = rayAt(cursor);
    return ray.origin + glm::dot(*hit - ray.origin, ray.direction) * ray.direction;
}

void CameraControl::grab(const dvec2& cursor, const std::optional<Hit>& hit) {
    if (hit) target_ = hit->shape;
    grabbed_pose_ = pose_;
    grabbed_raster_ = makeRaster(camera_, film_);
    grabbed_cursor_ = cursor;
    grabbed_point_ = pivot(cursor, hit ? std::optional(hit->point) : std::nullopt);
    on_globe_ = hit.has_value();
    const double eye = glm::length(pose_.eye - globe().centre()),
                 reach = glm::length(grabbed_point_ - globe().centre());
    looks_around_ =
        camera_.projection == Projection::Perspective && (hit ? eye < 1.000001 * reach : altitude() < globe().radius());
    if (!hit && looks_around_) {
        const CursorRay ray = rayAt(cursor);
        grabbed_point_ = ray.origin + std::max(altitude(), kLowest * globe().radius()) * ray.direction;
    }
}

// The sky moves with the cursor, about the vertical at the eye, and no farther than straight up or down.
void CameraControl::lookTo(const dvec2& cursor) {
    Pose pose = grabbed_pose_;
    const dvec3 vertical = glm::normalize(pose.eye - globe().centre());
    const auto angles = [&](const dvec2& place) {
        const dvec3 d = rayOf(grabbed_raster_, place).direction, ahead = glm::normalize(pose.ahead);
        return dvec2(std::atan2(glm::dot(d, glm::normalize(pose.right)), glm::dot(d, ahead)),
                     std::atan2(glm::dot(d, glm::normalize(pose.up)), glm::dot(d, ahead)));
    };
    const dvec2 turned = angles(cursor) - angles(grabbed_cursor_);
    const double hand = pose.handedness();
    const double height = std::asin(std::clamp(glm::dot(glm::normalize(pose.ahead), vertical), -1.0, 1.0));
    const double wanted = std::clamp(height - turned.y, -0.49 * kPi, std::max(height, 0.49 * kPi));
    pose.turn(rotationAbout(glm::normalize(pose.right), -hand * (wanted - height)), pose.eye);
    pose.turn(rotationAbout(vertical, -hand * turned.x), pose.eye);
    place(pose);
}

// Turning about an axis that runs from the centre through the grabbed point leaves that point where it is on the
// screen. The component of `right` along north is A + B cos + C sin of the angle; it is brought back to what it was.
dmat3 CameraControl::levelling(const Pose& pose, const dvec3& axis) const {
    const dvec3& north = globe().north();
    double target = glm::dot(glm::normalize(grabbed_pose_.right), north);
    dvec3 right = glm::normalize(pose.right);
    double a = glm::dot(right, axis) * glm::dot(axis, north);
    double b = glm::dot(right, north) - a, c = glm::dot(glm::cross(axis, right), north);
    double reach = std::hypot(b, c);
    if (reach < 1e-9) return dmat3(1.0);
    double middle = std::atan2(c, b), half = std::acos(std::clamp((target - a) / reach, -1.0, 1.0));
    double first = std::remainder(middle + half, 2.0 * kPi), second = std::remainder(middle - half, 2.0 * kPi);
    return rotationAbout(axis, std::abs(first) < std::abs(second) ? first : second);
}

void CameraControl::orbitTo(const dvec2& cursor) {
    Pose pose = grabbed_pose_;
    const dvec3& centre = globe().centre();
    if (looks_around_) return lookTo(cursor);
    if (!on_globe_) {
        dvec2 angle = (cursor - grabbed_cursor_) * (kPi / shorterSide(film_));
        double hand = pose.handedness();
        pose.turn(rotationAbout(globe().north(), -hand * angle.x), centre);
        pose.turn(rotationAbout(glm::normalize(pose.right), -hand * angle.y), centre);
        return place(pose);
    }
    const double radius = glm::length(grabbed_point_ - centre);
    CursorRay ray = rayOf(grabbed_raster_, cursor);
    std::optional<dvec3> under = onSphere(ray, radius);
    if (!under) {  // beside the ball: its edge follows
        dvec3 from = ray.origin - centre;
        dvec3 nearest = from - glm::dot(from, ray.direction) * ray.direction;
        under = centre + radius * glm::normalize(nearest);
    }
    dvec3 axis = glm::normalize(grabbed_point_ - centre);
    pose.turn(rotationBetween(glm::normalize(*under - centre), axis), centre);
    pose.turn(levelling(pose, axis), centre);
    moveTo(pose, pose.eye);
}

void CameraControl::panTo(const dvec2& cursor) {
    CursorRay ray = rayOf(grabbed_raster_, cursor);
    dvec3 ahead = glm::normalize(grabbed_pose_.ahead);
    double along = glm::dot(ray.direction, ahead);
    double depth = glm::dot(grabbed_point_ - ray.origin, ahead);
    CursorRay before = rayOf(grabbed_raster_, grabbed_cursor_);
    dvec3 was = before.origin + before.direction * (depth / glm::dot(before.direction, ahead));
    Pose pose = grabbed_pose_;
    pose.eye += was - (ray.origin + ray.direction * (depth / along));
    moveTo(pose, grabbed_pose_.eye);
}

void CameraControl::tiltTo(const dvec2& cursor) {
    if (!on_globe_ && looks_around_) return lookTo(cursor);
    dvec2 angle = (cursor - grabbed_cursor_) * (kPi / shorterSide(film_));
    Pose pose = grabbed_pose_;
    dvec3 about = grabbed_point_;
    dvec3 vertical = on_globe_ ? glm::normalize(about - globe().centre()) : globe().north();
    double hand = pose.handedness();
    dvec3 ahead = glm::normalize(pose.ahead);
    // 0 looks straight down; upward drags lower the eye towards the horizon.
    double slant = std::acos(std::clamp(-glm::dot(ahead, vertical), -1.0, 1.0));
    double wanted = std::clamp(slant - angle.y, 0.0, std::max(slant, 0.52 * kPi));
    pose.turn(rotationAbout(glm::normalize(pose.right), -hand * (wanted - slant)), about);
    pose.turn(rotationAbout(vertical, -hand * angle.x), about);
    moveTo(pose, pose.eye);
}

void CameraControl::zoomOrthographic(const dvec2& cursor, double factor) {
    dvec3 before = rayAt(cursor).origin;
    Pose pose = pose_;
    const double widest = bodies_->reach() * shorterSide(film_) / kFewestPixels;
    factor = std::min(factor, std::max(1.0, widest / glm::length(pose.up)));
    pose.right *= factor;
    pose.up *= factor;
    place(pose);
    pose.eye += before - rayAt(cursor).origin;
    place(pose);
}

void CameraControl::zoom(const dvec2& cursor, const std::optional<dvec3>& hit, double steps) {
    double factor = std::pow(kZoomStep, steps);
    if (camera_.projection == Projection::Orthographic) return zoomOrthographic(cursor, factor);
    Pose pose = pose_;
    const dvec3 from = pose.eye, outward = glm::normalize(from - globe().centre());
    const double lowest = kLowest * globe().radius(), height = std::max(altitude(), lowest);
    const double distance = hit ? glm::length(*hit - from) : 0.0;
    if (hit && distance > 1e-3 * lowest) {
        dvec3 point = pivot(cursor, hit), away = from - point;
        if (steps > 0.0) factor = std::min(1.0, std::max(factor, lowest / glm::length(away)));
        pose.eye = point + factor * away;
    } else if (hit || height > globe().radius()) {  // also from within: there is always a way out
        pose.eye += (factor - 1.0) * height * outward;
    } else {
        pose.eye += (1.0 - factor) * height * rayAt(cursor).direction;
    }
    // As near as it goes there it stops, rather than slide along the ground.
    if (steps > 0.0 && pose.eye != from) pose.eye = bodies_->wayTo(from, pose.eye, kLowest, 1.0);
    moveTo(pose, from);
}

void CameraControl::fly(const dvec3& along, double seconds) {
    Pose pose = pose_;
    const dvec3 from = pose.eye;
    double step = std::max(altitude(), kLowest * globe().radius()) * seconds;
    pose.eye += step * (along.x * glm::normalize(pose.right) + along.y * glm::normalize(pose.up) +
                        along.z * glm::normalize(pose.ahead));
    moveTo(pose, from);
}

}  // namespace dsphere::viewer
