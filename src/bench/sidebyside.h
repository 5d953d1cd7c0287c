#pragma once

// The exact marcher beside a mesh of the same map, camera and sun: what one would see in a renderer that tessellates.

#include "base/image.h"
#include "bench/workload.h"

namespace dsphere::gpu {
class Device;
}

namespace dsphere::bench {

struct SideBySide {
    /// Three columns: the exact marcher, Embree's full-resolution triangles, their difference. Upper row: normals as
    /// colours, angle between them; lower row: white matte under the sun, with its shadow. The differences are linear,
    /// white at kWhiteDegrees and kWhiteShade.
    Image picture;
    double median_degrees = 0.0, greatest_degrees = 0.0;  ///< between the normals where both hit
    double mean_shade = 0.0;                              ///< mean absolute difference of the shades where both hit
    std::uint64_t hits = 0;                               ///< pixels that both hit
    std::uint64_t one_sided = 0;                          ///< that one alone hits
    std::uint64_t other_shadow = 0;                       ///< that differ in shadow
};

inline constexpr double kWhiteDegrees = 10.0, kWhiteShade = 0.2;

/// Of the workload's first view. Error (Failure) without Embree; (InvalidInput) for surfaces that are not bilinear.
SideBySide drawSideBySide(gpu::Device& device, const Workload& workload);

}  // namespace dsphere::bench
