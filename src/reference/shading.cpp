// The tracer's textures and direct light.

#include "base/overloads.h"
#include "reference/basis.h"
#include "reference/colour.h"
#include "reference/tracer.h"
#include "scene/ramps.h"

#include <cassert>
#include <cmath>

namespace dsphere::reference {
namespace {

// Chiang, Li and Burley 2019, "Taming the shadow terminator": the cosine with the geometric normal over the one that
// the smooth normal lets expect, 1 or more becoming 1, made smooth.
double terminatorShare(const Normals& normals, const dvec3& towards, double smooth_cosine) {
    if (normals.geometric == normals.smooth) return 1.0;
    const double expected = smooth_cosine * glm::dot(normals.geometric, normals.smooth);
    const double share = std::clamp(glm::dot(normals.geometric, towards) / std::max(expected, 1e-6), 0.0, 1.0);
    return share + share * share - share * share * share;
}

}  // namespace

dvec3 Tracer::reflectance(int shape, const dvec3& object_position) const {
    const Shape& what = scene_->shapes[std::size_t(shape)];
    const Texture* texture = textureOf(what.material);
    if (!texture) return dvec3(1.0);
    const auto ofHeight = [&](const HeightRamp& by_height) {
        const int ramp = findRamp(by_height.ramp);
        const Surface* displaced = surface(shape);
        assert(ramp >= 0 && displaced && "the parser lets ramps onto displaced spheres only, by known names");
        const dvec3 colour = rampColour(ramps()[std::size_t(ramp)], displaced->height(object_position));
        return glm::clamp(by_height.scale * colour, 0.0, 1.0);
    };
    const auto ofImage = [&](const ImageMap& image) {
        assert(std::size_t(shape) < images_.size() && images_[std::size_t(shape)] && "an image map needs its image");
        return imageColour(what, image, *images_[std::size_t(shape)], object_position);
    };
    const auto ofBoard = [&](const Checkerboard& board) {
        return checkerboardColour(board, surfaceUv(what, object_position));
    };
    return std::visit(
        Overloads{[](const ConstantColour& constant) { return constant.rgb; }, ofHeight, ofImage, ofBoard}, *texture);
}

dvec3 Tracer::emission(const ShadingPoint& point) const {
    dvec3 front = point.normals.geometric;
    if (std::holds_alternative<Disk>(scene_->shapes[std::size_t(point.shape)].geometry))
        front = transformNormal(objectFromWorld(point.shape), dvec3(0.0, 0.0, 1.0));
    return lights_.emission(point.shape, front, point.towards_viewer);
}

LightSample Tracer::lightSample(const ShadingPoint& point, int k, const SampleSource& source) const {
    return lights_.sample(k, point.position, point.normals.geometric, source.pair(lightPair(0, std::uint32_t(k))));
}

bool Tracer::seen(const ShadingPoint& point, int k, const LightSample& sample, const dvec3& start) const {
    const dvec3 world_start = transformPoint(scene_->shapes[std::size_t(point.shape)].world_from_object, start);
    const LightRay ray = lights_.shadowRay(k, sample, point.position, world_start);
    return glm::dot(ray.direction, point.normals.geometric) > 0.0 &&
           !occluded(world_start, ray.direction, ray.t_max, point.shape, start, lights_.emitter(k));
}

std::uint32_t Tracer::litLights(const ShadingPoint& point, const SampleSource& source) const {
    const dvec3 start = beside(point);
    std::uint32_t lit = 0;
    for (int k = 0; k < int(scene_->lights.size()) && k < 32; ++k)
        if (seen(point, k, lightSample(point, k, source), start)) lit |= 1u << k;
    return lit;
}

dvec3 Tracer::reflected(const ShadingPoint& point, const dvec3& l) const {
    return reflected(point, l, reflectance(point.shape, point.object_position));
}

dvec3 Tracer::reflected(const ShadingPoint& point, const dvec3& l, const dvec3& colour) const {
    if (!(glm::dot(point.normals.geometric, l) > 0.0)) return dvec3(0.0);
    const Basis basis(point.normals.smooth);
    const dvec3 local = basis.toLocal(l);
    if (!(local.z > 0.0)) return dvec3(0.0);
    return reflector(point).f(local, basis.toLocal(point.towards_viewer), colour) *
           (local.z * terminatorShare(point.normals, l, local.z));
}

dvec3 Tracer::directLight(const ShadingPoint& point, const SampleSource& source, std::uint32_t lit) const {
    dvec3 sum = emission(point);
    for (int k = 0; k < int(scene_->lights.size()) && k < 32; ++k)
        if (lit >> k & 1u) {
            const LightSample sample = lightSample(point, k, source);
            sum += reflected(point, sample.direction) * sample.weight;
        }
    return sum;
}

}  // namespace dsphere::reference
