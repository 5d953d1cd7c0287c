#include "reference/lights.h"

#include "base/overloads.h"
#include "reference/analytic.h"
#include "reference/basis.h"

#include <algorithm>
#include <cmath>

namespace dsphere::reference {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

dvec3 polar(double sine, double cosine, double turns) {
    return {sine * std::cos(2.0 * kPi * turns), sine * std::sin(2.0 * kPi * turns), cosine};
}

/// 1 - cos of the half angle under which a ball is seen from outside: sin^2 / (1 + cos), which does not cancel.
double coneHeight(double radius, double distance) {
    const double cosine = std::sqrt((distance - radius) * (distance + radius)) / distance;
    return radius * radius / (distance * distance * (1.0 + cosine));
}

}  // namespace

LightRay lightRay(const Light& light, const dvec3& world_point) {
    if (const auto* distant = std::get_if<DistantLight>(&light)) return {distant->direction, kFar};
    return {std::get<PointLight>(light).position - world_point, 1.0};
}

Lights::Lights(const Scene& scene, const ColourMap* image) : scene_(&scene) {
    if (image) sky_.emplace(*image);
}

// An emitter's transform keeps angles: it is a length's factor, a turn, perhaps a mirror, and a move.
Lights::Ball Lights::ball(const AreaLight& light) const {
    const Shape& shape = scene_->shapes[std::size_t(light.shape)];
    return {dvec3(shape.world_from_object[3]),
            std::get<Sphere>(shape.geometry).radius * glm::length(dvec3(shape.world_from_object[0]))};
}

Lights::Ring Lights::ring(const AreaLight& light) const {
    const Shape& shape = scene_->shapes[std::size_t(light.shape)];
    const Disk& disk = std::get<Disk>(shape.geometry);
    const double scale = glm::length(dvec3(shape.world_from_object[0]));
    return {glm::normalize(dvec3(shape.world_from_object[2])),
            kPi * (disk.radius * disk.radius - disk.inner_radius * disk.inner_radius) * scale * scale};
}

LightSample Lights::sampleBall(const AreaLight& light, const dvec3& point, const dvec2& u) const {
    const Ball from = ball(light);
    const double distance = glm::distance(from.centre, point);
    if (!(distance > from.radius)) return {};
    const double whole = coneHeight(from.radius, distance), height = u.x * whole;
    const double sin2 = height * (2.0 - height), across2 = from.radius * from.radius - distance * distance * sin2;
    const Basis basis((from.centre - point) / distance);
    return {.direction = basis.toWorld(polar(std::sqrt(sin2), 1.0 - height, u.y)),
            .distance = distance * (1.0 - height) - std::sqrt(std::max(0.0, across2)),
            .weight = light.radiance * (2.0 * kPi * whole),
            .density = 1.0 / (2.0 * kPi * whole)};
}

LightSample Lights::sampleDisk(const AreaLight& light, const dvec3& point, const dvec2& u) const {
    const Shape& shape = scene_->shapes[std::size_t(light.shape)];
    const Disk& disk = std::get<Disk>(shape.geometry);
    const double inner2 = disk.inner_radius * disk.inner_radius;
    const double r = std::sqrt(inner2 + u.x * (disk.radius * disk.radius - inner2));
    const dvec3 towards = transformPoint(shape.world_from_object, polar(r, disk.height, u.y)) - point;
    const double distance2 = glm::dot(towards, towards);
    if (distance2 == 0.0) return {};
    const Ring from = ring(light);
    const dvec3 l = towards / std::sqrt(distance2);
    const double cosine = -glm::dot(from.normal, l);
    const double shown = light.two_sided ? std::abs(cosine) : std::max(0.0, cosine);
    return {.direction = l,
            .distance = std::sqrt(distance2),
            .weight = light.radiance * (from.area * shown / distance2),
            .density = distance2 / (from.area * std::abs(cosine))};
}

LightSample Lights::sampleSky(const InfiniteLight& light, const dvec3& g, const dvec2& u) const {
    if (!sky_) {
        const double cosine = std::sqrt(1.0 - u.x);
        return {.direction = Basis(g).toWorld(polar(std::sqrt(u.x), cosine, u.y)),
                .distance = kFar,
                .weight = light.radiance * (kPi / cosine),
                .density = cosine / kPi};
    }
    const SkyImage::Sample sample = sky_->sample(u);
    return {.direction = light.world_from_light * sample.direction,
            .distance = kFar,
            .weight = light.radiance * sky_->radiance(sample.direction) / sample.density,
            .density = sample.density};
}

