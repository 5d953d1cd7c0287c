#pragma once

// The surface and its first hit a second time: in long double, from the contract's words, by dense sampling. Shares no
// code with the reference.

#include "reference/ray.h"
#include "surface/heightmap.h"

namespace dsphere::reference::test {

struct DenseHit {
    bool sampled = false;  ///< the ray comes within reach
    bool hit = false;
    long double t = 0.0L;        ///< the root, bisected to the last bit
    long double least_f = 0.0L;  ///< of all samples
};

class Oracle {
  public:
    Oracle(const Heightmap& map, const Relief& relief) : map_(&map), relief_(relief) {}

    long double f(long double x, long double y, long double z) const;
    long double f(const Ray& ray, long double t) const;  ///< at origin + t direction

    /// The first sample with f <= 0, of `samples` at equal distances on the part of the ray within `reach` of the
    /// centre. The ray starts outside.
    DenseHit search(const Ray& ray, double reach, int samples) const;

  private:
    long double node(int i, int j) const;
    long double spline(long double column, long double row) const;
    long double stored(long double u, long double v) const;

    const Heightmap* map_;
    Relief relief_;
};

}  // namespace dsphere::reference::test
