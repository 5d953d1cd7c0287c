#pragma once

#include "query/refine.h"

#include <cstddef>
#include <span>

namespace dsphere::query {

/// A hit as the device found it, in single floats.
struct FoundHit {
    const QueryRay* ray = nullptr;
    dvec3 position{0.0};
};

/// Same as findRoot() for many hits of one shape: places[i] is that of hits[i]. On a bilinear displaced sphere, what
/// nearly all hits need, which is one step of Newton's on one patch, is done side by side in SIMD lanes, some times
/// faster.
void findRoots(std::span<Place> places, const ShapeFrame& shape, std::span<const FoundHit> hits);

}  // namespace dsphere::query
