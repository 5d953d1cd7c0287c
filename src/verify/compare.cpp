#include "verify/compare.h"

#include "base/overloads.h"
#include "reference/mesh.h"
#include "verify/nearby.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace dsphere::verify {

using reference::WorldHit;

namespace {

double floatUlp(double t) {
    float value = std::abs(float(t));
    return double(std::nextafter(value, std::numeric_limits<float>::infinity())) - double(value);
}

std::string describe(const Answer& answer, const WorldHit& truth) {
    auto side = [](bool hit, int shape, bool inside, double t) {
        return hit ? fmt::format("shape {}{} at t = {:.9g}", shape + 1, inside ? " (inside)" : "", t)
                   : std::string("a miss");
    };
    return fmt::format("device: {}; reference: {}", side(answer.hit, answer.shape, answer.inside, answer.t),
                       side(truth.hit, truth.shape, truth.inside, truth.hit ? truth.t() : 0.0));
}

}  // namespace

Comparison::Comparison(const Scene& scene, const SceneMaps& maps, Tolerance tolerance)
    : scene_(scene),
      tolerance_(tolerance),
      tracer_(scene, maps.perShape(), maps.reliefs, maps.imagePerShape(), maps.lightImage()) {}

dvec3 Comparison::objectNormal(int shape, const dvec3& object_position) const {
    const auto ofMesh = [&](const TriangleMesh& mesh) {
        return reference::meshNormal(mesh, reference::nearestOnMesh(mesh, object_position).triangle);
    };
    return std::visit(Overloads{[&](const DisplacedSphere&) { return tracer_.surface(shape)->normal(object_position); },
                                [&](const Sphere&) { return glm::normalize(object_position); },
                                [](const Disk&) { return dvec3(0.0, 0.0, 1.0); }, ofMesh},
                      scene_.shapes[std::size_t(shape)].geometry);
}

// A hit at a distance of delta from the surface stands some delta / |cos| before or behind its root; 4 allows for the
// surface's bend in between.
double Comparison::alongRayBound(const WorldRay& ray, const Answer& answer, const WorldHit& hit) const {
    double off = contract::kAlongRay;
    if (tolerance_ == Tolerance::Approximate && !answer.inside) off = std::max(off, 4.0 * surfaceDistance(answer));
    dvec3 d = transformVector(tracer_.objectFromWorld(hit.shape), ray.direction);
    double across = std::abs(glm::dot(objectNormal(hit.shape, hit.object_position), d));
    return off * unit(hit.shape) / std::max(across, 1e-300) + 2.0 * floatUlp(answer.t);
}

Comparison::Judgement Comparison::judge(const WorldRay& ray, const Answer& answer, const WorldHit& truth,
                                        double& share) const {
    share = 0.0;
    if (!answer.hit && !truth.hit) return Judgement::Right;
    // Of several shapes that hold the start any is first.
    if (answer.inside && truth.inside && answer.t == truth.t() &&
        tracer_.hitShape(answer.shape, tracer_.objectRay(answer.shape, ray.origin, ray.direction)).inside)
        return Judgement::Right;
    if (answer.hit != truth.hit || answer.shape != truth.shape || answer.inside != truth.inside)
        return Judgement::WrongVerdict;
    double error = answer.t - truth.t();
    share = std::abs(error) / alongRayBound(ray, answer, truth);
    if (share <= 1.0) return Judgement::Right;
    if (share <= 10.0) return Judgement::AlongRay;
    return error > 0.0 ? Judgement::LaterRoot : Judgement::WrongVerdict;
}

std::vector<dvec3> Comparison::sidewaysOffsets(int shape, const reference::Ray& object_ray) const {
    std::vector<dvec3> offsets;
    if (const reference::Surface* surface = tracer_.surface(shape)) {
        for (const reference::Ray& moved : reference::sidewaysRays(*surface, object_ray))
            offsets.push_back(moved.origin - object_ray.origin);
    } else {  // no gradient worth following
        offsets = ringOffsets(object_ray.direction, contract::kSideways * unit(shape));
    }
    const dmat4& to_world = scene_.shapes[std::size_t(shape)].world_from_object;
    for (dvec3& offset : offsets) offset = transformVector(to_world, offset);
    return offsets;
}

