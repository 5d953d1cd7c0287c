// Light at a device's hits: shadow verdicts and colours.

#include "verify/compare.h"
#include "verify/nearby.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dsphere::verify {

using reference::LightRay;
using reference::LightSample;
using reference::ShadingPoint;

namespace {

ShadingPoint pointOf(const Answer& answer, const LightAnswer& light, const dvec3& towards_viewer) {
    return {.shape = answer.shape,
            .object_position = answer.object_position,
            .position = light.position,
            .normals = {answer.normal, answer.smooth_normal.value_or(answer.normal)},
            .towards_viewer = towards_viewer};
}

}  // namespace

bool isLamp(const Light& light) {
    return std::holds_alternative<DistantLight>(light) || std::holds_alternative<PointLight>(light);
}

bool Comparison::tangentShadow(const Answer& answer, const LightAnswer& light, const WorldRay& shadow, double t_max,
                               int emitter, bool device_lit) const {
    const dmat4& own_from_world = tracer_.objectFromWorld(answer.shape);
    for (int shape = 0; shape < int(scene_.shapes.size()); ++shape) {
        if (shape == emitter) continue;
        reference::Ray object_ray = tracer_.objectRay(shape, shadow.origin, shadow.direction);
        if (shape == answer.shape) object_ray.origin = light.start;
        object_ray.t_max = t_max;
        object_ray.may_start_inside = false;
        for (const dvec3& offset : sidewaysOffsets(shape, object_ray)) {
            bool blocked = tracer_.occluded(shadow.origin + offset, shadow.direction, t_max, answer.shape,
                                            light.start + transformVector(own_from_world, offset), emitter);
            if (blocked != device_lit) return true;
        }
    }
    return false;
}

// A sample is off by what its inputs' rounding brings about, and a sampled direction by a kTurn, which moves the ray at
// a far shape by more than any parallel shift: a right verdict on one of those is right.
bool Comparison::roundedShadow(const ShadingPoint& point, const LightAnswer& light, int k, const LightSample& sample,
                               bool device_lit) const {
    if (isLamp(scene_.lights[std::size_t(k)])) return false;
    for (const LightSample& near : nearbySamples(scene_, tracer_, point, k, light.source))
        if (tracer_.seen(point, k, near, light.start) == device_lit) return true;
    for (const dvec3& direction : turned(sample.direction, rounding::kTurn)) {
        LightSample near = sample;
        near.direction = direction;
        if (tracer_.seen(point, k, near, light.start) == device_lit) return true;
    }
    return false;
}

void Comparison::checkShadow(Report& report, std::uint64_t index, const Answer& answer, const LightAnswer& light,
                             std::size_t k) const {
    dvec3 start = transformPoint(scene_.shapes[std::size_t(answer.shape)].world_from_object, light.start);
    const ShadingPoint point = pointOf(answer, light, dvec3(0.0));
    const LightSample sample = tracer_.lightSample(point, int(k), light.source);
    const bool lamp = isLamp(scene_.lights[k]);
    if (!lamp && sample.weight == dvec3(0.0)) return;  // there is nothing to see: the bit may be anything
    LightRay towards = tracer_.lights().shadowRay(int(k), sample, light.position, start);
    const int emitter = tracer_.lights().emitter(int(k));
    bool device_lit = (light.lit >> k & 1u) != 0;
    double cosine = glm::dot(glm::normalize(towards.direction), answer.normal);
    bool lit = tracer_.seen(point, int(k), sample, light.start);
    ++report.shadow_rays;
    if (lit == device_lit) return;
    // A light in the tangent plane, to rounding: which side it is on is tangency too.
    bool grazing = std::abs(cosine) < contract::kSideways;
    if (grazing || roundedShadow(point, light, int(k), sample, device_lit) ||
        tangentShadow(answer, light, {start, towards.direction}, towards.t_max, emitter, device_lit)) {
        ++report.tangent_shadows;
        return;
    }
    ++report.wrong_shadows;
    report.addFault(index, fmt::format("light {}: device {}, reference {}, cos(N, L) = {:.3g}", k + 1,
                                       device_lit ? "lit" : "shadowed", lit ? "lit" : "shadowed", cosine));
}

// How much a shape's reflectance can change within the rounding of a float position: on a steep map a height ramp turns
// 5e-8 R sideways into 1e-4 of its colour.
dvec3 Comparison::reflectanceSpread(const Answer& answer) const {
    dvec3 centre = tracer_.reflectance(answer.shape, answer.object_position), spread(0.0);
    double step = rounding::kObject * unit(answer.shape);
    for (const dvec3& offset : ringOffsets(answer.object_position, step)) {
        dvec3 beside = tracer_.reflectance(answer.shape, answer.object_position + offset);
        spread = glm::max(spread, glm::abs(beside - centre));
    }
    return spread;
}

