#pragma once

#include "shaders/layout.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace dsphere {

/// One film plane as a channel.
struct PlaneInfo {
    int plane;            ///< PLANE_
    const char* channel;  ///< EXR name
    bool is_uint;
};

/// All planes in layer order.
const std::vector<PlaneInfo>& planeInfos();

inline constexpr std::uint32_t planeBit(int plane) {
    return 1u << plane;
}
inline constexpr std::uint32_t kColourPlanes = 7u << PLANE_R;
inline constexpr std::uint32_t kAlphaPlane = planeBit(PLANE_A);
/// The arbitrary output variables that users may ask for; the planes beyond are for verify.
inline constexpr std::uint32_t kAovPlanes = (planeBit(PLANE_RESIDUAL + 1) - 1u) & ~(kColourPlanes | kAlphaPlane);
inline constexpr std::uint32_t kVerifyPlanes = (planeBit(PLANE_COUNT) - 1u) & ~kAlphaPlane;

/// "all", or a comma-separated list of t, P, N, Ns, u, v, Albedo, id, lit, steps, residual; "" is none. Error (Usage)
/// names the unknown word.
std::uint32_t parseAovs(std::string_view list);

}  // namespace dsphere
