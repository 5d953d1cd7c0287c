#pragma once

#include "bench/contender.h"
#include "bench/pixelsize.h"
#include "surface/interpolator.h"

#include <optional>

namespace dsphere::bench {

/// How photogrammetry intersects a ray with heights about a sphere, in double on the host: it goes from the ray's hit
/// with one sphere to that with the sphere of the radius found there. Nothing tells it what lies between, so that it
/// may come to rest on a later root, or on none.
class IteratedSearch {
  public:
    /// `secant`: each next point is where the line through the last two heights above the ground is 0. The workload
    /// must outlive it.
    IteratedSearch(const Workload& workload, bool secant);

    /// The t, world units, where two points in a row come within a hundredth of a pixel of each other. Nothing where a
    /// sphere is missed, or after 100 turns. Origin and direction in object space, which t = 1 in the world goes along.
    std::optional<double> find(const dvec3& origin, const dvec3& direction, const PixelSize& pixel) const;

  private:
    double groundRadius(const dvec3& p) const;

    Relief relief_;
    Interpolator heights_;
    double start_radius_;  ///< half-way between the least and the greatest: what a datum is to a planet
    bool secant_;
};

/// Camera rays alone: photogrammetry asks for no shadows. Uses all cores.
std::unique_ptr<Contender> makeIteratedContender(const Workload& workload, const View& view, bool secant);

}  // namespace dsphere::bench
