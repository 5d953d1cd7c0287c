#include "query/geography.h"

#include "base/error.h"

#include <cmath>

namespace dsphere::query {

LocalAxes::LocalAxes(double latitude, double longitude) {
    const double lat = glm::radians(latitude), lon = glm::radians(longitude);
    up = {std::cos(lat) * std::sin(lon), std::sin(lat), std::cos(lat) * std::cos(lon)};
    east = {std::cos(lon), 0.0, -std::sin(lon)};
    north = {-std::sin(lat) * std::sin(lon), std::cos(lat), -std::sin(lat) * std::cos(lon)};
}

Geography::Geography(const Scene& scene, const SceneMaps& maps, Frame frame) {
    const std::size_t body = bodyOf(scene);
    const Shape& shape = scene.shapes[body];
    frame_from_object_ = frame == Frame::Body ? dmat4(1.0) : shape.world_from_object;
    if (const auto* sphere = std::get_if<DisplacedSphere>(&shape.geometry)) {
        radius_ = sphere->radius;
        relief_ = maps.reliefs[body];
        heights_.emplace(*maps.maps[std::size_t(maps.map_of_shape[body])], relief_.filter);
    }
}

double Geography::groundRadius(double latitude, double longitude) const {
    const double turn = glm::radians(longitude);
    const double wrapped = std::atan2(std::sin(turn), std::cos(turn));
    return relief_.base + relief_.scale * heights_->at(wrapped, glm::radians(90.0 - latitude)).value;
}

dvec3 Geography::point(double latitude, double longitude, double altitude, Above above,
                       const std::string& where) const {
    if (!heights_) throwInvalid("{}: latitudes and longitudes need a displacedsphere, and the scene has none", where);
    if (std::abs(latitude) > 90.0) throwInvalid("{}: a latitude of {}, expected -90 to 90 degrees", where, latitude);
    const double ground =
        above == Above::Sphere || !std::isfinite(latitude + longitude) ? radius_ : groundRadius(latitude, longitude);
    return transformPoint(frame_from_object_, (ground + altitude) * LocalAxes(latitude, longitude).up);
}

dvec3 Geography::direction(double latitude, double longitude, double azimuth, double elevation) const {
    const LocalAxes axes(latitude, longitude);
    const double a = glm::radians(azimuth), e = glm::radians(elevation);
    return transformVector(frame_from_object_,
                           std::sin(e) * axes.up + std::cos(e) * (std::cos(a) * axes.north + std::sin(a) * axes.east));
}

}  // namespace dsphere::query