// Lambert's law under lamps. A cosine of two float vectors is off by a few 1e-7 whatever its size, hence the part of
// the bound that does not shrink towards the terminator.
Comparison::Shade Comparison::plainShade(const ShadingPoint& point, const Answer& answer,
                                         const LightAnswer& light) const {
    Shade shade{.colour = tracer_.directLight(point, light.source, light.lit)};
    dvec3 full(0.0);
    for (const Light& source : scene_.lights) {
        if (const auto* distant = std::get_if<DistantLight>(&source)) {
            full += distant->radiance;
        } else {
            const PointLight& lamp = std::get<PointLight>(source);
            const dvec3 towards = lamp.position - light.position;
            full += lamp.intensity / std::max(glm::dot(towards, towards), 1e-300);
        }
    }
    dvec3 reflectance = tracer_.reflectance(answer.shape, answer.object_position);
    const bool by_height = textureAs<HeightRamp>(scene_.shapes[std::size_t(answer.shape)].material) != nullptr;
    dvec3 spread = by_height ? reflectanceSpread(answer) : dvec3(0.0);
    for (int c = 0; c < 3; ++c) {
        double irradiance = reflectance[c] > 0.0 ? shade.colour[c] / reflectance[c] : full[c] / kPi;
        shade.bound[c] =
            contract::kColour * shade.colour[c] + 1e-6 * reflectance[c] * full[c] / kPi + spread[c] * irradiance;
    }
    return shade;
}

// Any material under any light: each input of a light's share moved by its rounding (nearby.h), one after the other,
// and the greatest changes added.
Comparison::Shade Comparison::fullShade(const ShadingPoint& point, const LightAnswer& light) const {
    Shade shade{.colour = tracer_.emission(point)};
    const dvec3 texture = tracer_.reflectance(point.shape, point.object_position);
    std::vector<dvec3> textures;
    for (const dvec3& place :
         nearbyTexturePlaces(scene_, tracer_, point, objectNormal(point.shape, point.object_position)))
        textures.push_back(tracer_.reflectance(point.shape, place));
    for (int k = 0; k < int(scene_.lights.size()) && k < 32; ++k) {
        if (!(light.lit >> k & 1u)) continue;
        const LightSample sample = tracer_.lightSample(point, k, light.source);
        const dvec3 share = tracer_.reflected(point, sample.direction, texture) * sample.weight;
        shade.colour += share;
        auto widen = [&](const auto& neighbours, auto valueAt) {
            dvec3 most(0.0);
            for (const auto& neighbour : neighbours) most = glm::max(most, glm::abs(valueAt(neighbour) - share));
            shade.bound += most;
        };
        widen(nearbySamples(scene_, tracer_, point, k, light.source),
              [&](const LightSample& near) { return tracer_.reflected(point, near.direction, texture) * near.weight; });
        widen(turned(sample.direction, rounding::kTurn),
              [&](const dvec3& l) { return tracer_.reflected(point, l, texture) * sample.weight; });
        widen(turned(point.towards_viewer, rounding::kViewTurn), [&](const dvec3& v) {
            ShadingPoint near = point;
            near.towards_viewer = v;
            return tracer_.reflected(near, sample.direction, texture) * sample.weight;
        });
        widen(textures,
              [&](const dvec3& near) { return tracer_.reflected(point, sample.direction, near) * sample.weight; });
    }
    shade.bound += contract::kColour * shade.colour;
    return shade;
}

bool Comparison::isPlain(int shape) const {
    const Shape& what = scene_.shapes[std::size_t(shape)];
    const auto* matte = std::get_if<Matte>(&what.material);
    return matte && matte->sigma == 0.0 && !std::holds_alternative<Checkerboard>(matte->reflectance) &&
           !std::holds_alternative<TriangleMesh>(what.geometry) && std::ranges::all_of(scene_.lights, isLamp);
}

void Comparison::judgeColour(Report& report, std::uint64_t index, const dvec3& found, const Shade& truth,
                             const std::string& of) const {
    ++report.colours;
    double worst = 0.0;
    for (int c = 0; c < 3; ++c) {
        const double error = std::abs(found[c] - truth.colour[c]);
        worst = std::max(worst, std::isfinite(error) ? error / (truth.bound[c] + 1e-30) : 1e30);
    }
    report.worst_colour = std::max(report.worst_colour, worst);
    if (worst <= 1.0) return;
    ++report.wrong_colours;
    report.addFault(index, fmt::format("colour of {}: device {:.7g} {:.7g} {:.7g}, reference {:.7g} {:.7g} {:.7g}", of,
                                       found.r, found.g, found.b, truth.colour.r, truth.colour.g, truth.colour.b));
}

void Comparison::checkLight(Report& report, std::uint64_t index, const WorldRay& ray, const Answer& answer,
                            const LightAnswer& light) const {
    for (std::size_t k = 0; k < scene_.lights.size() && k < 32; ++k) checkShadow(report, index, answer, light, k);
    const ShadingPoint point = pointOf(answer, light, -ray.direction);
    judgeColour(report, index, light.colour,
                isPlain(answer.shape) ? plainShade(point, answer, light) : fullShade(point, light),
                fmt::format("shape {}, lights {:b}", answer.shape + 1, light.lit));
}

void Comparison::checkMiss(Report& report, std::uint64_t index, const WorldRay& ray, const dvec3& colour) const {
    const bool sky = std::ranges::any_of(
        scene_.lights, [](const Light& light) { return std::holds_alternative<InfiniteLight>(light); });
    if (!sky) return;
    const reference::Lights& lights = tracer_.lights();
    Shade shade{.colour = lights.environment(ray.direction)};
    for (const dvec3& direction : turned(ray.direction, rounding::kTurn))
        shade.bound = glm::max(shade.bound, glm::abs(lights.environment(direction) - shade.colour));
    shade.bound += contract::kColour * shade.colour;
    judgeColour(report, index, colour, shade, "the sky");
}

}  // namespace dsphere::verify
