#pragma once

// Where light comes from, and one sample of it at a time: docs/light.md defines both.

#include "reference/skyimage.h"
#include "scene/scene.h"

#include <limits>
#include <optional>

namespace dsphere::reference {

/// A shadow ray's direction from a world point and its end, in units of that direction's length.
struct LightRay {
    dvec3 direction;
    double t_max;  ///< infinite (unit direction) or 1 (the direction reaches the light)
};
/// Towards a point or distant light.
LightRay lightRay(const Light& light, const dvec3& world_point);

/// The light of one direction. A surface adds f cos(n, l) weight.
struct LightSample {
    dvec3 direction{0.0};                                       ///< l: world, unit; 0: there is none
    double distance = std::numeric_limits<double>::infinity();  ///< to the light
    dvec3 weight{0.0};                                          ///< L / p; a point or distant light's irradiance
    double density = 0.0;                                       ///< p per steradian; 0: a point or distant light
};

/// Refers to scene and image, which must outlive it; thread-safe.
class Lights {
  public:
    /// `image` is the infinite light's; nullptr: it has none.
    explicit Lights(const Scene& scene, const ColourMap* image = nullptr);

    /// Light k's sample seen from `point` (world) with the geometric normal `g` on the viewer's side, by two numbers in
    /// [0, 1).
    LightSample sample(int k, const dvec3& point, const dvec3& g, const dvec2& u) const;
    /// The density with which `sample` draws a direction (unit), whether or not anything is in between; 0 where it
    /// never does, and of point and distant lights.
    double density(int k, const dvec3& point, const dvec3& g, const dvec3& direction) const;
    /// The ray that tells whether the sample that was drawn at `point` is seen from `start` beside it.
    LightRay shadowRay(int k, const LightSample& sample, const dvec3& point, const dvec3& start) const;
    /// The shape that shines as light k, which throws no shadow on its own light; -1: none does.
    int emitter(int k) const;

    /// What a ray that misses everything sees.
    dvec3 environment(const dvec3& direction) const;
    /// What a shape sends in a direction by itself; `normal` is world and outward (a disk's +z).
    dvec3 emission(int shape, const dvec3& normal, const dvec3& towards_viewer) const;

  private:
    struct Ball {
        dvec3 centre;
        double radius;
    };
    struct Ring {
        dvec3 normal;
        double area;
    };

    Ball ball(const AreaLight& light) const;
    Ring ring(const AreaLight& light) const;
    LightSample sampleBall(const AreaLight& light, const dvec3& point, const dvec2& u) const;
    LightSample sampleDisk(const AreaLight& light, const dvec3& point, const dvec2& u) const;
    double densityOfDisk(const AreaLight& light, const dvec3& point, const dvec3& direction) const;
    double densityOfBall(const AreaLight& light, const dvec3& point, const dvec3& direction) const;
    LightSample sampleSky(const InfiniteLight& light, const dvec3& g, const dvec2& u) const;

    const Scene* scene_;
    std::optional<SkyImage> sky_;
};

}  // namespace dsphere::reference
