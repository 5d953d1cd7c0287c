#pragma once

#include "bench/embree.h"
#include "bench/workload.h"

namespace dsphere::bench {

/// A mesh's hits are off its facets by the rounding of o + t d; so far above them, in R, no ray meets the facet it
/// leaves.
inline constexpr double kMeshOffset = 4e-6;

/// Camera rays of the view's pixels in that order, in the planet's object space in units of R; t stays the world's
/// distance.
RaySet cameraRays(const Workload& workload, const View& view, const std::vector<std::uint32_t>& order);

/// Error (InvalidInput) for surfaces that a mesh of the map's nodes does not approach.
void requireNodes(const Workload& workload);

}  // namespace dsphere::bench
