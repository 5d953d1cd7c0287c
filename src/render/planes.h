#pragma once

#include "shaders/layout.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace dsphere {

/// One film plane as a channel.
struct PlaneInfo {
    int plane;            ///< PLANE_
    const char* channel;  ///< EXR name
    bool is_uint;
};

/// All planes in layer order.
std::span<const PlaneInfo> planeInfos();

inline constexpr std::uint32_t planeBit(int plane) {
    return 1u << plane;
}
inline constexpr std::uint32_t kColourPlanes = 7u << PLANE_R;
inline constexpr std::uint32_t kAlphaPlane = planeBit(PLANE_A);
/// The arbitrary output variables that users may ask for: the planes from PLANE_OBJECT_PX on are for verify.
inline constexpr std::uint32_t kAovPlanes = (planeBit(PLANE_OBJECT_PX) - 1u) & ~(kColourPlanes | kAlphaPlane);
inline constexpr std::uint32_t kVerifyPlanes = (planeBit(PLANE_COUNT) - 1u) & ~kAlphaPlane;

/// What users call those planes, a word for all that it has: t, P, N, Ns, u, v, Albedo, id, ...
std::string aovNames(std::string_view separator);

/// "all", or a comma-separated list of aovNames(); "" is none. Error (Usage) names the unknown word.
std::uint32_t parseAovs(std::string_view list);

}  // namespace dsphere
