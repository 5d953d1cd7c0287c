#include "verify/nearby.h"

#include <cmath>

namespace dsphere::verify {

using reference::LightSample;

namespace {

std::vector<dvec3> axes(double step) {
    return {{step, 0, 0}, {-step, 0, 0}, {0, step, 0}, {0, -step, 0}, {0, 0, step}, {0, 0, -step}};
}

}  // namespace

std::vector<dvec3> ringOffsets(const dvec3& direction, double step) {
    dvec3 d = glm::normalize(direction);
    dvec3 e = glm::normalize(glm::cross(d, std::abs(d.x) < 0.6 ? dvec3(1, 0, 0) : dvec3(0, 1, 0)));
    dvec3 g = glm::cross(d, e);
    std::vector<dvec3> offsets;
    for (int k = 0; k < 8; ++k) offsets.push_back(step * (std::cos(kPi * k / 4) * e + std::sin(kPi * k / 4) * g));
    return offsets;
}

std::vector<dvec3> turned(const dvec3& direction, double angle) {
    std::vector<dvec3> directions = ringOffsets(direction, angle);
    for (dvec3& d : directions) d = glm::normalize(direction + d);
    return directions;
}

std::vector<LightSample> nearbySamples(const Scene& scene, const reference::Tracer& tracer,
                                       const reference::ShadingPoint& point, int k,
                                       const reference::SampleSource& source) {
    const Light& light = scene.lights[std::size_t(k)];
    if (std::holds_alternative<DistantLight>(light)) return {};
    std::vector<LightSample> samples;
    const dvec3& p = point.position;
    const dvec3& g = point.normals.geometric;
    const dvec2 u = source.pair(reference::lightPair(0, std::uint32_t(k)));
    auto add = [&](const dvec3& position, const dvec3& normal, const dvec2& numbers) {
        samples.push_back(tracer.lights().sample(k, position, normal, numbers));
    };
    if (std::holds_alternative<InfiniteLight>(light)) {
        // The frame about g, and the texel's choice.
        for (const dvec3& offset : axes(rounding::kViewTurn)) add(p, glm::normalize(g + offset), u);
        for (double step : {-1.0, -0.5, 0.5, 1.0})
            for (int axis = 0; axis < 2; ++axis) {
                dvec2 moved = u;
                moved[axis] = glm::clamp(u[axis] + step * rounding::kNumber, 0.0, 1.0 - 0x1p-25);
                add(p, g, moved);
            }
        return samples;
    }
    const dmat4& to_world = scene.shapes[std::size_t(point.shape)].world_from_object;
    const double reach = glm::length(p) + glm::length(transformVector(to_world, point.object_position));
    double step = rounding::kPosition * reach;
    const double distance = tracer.lights().sample(k, p, g, u).distance;
    if (std::holds_alternative<AreaLight>(light) && std::isfinite(distance))
        step += rounding::kTurn * distance;  // as good as a turn of the direction
    for (const dvec3& offset : axes(step)) add(p + offset, g, u);
    return samples;
}

std::vector<dvec3> nearbyTexturePlaces(const Scene& scene, const reference::Tracer& tracer,
                                       const reference::ShadingPoint& point, const dvec3& object_normal) {
    const Shape& shape = scene.shapes[std::size_t(point.shape)];
    double step = 0.0;
    if (textureAs<HeightRamp>(shape.material)) step = rounding::kObject;
    if (textureAs<Checkerboard>(shape.material)) step = rounding::kCoordinate;
    // A mesh's coordinates come from its corners', not from angles.
    if (textureAs<ImageMap>(shape.material) && std::holds_alternative<TriangleMesh>(shape.geometry))
        step = 2.0 * rounding::kObject;
    if (step == 0.0) return {};
    std::vector<dvec3> places = ringOffsets(object_normal, step * tracer.unit(point.shape));
    for (dvec3& place : places) place += point.object_position;
    return places;
}

}  // namespace dsphere::verify
