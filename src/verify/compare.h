#pragma once

#include "reference/tracer.h"
#include "surface/scenemaps.h"
#include "verify/report.h"

#include <limits>
#include <optional>

namespace dsphere::verify {

/// What the device says of one ray. Object space is in object units here, not in units of R.
struct Answer {
    bool hit = false, inside = false;
    int shape = -1;
    double t = 0.0;  ///< along the unit world direction
    dvec3 object_position{0.0};
    dvec3 normal{0.0};                     ///< world
    std::optional<dvec3> smooth_normal{};  ///< the shading normal, if it was asked for
};

/// What the device says of the light at a hit.
struct LightAnswer {
    dvec3 start{0.0};  ///< P', object units
    std::uint32_t lit = 0;
    dvec3 position{0.0}, colour{0.0};  ///< world P; direct light
    reference::SampleSource source;    ///< the pixel whose numbers the lights' samples took
};

struct WorldRay {
    dvec3 origin, direction;  ///< direction is unit
    double t_max = std::numeric_limits<double>::infinity();
    bool rounded_ends = false;  ///< where it begins and ends is as uncertain as where it passes
};

/// Whether a light's direction at a point is given, not drawn.
bool isLamp(const Light& light);

/// Holds a device's answers against the reference, one ray at a time. Thread-safe; reports go to the caller's.
class Comparison {
  public:
    /// Whether the contract holds, or what a method that approximates is worth: then a hit that lies off the surface
    /// may be as far off along the ray as that explains, and only another root is a fault.
    enum class Tolerance { Contract, Approximate };

    /// Scene and maps must outlive it.
    Comparison(const Scene& scene, const SceneMaps& maps, Tolerance tolerance = Tolerance::Contract);

    /// Verdict, root, distance to the surface and normal of one ray. Returns the reference's answer.
    reference::WorldHit checkHit(Report& report, std::uint64_t index, const WorldRay& ray, const Answer& answer) const;
    /// Shadow verdicts, then the colour at the device's own P, N and verdicts.
    void checkLight(Report& report, std::uint64_t index, const WorldRay& ray, const Answer& answer,
                    const LightAnswer& light) const;

    /// What a ray that misses sees, where the scene has a sky.
    void checkMiss(Report& report, std::uint64_t index, const WorldRay& ray, const dvec3& colour) const;

    /// The verdict on light `k` alone: whether its sample is seen from P'. A sample without light is not judged.
    void checkShadow(Report& report, std::uint64_t index, const Answer& answer, const LightAnswer& light,
                     std::size_t k) const;

    /// The greatest radius R of a shape, object units: the length that is 1 on the device.
    double unit(int shape) const { return tracer_.unit(shape); }
    /// A point in the device's object space, in object units.
    dvec3 objectPoint(int shape, const dvec3& on_device) const {
        return tracer_.middle(shape) + unit(shape) * on_device;
    }
    const reference::Tracer& tracer() const { return tracer_; }

  private:
    enum class Judgement { Right, WrongVerdict, LaterRoot, AlongRay };

    dvec3 objectNormal(int shape, const dvec3& object_position) const;
    double alongRayBound(const WorldRay& ray, const Answer& answer, const reference::WorldHit& hit) const;
    double surfaceDistance(const Answer& answer) const;  ///< units of R
    Judgement judge(const WorldRay& ray, const Answer& answer, const reference::WorldHit& truth, double& share) const;
    /// World offsets that move a ray sideways by at most 1e-6 R of the shape.
    std::vector<dvec3> sidewaysOffsets(int shape, const reference::Ray& object_ray) const;
    bool tangent(const WorldRay& ray, const Answer& answer, int true_shape) const;
    void checkSurface(Report& report, const WorldRay& ray, const Answer& answer) const;
    bool tangentShadow(const Answer& answer, const LightAnswer& light, const WorldRay& shadow, double t_max,
                       int emitter, bool device_lit) const;
    bool roundedShadow(const reference::ShadingPoint& point, const LightAnswer& light, int k,
                       const reference::LightSample& sample, bool device_lit) const;
    dvec3 reflectanceSpread(const Answer& answer) const;

    /// The reference's colour, and how far off a right one may be.
    struct Shade {
        dvec3 colour{0.0}, bound{0.0};
    };
    bool isPlain(int shape) const;
    Shade plainShade(const reference::ShadingPoint& point, const Answer& answer, const LightAnswer& light) const;
    Shade fullShade(const reference::ShadingPoint& point, const LightAnswer& light) const;
    /// `of`: what has the colour, for the message.
    void judgeColour(Report& report, std::uint64_t index, const dvec3& found, const Shade& truth,
                     const std::string& of) const;

    const Scene& scene_;
    Tolerance tolerance_;
    reference::Tracer tracer_;
};

}  // namespace dsphere::verify