LightSample Lights::sample(int k, const dvec3& point, const dvec3& g, const dvec2& u) const {
    const Light& light = scene_->lights[std::size_t(k)];
    const auto sampleLamp = [&](const PointLight& lamp) -> LightSample {
        const dvec3 towards = lamp.position - point;
        const double distance2 = glm::dot(towards, towards), distance = std::sqrt(distance2);
        if (distance2 == 0.0) return {};
        return {towards / distance, distance, lamp.intensity / distance2};
    };
    const auto sampleArea = [&](const AreaLight& area) {
        const bool disk = std::holds_alternative<Disk>(scene_->shapes[std::size_t(area.shape)].geometry);
        return disk ? sampleDisk(area, point, u) : sampleBall(area, point, u);
    };
    const auto sampleSun = [](const DistantLight& sun) -> LightSample { return {sun.direction, kFar, sun.radiance}; };
    return std::visit(
        Overloads{sampleSun, sampleLamp, [&](const InfiniteLight& sky) { return sampleSky(sky, g, u); }, sampleArea},
        light);
}

double Lights::density(int k, const dvec3& point, const dvec3& g, const dvec3& direction) const {
    const Light& light = scene_->lights[std::size_t(k)];
    const auto ofSky = [&](const InfiniteLight& sky) {
        if (sky_) return sky_->density(glm::transpose(sky.world_from_light) * direction);
        return std::max(0.0, glm::dot(g, direction)) / kPi;
    };
    const auto ofArea = [&](const AreaLight& area) {
        const bool disk = std::holds_alternative<Disk>(scene_->shapes[std::size_t(area.shape)].geometry);
        return disk ? densityOfDisk(area, point, direction) : densityOfBall(area, point, direction);
    };
    return std::visit(
        Overloads{[](const DistantLight&) { return 0.0; }, [](const PointLight&) { return 0.0; }, ofSky, ofArea},
        light);
}

double Lights::densityOfDisk(const AreaLight& light, const dvec3& point, const dvec3& direction) const {
    const Shape& shape = scene_->shapes[std::size_t(light.shape)];
    const dmat4 to_object = glm::inverse(shape.world_from_object);
    const FirstHit hit = hitDisk(std::get<Disk>(shape.geometry), {.origin = transformPoint(to_object, point),
                                                                  .direction = transformVector(to_object, direction)});
    const Ring from = ring(light);
    return hit.hit ? hit.t() * hit.t() / (from.area * std::abs(glm::dot(from.normal, direction))) : 0.0;
}

double Lights::densityOfBall(const AreaLight& light, const dvec3& point, const dvec3& direction) const {
    const Ball from = ball(light);
    const dvec3 axis = from.centre - point;
    const double distance = glm::length(axis);
    if (!(distance > from.radius) || !(glm::dot(axis, direction) > 0.0)) return 0.0;
    const bool within = glm::length(glm::cross(axis, direction)) <= from.radius;
    return within ? 1.0 / (2.0 * kPi * coneHeight(from.radius, distance)) : 0.0;
}

LightRay Lights::shadowRay(int k, const LightSample& sample, const dvec3& point, const dvec3& start) const {
    const Light& light = scene_->lights[std::size_t(k)];
    if (std::holds_alternative<PointLight>(light)) return lightRay(light, start);
    if (std::isinf(sample.distance)) return {sample.direction, kFar};
    return {point + sample.distance * sample.direction - start, 1.0};
}

int Lights::emitter(int k) const {
    const auto* area = std::get_if<AreaLight>(&scene_->lights[std::size_t(k)]);
    return area ? area->shape : -1;
}

dvec3 Lights::environment(const dvec3& direction) const {
    dvec3 sum(0.0);
    for (const Light& light : scene_->lights)
        if (const auto* infinite = std::get_if<InfiniteLight>(&light))
            sum += infinite->radiance *
                   (sky_ ? sky_->radiance(glm::transpose(infinite->world_from_light) * glm::normalize(direction))
                         : dvec3(1.0));
    return sum;
}

dvec3 Lights::emission(int shape, const dvec3& normal, const dvec3& towards_viewer) const {
    dvec3 sum(0.0);
    const bool front = glm::dot(normal, towards_viewer) > 0.0;
    for (const Light& light : scene_->lights)
        if (const auto* area = std::get_if<AreaLight>(&light); area && area->shape == shape)
            if (front || area->two_sided) sum += area->radiance;
    return sum;
}

}  // namespace dsphere::reference
