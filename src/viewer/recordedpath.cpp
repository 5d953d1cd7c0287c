#include "viewer/recordedpath.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include "base/atomicfile.h"
#include "base/error.h"
#include "base/limits.h"
#include "scene/globeview.h"
#include "scene/textfile.h"
#include "viewer/camera.h"

namespace dsphere::viewer {

namespace {

constexpr std::string_view kPlaces = "frame,lat,lon,alt,heading,pitch,roll,fov";
constexpr std::string_view kPoints = "frame,eye_x,eye_y,eye_z,look_x,look_y,look_z,up_x,up_y,up_z,fov";
constexpr double kVertical = 1e-6;  // radians: a view that is nearer to straight up or down has its heading from its up

std::string_view headerOf(std::string_view text) {
    std::string_view line = text.substr(0, std::min(text.find('\n'), text.size()));
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

/// The only displaced sphere of the scene; null if there is none or several.
const Shape* onlyGlobe(const Scene& scene) {
    const auto displaced = [](const Shape& shape) { return std::holds_alternative<DisplacedSphere>(shape.geometry); };
    if (std::ranges::count_if(scene.shapes, displaced) != 1) return nullptr;
    return &*std::ranges::find_if(scene.shapes, displaced);
}

// The inverse of lookFrom().
std::string placesOf(const Shape& globe, const Camera& camera) {
    const dmat4 object_from_world = glm::inverse(globe.world_from_object);
    const Pose pose = Pose::of(camera);
    const dvec3 eye = transformPoint(object_from_world, pose.eye);
    const auto directionOf = [&](const dvec3& v) { return glm::normalize(transformVector(object_from_world, v)); };
    const dvec3 ahead = directionOf(pose.ahead), up = directionOf(pose.up);
    const double latitude = glm::degrees(std::atan2(eye.y, std::hypot(eye.x, eye.z)));
    const double longitude = glm::degrees(std::atan2(eye.x, eye.z));
    const LocalFrame local = localFrameAt(latitude, longitude);
    const double climb = glm::dot(ahead, local.up);
    double heading = std::atan2(glm::dot(ahead, local.east), glm::dot(ahead, local.north)), roll = 0.0;
    double pitch = std::asin(std::clamp(climb, -1.0, 1.0));
    if (std::hypot(glm::dot(ahead, local.east), glm::dot(ahead, local.north)) < kVertical) {
        const dvec3 level = climb < 0.0 ? up : -up;
        heading = std::atan2(glm::dot(level, local.east), glm::dot(level, local.north));
        pitch = std::copysign(0.5 * kPi, climb);
    } else {
        const dvec3 level = std::cos(heading) * local.north + std::sin(heading) * local.east;
        const dvec3 right = std::cos(heading) * local.east - std::sin(heading) * local.north;
        roll = std::atan2(glm::dot(up, right), glm::dot(up, std::cos(pitch) * local.up - std::sin(pitch) * level));
    }
    const double altitude = glm::length(eye) / std::get<DisplacedSphere>(globe.geometry).radius - 1.0;
    return fmt::format("{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{:.12g},{}", latitude, longitude, altitude,
                       glm::degrees(heading), glm::degrees(pitch), glm::degrees(roll), camera.fov_degrees);
}

std::string pointsOf(const Camera& camera, double distance) {
    const Pose pose = Pose::of(camera);
    const dvec3 look = pose.eye + distance * glm::normalize(pose.ahead), up = glm::normalize(pose.up);
    return fmt::format("{},{},{},{},{},{},{},{},{},{}", pose.eye.x, pose.eye.y, pose.eye.z, look.x, look.y, look.z,
                       up.x, up.y, up.z, camera.fov_degrees);
}

}  // namespace

std::optional<RecordedPath> RecordedPath::parse(std::string text, const std::string& name) {
    if (headerOf(text) != kPlaces && headerOf(text) != kPoints) return {};
    if (!text.ends_with('\n')) text += '\n';
    RecordedPath path;
    try {
        path.motion_ = Motion::parse(text, name);
    } catch (const Error&) {
        return {};
    }
    path.text_ = std::move(text);
    return path;
}

Camera RecordedPath::at(const Scene& scene, double frame) const {
    assert(motion_);
    return motion_->at(scene, frame).camera;
}

std::string RecordedPath::lineOf(const Scene& scene, const Camera& camera, double distance) const {
    if (camera.projection != Projection::Perspective)
        throwUsage("A path file holds perspective cameras only; this scene's is orthographic.");
    const double frame = keys() == 0 ? 0.0 : std::floor(lastFrame()) + kStep;
    const Shape* globe = onlyGlobe(scene);
    for (const std::string_view columns : {kPlaces, kPoints}) {
        if (columns == kPlaces && !globe) continue;
        if (keys() > 0 && columns != headerOf(text_)) continue;
        std::string line =
            fmt::format("{},{}\n", frame, columns == kPlaces ? placesOf(*globe, camera) : pointsOf(camera, distance));
        const std::optional<RecordedPath> alone = parse(fmt::format("{}\n{}", columns, line), "this view");
        try {
            if (alone && sameView(alone->at(scene, frame), camera)) return line;
        } catch (const Error&) {
            // These columns make no camera.
        }
    }
    throwUsage(
        "The path file cannot say this view: its eye is below the sphere without relief, or its camera is stretched.");
}

RecordedPath RecordedPath::with(const std::string& line) const {
    std::string text = text_;
    if (text.empty()) text = fmt::format("{}\n", std::ranges::count(line, ',') == 7 ? kPlaces : kPoints);
    std::optional<RecordedPath> longer = parse(text + line, "the path");
    if (!longer) throwFailure("The path file has changed: its last key is now at frame {}.", lastFrame());
    return *longer;
}

std::optional<RecordedPath> RecordedPath::without(const std::string& line) const {
    if (!text_.ends_with('\n' + line)) return {};
    if (keys() == 1) return RecordedPath();
    return parse(text_.substr(0, text_.size() - line.size()), "the path");
}

bool sameView(const Camera& a, const Camera& b) {
    const Pose one = Pose::of(a), other = Pose::of(b);
    const auto near = [](const dvec3& x, const dvec3& y) {
        return glm::length(glm::normalize(x) - glm::normalize(y)) < 2.0 * kVertical;
    };
    const auto shape = [](const Pose& pose) {
        return dvec2(glm::length(pose.right), glm::length(pose.up)) / glm::length(pose.ahead);
    };
    return glm::length(one.eye - other.eye) <= 1e-9 * std::max(1e-3, glm::length(one.eye)) &&
           near(one.ahead, other.ahead) && near(one.up, other.up) && near(one.right, other.right) &&
           glm::length(shape(one) - shape(other)) < 1e-9 && a.fov_degrees == b.fov_degrees;
}

PathFile findPathFile(const std::filesystem::path& folder, const std::string& scene) {
    PathFile found;
    for (int n = 1;; ++n) {
        found.path = folder / (n == 1 ? fmt::format("{}-path.csv", scene) : fmt::format("{}-path-{}.csv", scene, n));
        std::error_code error;
        if (!std::filesystem::exists(std::filesystem::symlink_status(found.path, error))) return found;
        try {
            std::optional<RecordedPath> keys =
                RecordedPath::parse(readText(found.path, limits::kTextBytes), found.path.string());
            if (keys) {
                found.keys = std::move(*keys);
                return found;
            }
        } catch (const std::runtime_error&) {
            // It is something else than a readable text.
        }
        if (n == 1) found.passed_over = found.path;
    }
}

void writePathFile(const PathFile& file) {
    if (file.keys.keys() == 0) {
        std::error_code error;
        if (!std::filesystem::remove(file.path, error) && error)
            throwFailure("{}: {}", file.path.string(), error.message());
        return;
    }
    AtomicFile out(file.path);
    out.write(file.keys.text().data(), file.keys.text().size());
    out.commit();
}

}  // namespace dsphere::viewer
