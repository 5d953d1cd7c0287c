#include "reference/tracer.h"

#include "reference/analytic.h"
#include "reference/colour.h"
#include "scene/ramps.h"

#include <cassert>
#include <cmath>

namespace dsphere::reference {

namespace {

// Chiang, Li and Burley 2019, "Taming the shadow terminator": the cosine with the geometric normal over the one that
// the smooth normal lets expect, 1 or more becoming 1, made smooth.
double terminatorShare(const Tracer::Normals& normals, const dvec3& towards, double smooth_cosine) {
    if (normals.geometric == normals.smooth) return 1.0;
    const double expected = smooth_cosine * glm::dot(normals.geometric, normals.smooth);
    const double share = std::clamp(glm::dot(normals.geometric, towards) / std::max(expected, 1e-6), 0.0, 1.0);
    return share + share * share - share * share * share;
}

}  // namespace

LightRay lightRay(const Light& light, const dvec3& world_point) {
    if (const auto* distant = std::get_if<DistantLight>(&light))
        return {distant->direction, std::numeric_limits<double>::infinity()};
    return {std::get<PointLight>(light).position - world_point, 1.0};
}

Tracer::Tracer(const Scene& scene, std::vector<const Heightmap*> maps, std::vector<Relief> reliefs,
               std::vector<const ColourMap*> images)
    : scene_(&scene), images_(std::move(images)) {
    assert(maps.size() == scene.shapes.size() && reliefs.size() == scene.shapes.size());
    surfaces_.resize(scene.shapes.size());
    for (std::size_t k = 0; k < scene.shapes.size(); ++k) {
        const Shape& shape = scene.shapes[k];
        object_from_world_.push_back(glm::inverse(shape.world_from_object));
        if (!std::holds_alternative<DisplacedSphere>(shape.geometry)) continue;
        assert(maps[k] && "a displaced sphere needs its map");
        surfaces_[k].emplace(*maps[k], reliefs[k]);
    }
}

const Surface* Tracer::surface(int shape) const {
    const std::optional<Surface>& surface = surfaces_[std::size_t(shape)];
    return surface ? &*surface : nullptr;
}

Ray Tracer::objectRay(int shape, const dvec3& origin, const dvec3& direction) const {
    const dmat4& object_from_world = objectFromWorld(shape);
    return {.origin = transformPoint(object_from_world, origin),
            .direction = transformVector(object_from_world, direction)};
}

FirstHit Tracer::hitShape(int shape, const Ray& object_ray) const {
    if (const Surface* displaced = surface(shape)) return reference::firstHit(*displaced, object_ray);
    const auto& geometry = scene_->shapes[std::size_t(shape)].geometry;
    if (const auto* sphere = std::get_if<Sphere>(&geometry)) return hitSphere(sphere->radius, object_ray);
    return hitDisk(std::get<Disk>(geometry), object_ray);
}

WorldHit Tracer::worldHit(int shape, const FirstHit& hit, const dvec3& direction) const {
    if (!hit.hit) return {};
    const Shape& what = scene_->shapes[std::size_t(shape)];
    const bool disk = std::holds_alternative<Disk>(what.geometry);
    dvec3 normal = disk ? dvec3(0.0, 0.0, 1.0) : hit.position;
    // A start at the very centre has no normal of its own: any will do.
    if (normal == dvec3(0.0)) normal = dvec3(0.0, 1.0, 0.0);
    if (const Surface* displaced = surface(shape); displaced && hit.position != dvec3(0.0))
        normal = displaced->gradient(hit.position);
    normal = glm::normalize(transformNormal(objectFromWorld(shape), glm::normalize(normal)));
    const dvec3 shading_normal = disk && glm::dot(normal, direction) > 0.0 ? -normal : normal;
    dvec3 smooth_normal = shading_normal;
    if (const Surface* displaced = surface(shape); displaced && hit.position != dvec3(0.0))
        smooth_normal = glm::normalize(transformNormal(objectFromWorld(shape), displaced->shadingNormal(hit.position)));
    return {.hit = true,
            .inside = hit.inside,
            .shape = shape,
            .t_low = hit.t_low,
            .t_high = hit.t_high,
            .t_root = hit.t_root,
            .position = transformPoint(what.world_from_object, hit.position),
            .object_position = hit.position,
            .normal = normal,
            .shading_normal = shading_normal,
            .smooth_normal = smooth_normal};
}

WorldHit Tracer::firstHit(const dvec3& origin, const dvec3& direction) const {
    FirstHit nearest;
    int shape = -1;
    for (int k = 0; k < int(scene_->shapes.size()); ++k) {
        const FirstHit hit = hitShape(k, objectRay(k, origin, direction));
        if (!hit.hit || (nearest.hit && hit.t() >= nearest.t())) continue;
        nearest = hit;
        shape = k;
    }
    return worldHit(shape, nearest, direction);
}

bool Tracer::occluded(const dvec3& origin, const dvec3& direction, double t_max, int own_shape,
                      const dvec3& own_object_origin) const {
    for (int k = 0; k < int(scene_->shapes.size()); ++k) {
        Ray ray = objectRay(k, origin, direction);
        if (k == own_shape) ray.origin = own_object_origin;
        ray.t_max = t_max;
        ray.may_start_inside = false;
        if (hitShape(k, ray).hit) return true;
    }
    return false;
}

dvec3 Tracer::reflectance(int shape, const dvec3& object_position) const {
    const Shape& what = scene_->shapes[std::size_t(shape)];
    const Texture& texture = *textureOf(what.material);
    if (const auto* constant = std::get_if<ConstantColour>(&texture)) return constant->rgb;
    if (const auto* picture = std::get_if<ImageMap>(&texture)) {
        assert(std::size_t(shape) < images_.size() && images_[std::size_t(shape)] && "an image map needs its image");
        return imageColour(what, *picture, *images_[std::size_t(shape)], object_position);
    }
    const int ramp = findRamp(std::get<HeightRamp>(texture).ramp);
    const Surface* displaced = surface(shape);
    assert(ramp >= 0 && displaced && "the parser lets ramps onto displaced spheres only, by known names");
    return rampColour(ramps()[std::size_t(ramp)], displaced->height(object_position));
}

dvec3 Tracer::shade(int shape, const dvec3& object_position, const Normals& normals, std::uint32_t lit) const {
    const dvec3 point = transformPoint(scene_->shapes[std::size_t(shape)].world_from_object, object_position);
    return shadeAt(shape, object_position, point, normals, lit);
}

dvec3 Tracer::shadeAt(int shape, const dvec3& object_position, const dvec3& point, const Normals& normals,
                      std::uint32_t lit) const {
    dvec3 irradiance(0.0);
    for (std::size_t k = 0; k < scene_->lights.size() && k < 32; ++k) {
        if (!(lit >> k & 1u)) continue;
        const dvec3 towards = lightRay(scene_->lights[k], point).direction;
        const double distance2 = glm::dot(towards, towards);
        if (distance2 == 0.0) continue;
        const double smooth_cosine = std::max(0.0, glm::dot(normals.smooth, towards) / std::sqrt(distance2));
        const double cosine = smooth_cosine * terminatorShare(normals, towards / std::sqrt(distance2), smooth_cosine);
        if (const auto* light = std::get_if<PointLight>(&scene_->lights[k]))
            irradiance += light->intensity * (cosine / distance2);
        else
            irradiance += std::get<DistantLight>(scene_->lights[k]).radiance * cosine;
    }
    return reflectance(shape, object_position) / kPi * irradiance;
}

}  // namespace dsphere::reference
