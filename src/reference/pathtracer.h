#pragma once

// What the device's pictures converge to: an unbiased estimate in double, by another estimator and other random
// numbers.

#include "base/image.h"
#include "reference/pixelfilter.h"
#include "reference/tracer.h"
#include "surface/scenemaps.h"

#include <random>

namespace dsphere::reference {

/// A mean over pixels and samples, and its standard error, both by channel.
struct Estimate {
    dvec3 mean{0.0}, error{0.0};
};

/// The integrators of docs/light.md. At every vertex all lights are sampled, and the path goes on by a sample of the
/// material; light that both may meet is weighed by the balance heuristic. Paths end at maxdepth or in the open alone.
/// Refers to scene and maps, which must outlive it; thread-safe.
class PathTracer {
  public:
    using Random = std::mt19937_64;

    PathTracer(const Scene& scene, const SceneMaps& maps);

    /// Of the pixels of a region of the raster, `samples` of each, placed as the scene's filter weighs them; on all
    /// cores. The same numbers for the same seed. The error leaves out that pixels are strata: it is an upper bound.
    Estimate mean(const Box& region, int samples, std::uint64_t seed = 1) const;
    /// One sample of the radiance that comes against a camera ray.
    dvec3 sample(const dvec3& origin, const dvec3& direction, Random& random) const;

    const Tracer& tracer() const { return tracer_; }

  private:
    struct Step;

    dvec3 emitted(const WorldHit& hit, const Step& step) const;
    dvec3 sampledLights(const ShadingPoint& point, const dvec3& start, Random& random) const;
    bool isPath() const { return scene_->integrator.kind == Integrator::Kind::Path; }

    const Scene* scene_;
    FilterSampler filter_;
    Tracer tracer_;
};

}  // namespace dsphere::reference
