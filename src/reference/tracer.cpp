#include "reference/tracer.h"

#include "base/overloads.h"
#include "reference/analytic.h"
#include "reference/mesh.h"

#include <cassert>
#include <cmath>

namespace dsphere::reference {

Tracer::Tracer(const Scene& scene, std::vector<const Heightmap*> maps, std::vector<Relief> reliefs,
               std::vector<const ColourMap*> images, const ColourMap* light_image)
    : scene_(&scene), images_(std::move(images)), lights_(scene, light_image) {
    assert(maps.size() == scene.shapes.size() && reliefs.size() == scene.shapes.size());
    surfaces_.resize(scene.shapes.size());
    for (std::size_t k = 0; k < scene.shapes.size(); ++k) {
        const Shape& shape = scene.shapes[k];
        object_from_world_.push_back(glm::inverse(shape.world_from_object));
        reflectors_.emplace_back(shape.material);
        if (scene.integrator.regularize) softened_.emplace_back(softened(shape.material));
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
    return std::visit(
        Overloads{[&](const DisplacedSphere&) { return reference::firstHit(*surface(shape), object_ray); },
                  [&](const Sphere& sphere) { return hitSphere(sphere.radius, object_ray); },
                  [&](const Disk& disk) { return hitDisk(disk, object_ray); },
                  [&](const TriangleMesh& mesh) { return hitMesh(mesh, object_ray); }},
        scene_->shapes[std::size_t(shape)].geometry);
}

WorldHit Tracer::worldHit(int shape, const FirstHit& hit, const dvec3& direction) const {
    if (!hit.hit) return {};
    const Shape& what = scene_->shapes[std::size_t(shape)];
    const auto* mesh = std::get_if<TriangleMesh>(&what.geometry);
    const bool flat = mesh || std::holds_alternative<Disk>(what.geometry);
    dvec3 normal = flat ? dvec3(0.0, 0.0, 1.0) : hit.position;
    if (mesh) normal = meshNormal(*mesh, nearestOnMesh(*mesh, hit.position).triangle);
    // A start at the very centre has no normal of its own: any will do.
    if (normal == dvec3(0.0)) normal = dvec3(0.0, 1.0, 0.0);
    if (const Surface* displaced = surface(shape); displaced && hit.position != dvec3(0.0))
        normal = displaced->gradient(hit.position);
    normal = glm::normalize(transformNormal(objectFromWorld(shape), glm::normalize(normal)));
    const dvec3 shading_normal = flat && glm::dot(normal, direction) > 0.0 ? -normal : normal;
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

WorldHit Tracer::firstHit(const dvec3& origin, const dvec3& direction, double t_max) const {
    FirstHit nearest;
    int shape = -1;
    for (int k = 0; k < int(scene_->shapes.size()); ++k) {
        Ray ray = objectRay(k, origin, direction);
        ray.t_max = t_max;
        const FirstHit hit = hitShape(k, ray);
        if (!hit.hit || (nearest.hit && hit.t() >= nearest.t())) continue;
        nearest = hit;
        shape = k;
    }
    return worldHit(shape, nearest, direction);
}

WorldHit Tracer::nextHit(int own_shape, const dvec3& own_object_start, const dvec3& direction) const {
    const dvec3 start = transformPoint(scene_->shapes[std::size_t(own_shape)].world_from_object, own_object_start);
    FirstHit nearest;
    int shape = -1;
    for (int k = 0; k < int(scene_->shapes.size()); ++k) {
        Ray ray = objectRay(k, start, direction);
        if (k == own_shape) ray.origin = own_object_start;
        ray.may_start_inside = false;
        const FirstHit hit = hitShape(k, ray);
        if (!hit.hit || (nearest.hit && hit.t() >= nearest.t())) continue;
        nearest = hit;
        shape = k;
    }
    return worldHit(shape, nearest, direction);
}

bool Tracer::occluded(const dvec3& origin, const dvec3& direction, double t_max, int own_shape,
                      const dvec3& own_object_origin, int emitter) const {
    for (int k = 0; k < int(scene_->shapes.size()); ++k) {
        if (k == emitter) continue;
        Ray ray = objectRay(k, origin, direction);
        if (k == own_shape) ray.origin = own_object_origin;
        ray.t_max = t_max;
        ray.may_start_inside = false;
        if (hitShape(k, ray).hit) return true;
    }
    return false;
}

double Tracer::unit(int shape) const {
    const auto ofMesh = [](const TriangleMesh& mesh) {
        double greatest = 0.0;
        for (const dvec3& p : mesh.points) greatest = std::max(greatest, glm::length(p - middleOf(mesh)));
        return greatest;
    };
    return std::visit(Overloads{[&](const DisplacedSphere&) { return surface(shape)->relief().greatest_radius; },
                                [](const Sphere& sphere) { return sphere.radius; },
                                [](const Disk& disk) { return disk.radius; }, ofMesh},
                      scene_->shapes[std::size_t(shape)].geometry);
}

dvec3 Tracer::middle(int shape) const {
    const auto* mesh = std::get_if<TriangleMesh>(&scene_->shapes[std::size_t(shape)].geometry);
    return mesh ? middleOf(*mesh) : dvec3(0.0);
}

dvec3 Tracer::beside(const ShadingPoint& point, double offset) const {
    const dmat3 linear(scene_->shapes[std::size_t(point.shape)].world_from_object);
    return point.object_position + offset * unit(point.shape) * glm::normalize(point.normals.geometric * linear);
}

ShadingPoint Tracer::shadingPoint(const WorldHit& hit, const dvec3& direction) const {
    return {.shape = hit.shape,
            .object_position = hit.object_position,
            .position = hit.position,
            .normals = {hit.shading_normal, hit.smooth_normal},
            .towards_viewer = -glm::normalize(direction)};
}

}  // namespace dsphere::reference
