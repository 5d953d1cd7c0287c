#include "viewer/globe.h"

#include "surface/ripples.h"

#include <algorithm>
#include <cmath>

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

}  // namespace

std::size_t Globe::shapeOf(const Scene& scene) {
    auto planet = std::ranges::find_if(
        scene.shapes, [](const Shape& shape) { return std::holds_alternative<DisplacedSphere>(shape.geometry); });
    return planet == scene.shapes.end() ? 0 : std::size_t(planet - scene.shapes.begin());
}

Globe::Globe(const Shape& shape, const NodeGrid* nodes, const Relief& relief)
    : nodes_(nodes), relief_(reliefOf(shape, relief)), object_from_world_(glm::inverse(shape.world_from_object)) {
    const dmat4& m = shape.world_from_object;
    centre_ = dvec3(m[3]);
    double longest = 0.0;
    for (int axis = 0; axis < 3; ++axis) longest = std::max(longest, glm::length(dvec3(m[axis])));
    radius_ = relief_.greatest_radius * longest;
    north_ = glm::normalize(dvec3(m[1]));
    origin_ = glm::normalize(dvec3(m[2]));
    east_ = glm::normalize(dvec3(m[0]));
}

dvec3 Globe::objectDirection(const dvec3& world) const {
    return transformVector(object_from_world_, world);
}

double Globe::rippleAt(const dvec3& object_direction) const {
    dvec3 d = glm::normalize(object_direction);
    const Heightmap& map = nodes_->map();
    double phase = ripplePhase(map, std::atan2(d.x, d.z));
    double fall = map.ripples->v_frequency * std::acos(std::clamp(d.y, -1.0, 1.0));
    return 0.5 + 0.5 * std::sin(phase) * std::sin(fall);
}

// Bilinear between the nodes, also under a spline, of which that is within a texel's rise; a cap row is half as high.
double Globe::storedAt(const dvec3& object_direction) const {
    if (nodes_->map().ripples) return rippleAt(object_direction);
    dvec3 d = glm::normalize(object_direction);
    double colatitude = std::acos(std::clamp(d.y, -1.0, 1.0));
    double column = nodes_->column(std::atan2(d.x, d.z)), row = nodes_->nodeRow(colatitude);
    int j = std::clamp(int(std::floor(row)), 0, nodes_->rows() - 1), width = nodes_->width();
    double north = nodes_->colatitude(j), south = nodes_->colatitude(j + 1);
    double fv = std::clamp((colatitude - north) / (south - north), 0.0, 1.0);
    double left = std::floor(column), fu = column - left;
    auto wrapped = [&](double i) { return std::size_t(std::fmod(std::fmod(i, width) + width, width)); };
    std::size_t i0 = wrapped(left), i1 = wrapped(left + 1.0);
    const float *above = nodes_->row(j), *below = nodes_->row(j + 1);
    return (1.0 - fv) * ((1.0 - fu) * above[i0] + fu * above[i1]) + fv * ((1.0 - fu) * below[i0] + fu * below[i1]);
}

double Globe::ground(const dvec3& direction) const {
    dvec3 object = objectDirection(glm::normalize(direction));
    double radius = relief_.base + (nodes_ ? relief_.scale * storedAt(object) : 0.0);
    return radius / glm::length(object);
}

double Globe::altitude(const dvec3& point) const {
    double distance = glm::length(point - centre_);
    return distance > 0.0 ? distance - ground(point - centre_) : -radius_;
}

Place Globe::placeOf(const dvec3& point) const {
    dvec3 object = objectDirection(point - centre_);
    dvec3 d = glm::normalize(object);
    Place place{glm::degrees(std::asin(std::clamp(d.y, -1.0, 1.0))), glm::degrees(std::atan2(d.x, d.z)), {}};
    if (nodes_) place.stored = storedAt(object);
    return place;
}

}  // namespace dsphere::viewer
