#include "viewer/globe.h"

#include "surface/interpolator.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dsphere::viewer {

namespace {

// What a shape without a map has for a relief.
Relief reliefOf(const Shape& shape, const Relief& relief) {
    if (std::holds_alternative<DisplacedSphere>(shape.geometry)) return relief;
    double radius = 0.0;
    if (const auto* sphere = std::get_if<Sphere>(&shape.geometry)) radius = sphere->radius;
    Relief plain;
    plain.base = plain.least_radius = plain.greatest_radius = radius;
    if (const auto* disk = std::get_if<Disk>(&shape.geometry)) plain.greatest_radius = disk->radius;
    return plain;
}

// Ericson, Real-Time Collision Detection (2005), 5.1.5.
dvec3 closestOnTriangle(const dvec3& p, const std::array<dvec3, 3>& triangle) {
    const auto& [a, b, c] = triangle;
    const dvec3 ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
    const double d1 = glm::dot(ab, ap), d2 = glm::dot(ac, ap), d3 = glm::dot(ab, bp), d4 = glm::dot(ac, bp),
                 d5 = glm::dot(ab, cp), d6 = glm::dot(ac, cp);
    if (d1 <= 0.0 && d2 <= 0.0) return a;
    if (d3 >= 0.0 && d4 <= d3) return b;
    if (d6 >= 0.0 && d5 <= d6) return c;
    const double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return a + ab * (d1 / (d1 - d3));
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return a + ac * (d2 / (d2 - d6));
    if (va <= 0.0 && d4 >= d3 && d5 >= d6) return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
    const double total = va + vb + vc;
    return a + ab * (vb / total) + ac * (vc / total);
}

}  // namespace

std::size_t Globe::shapeOf(const Scene& scene) {
    auto planet = std::ranges::find_if(
        scene.shapes, [](const Shape& shape) { return std::holds_alternative<DisplacedSphere>(shape.geometry); });
    return planet == scene.shapes.end() ? 0 : std::size_t(planet - scene.shapes.begin());
}

Globe::Globe(const Shape& shape, const NodeGrid* nodes, const Relief& relief)
    : nodes_(nodes),
      relief_(reliefOf(shape, relief)),
      world_from_object_(shape.world_from_object),
      object_from_world_(glm::inverse(shape.world_from_object)),
      solid_(std::holds_alternative<DisplacedSphere>(shape.geometry)) {
    const dmat4& m = shape.world_from_object;
    centre_ = dvec3(m[3]);
    double longest = 0.0;
    for (int axis = 0; axis < 3; ++axis) longest = std::max(longest, glm::length(dvec3(m[axis])));
    radius_ = relief_.greatest_radius * longest;
    north_ = glm::normalize(dvec3(m[1]));
    origin_ = glm::normalize(dvec3(m[2]));
    east_ = glm::normalize(dvec3(m[0]));
    if (const auto* mesh = std::get_if<TriangleMesh>(&shape.geometry)) takePieces(*mesh);
    if (const auto* disk = std::get_if<Disk>(&shape.geometry)) {
        disk_ = *disk;
        centre_ = transformPoint(m, dvec3(0.0, 0.0, disk->height));
    }
}

void Globe::takePieces(const TriangleMesh& mesh) {
    centre_ = transformPoint(world_from_object_, middleOf(mesh));
    radius_ = 0.0;
    for (const auto& corners : mesh.triangles) {
        Triangle& piece = pieces_.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
            piece[k] = transformPoint(world_from_object_, mesh.points[std::size_t(corners[k])]);
            radius_ = std::max(radius_, glm::length(piece[k] - centre_));
        }
    }
}

dvec3 Globe::objectDirection(const dvec3& world) const {
    return transformVector(object_from_world_, world);
}

double Globe::sampleAt(const dvec3& object_direction) const {
    const dvec3 d = glm::normalize(object_direction);
    const double colatitude = std::acos(std::clamp(d.y, -1.0, 1.0));
    return Interpolator(nodes_->map(), relief_.filter).at(std::atan2(d.x, d.z), colatitude).value;
}