// The contract's definition: a ray moved sideways by at most 1e-6 R gives the device's answer.
bool Comparison::tangent(const WorldRay& ray, const Answer& answer, int true_shape) const {
    for (int shape : {answer.shape, true_shape}) {
        if (shape < 0) continue;
        reference::Ray object_ray = tracer_.objectRay(shape, ray.origin, ray.direction);
        std::vector<dvec3> offsets = sidewaysOffsets(shape, object_ray);
        // Peaks can be thinner than the angle between those: straight down into the one that the device hit, and up
        // over the one that it missed.
        auto addRadial = [&](const dvec3& p, double sign) {
            dvec3 d = glm::normalize(object_ray.direction), across = p - glm::dot(p, d) * d;
            double length = glm::length(across);
            if (!(length > 0.0)) return;
            for (double step : {1.0, 0.5})
                offsets.push_back(transformVector(scene_.shapes[std::size_t(shape)].world_from_object,
                                                  sign * step * contract::kSideways * unit(shape) / length * across));
        };
        if (shape == answer.shape) addRadial(answer.object_position, -1.0);
        if (shape == true_shape) addRadial(tracer_.hitShape(shape, object_ray).position, 1.0);
        if (ray.rounded_ends) {
            const double along = contract::kSideways * unit(shape) / glm::length(object_ray.direction);
            offsets.push_back(along * ray.direction);
            offsets.push_back(-along * ray.direction);
        }
        for (const dvec3& offset : offsets) {
            WorldRay moved{ray.origin + offset, ray.direction, ray.t_max, ray.rounded_ends};
            double share;
            WorldHit truth = tracer_.firstHit(moved.origin, moved.direction, moved.t_max);
            if (judge(moved, answer, truth, share) == Judgement::Right) return true;
        }
    }
    return false;
}

WorldHit Comparison::checkHit(Report& report, std::uint64_t index, const WorldRay& ray, const Answer& answer) const {
    WorldHit truth = tracer_.firstHit(ray.origin, ray.direction, ray.t_max);
    double share = 0.0;
    Judgement judgement = judge(ray, answer, truth, share);
    ++report.rays;
    report.hits += answer.hit ? 1 : 0;
    if (judgement == Judgement::Right) {
        report.worst_along_ray = std::max(report.worst_along_ray, share);
    } else if (tangent(ray, answer, truth.shape)) {
        ++report.tangent;
    } else {
        report.addFault(index, describe(answer, truth));
        if (judgement == Judgement::WrongVerdict) ++report.wrong_verdicts;
        if (judgement == Judgement::LaterRoot) ++report.later_roots;
        if (judgement == Judgement::AlongRay) ++report.along_ray_faults;
    }
    if (answer.hit && !answer.inside) checkSurface(report, ray, answer);
    return truth;
}

double Comparison::surfaceDistance(const Answer& answer) const {
    const dvec3& p = answer.object_position;
    const auto fromDisplaced = [&](const DisplacedSphere&) {
        const reference::Surface& surface = *tracer_.surface(answer.shape);
        return std::abs(surface.f(p)) / glm::length(surface.gradient(p));
    };
    const double distance = std::visit(
        Overloads{fromDisplaced, [&](const Sphere& sphere) { return std::abs(glm::length(p) - sphere.radius); },
                  [&](const Disk& disk) { return std::abs(p.z - disk.height); },
                  [&](const TriangleMesh& mesh) { return reference::nearestOnMesh(mesh, p).distance; }},
        scene_.shapes[std::size_t(answer.shape)].geometry);
    return distance / unit(answer.shape);
}

void Comparison::checkSurface(Report& report, const WorldRay& ray, const Answer& answer) const {
    const dvec3& p = answer.object_position;
    report.distances.push_back(float(surfaceDistance(answer)));

    dvec3 n = transformNormal(tracer_.objectFromWorld(answer.shape), objectNormal(answer.shape, p));
    const auto& geometry = scene_.shapes[std::size_t(answer.shape)].geometry;
    bool flat = std::holds_alternative<Disk>(geometry) || std::holds_alternative<TriangleMesh>(geometry);
    if (flat && glm::dot(n, ray.direction) > 0.0) n = -n;
    auto angleTo = [&](const dvec3& found) {
        const bool unit_length = std::abs(glm::length(found) - 1.0) < 1e-5;
        if (!unit_length) return 180.0f;  // no direction at all
        return float(glm::degrees(std::atan2(glm::length(glm::cross(n, found)), glm::dot(n, found))));
    };
    report.normal_degrees.push_back(angleTo(answer.normal));
    if (!answer.smooth_normal) return;
    const reference::Surface* surface = tracer_.surface(answer.shape);
    if (surface && surface->relief().smooth_normals)
        n = transformNormal(tracer_.objectFromWorld(answer.shape), surface->shadingNormal(p));
    report.normal_degrees.push_back(angleTo(*answer.smooth_normal));
}

}  // namespace dsphere::verify