double Globe::ground(const dvec3& direction) const {
    dvec3 object = objectDirection(glm::normalize(direction));
    double radius = relief_.base + (nodes_ ? relief_.scale * sampleAt(object) : 0.0);
    return radius / glm::length(object);
}

double Globe::altitude(const dvec3& point) const {
    double distance = glm::length(point - centre_);
    return distance > 0.0 ? distance - ground(point - centre_) : -radius_;
}

double Globe::distanceToDisk(const dvec3& point) const {
    dvec3 p = transformPoint(object_from_world_, point);
    dvec2 across(p.x, p.y);
    const double distance = glm::length(across);
    const double wanted = std::clamp(distance, disk_->inner_radius, disk_->radius);
    across = distance > 0.0 ? across * (wanted / distance) : dvec2(wanted, 0.0);
    return glm::length(point - transformPoint(world_from_object_, dvec3(across, disk_->height)));
}

double Globe::clearance(const dvec3& point) const {
    if (disk_) return distanceToDisk(point);
    if (round()) return solid_ ? altitude(point) : std::abs(altitude(point));
    double nearest = glm::length(point - centre_) + radius_;
    for (const Triangle& piece : pieces_)
        nearest = std::min(nearest, glm::length(point - closestOnTriangle(point, piece)));
    return nearest;
}

dvec3 Globe::direction(double latitude, double longitude) const {
    const double lat = glm::radians(latitude), lon = glm::radians(longitude);
    return glm::normalize(transformVector(
        world_from_object_, dvec3(std::cos(lat) * std::sin(lon), std::sin(lat), std::cos(lat) * std::cos(lon))));
}

Place Globe::placeOf(const dvec3& point) const {
    dvec3 object = objectDirection(point - centre_);
    dvec3 d = glm::normalize(object);
    Place place{glm::degrees(std::asin(std::clamp(d.y, -1.0, 1.0))), glm::degrees(std::atan2(d.x, d.z)), {}};
    if (nodes_) place.stored = nodes_->map().stored(sampleAt(object));
    return place;
}

Bodies::Bodies(std::vector<Globe> globes) : globes_(std::move(globes)) {
    for (const Globe& globe : globes_) middle_ += globe.centre() / double(globes_.size());
    for (const Globe& globe : globes_)
        reach_ = std::max(reach_, glm::length(globe.centre() - middle_) + globe.radius());
}

double Bodies::clearance(const dvec3& point) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Globe& globe : globes_) nearest = std::min(nearest, globe.clearance(point));
    return nearest;
}

// Strides of half the room, since ground may rise faster than it is near.
dvec3 Bodies::wayTo(const dvec3& from, const dvec3& to, double lowest, double share) const {
    struct Hold {
        const Globe* globe;
        double nearest;
    };
    std::vector<Hold> holds;
    for (const Globe& globe : globes_)
        if (const double clear = globe.clearance(from); clear > 0.0)
            holds.push_back({&globe, std::min(lowest * globe.radius(), share * clear)});
    const double length = glm::length(to - from);
    double done = 0.0;
    for (int i = 0; i < 200; ++i) {
        const dvec3 point = from + (to - from) * (done / length);
        double room = std::numeric_limits<double>::infinity();
        for (const Hold& hold : holds) room = std::min(room, hold.globe->clearance(point) - hold.nearest);
        if (room >= length - done) return to;
        if (room <= 1e-9 * length) break;
        done += 0.5 * room;
    }
    return from + (to - from) * (done / length);
}

dvec3 Bodies::outOfGround(const dvec3& eye, double lowest) const {
    dvec3 result = eye;
    for (const Globe& globe : globes_) {
        const dvec3 outward = result - globe.centre();
        const double distance = glm::length(outward);
        if (!globe.solid() || !(distance > 0.0)) continue;
        const double least = globe.ground(outward) + lowest * globe.radius();
        if (distance < least) result = globe.centre() + outward * (least / distance);
    }
    return result;
}

}  // namespace dsphere::viewer
