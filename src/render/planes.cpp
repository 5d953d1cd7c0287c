#include "render/planes.h"

#include "base/error.h"

#include <array>

namespace dsphere {

namespace {

constexpr std::array<PlaneInfo, PLANE_COUNT> kPlanes{{
    {PLANE_R, "R", false},
    {PLANE_G, "G", false},
    {PLANE_B, "B", false},
    {PLANE_A, "A", false},
    {PLANE_T, "t", false},
    {PLANE_PX, "P.X", false},
    {PLANE_PY, "P.Y", false},
    {PLANE_PZ, "P.Z", false},
    {PLANE_NX, "N.X", false},
    {PLANE_NY, "N.Y", false},
    {PLANE_NZ, "N.Z", false},
    {PLANE_NSX, "Ns.X", false},
    {PLANE_NSY, "Ns.Y", false},
    {PLANE_NSZ, "Ns.Z", false},
    {PLANE_U, "u", false},
    {PLANE_V, "v", false},
    {PLANE_ALBEDO_R, "Albedo.R", false},
    {PLANE_ALBEDO_G, "Albedo.G", false},
    {PLANE_ALBEDO_B, "Albedo.B", false},
    {PLANE_ID, "id", true},
    {PLANE_LIT, "lit", true},
    {PLANE_STEPS, "steps", true},
    {PLANE_RESIDUAL, "residual", false},
    {PLANE_OBJECT_PX, "object.X", false},
    {PLANE_OBJECT_PY, "object.Y", false},
    {PLANE_OBJECT_PZ, "object.Z", false},
    {PLANE_START_X, "start.X", false},
    {PLANE_START_Y, "start.Y", false},
    {PLANE_START_Z, "start.Z", false},
    {PLANE_FLAGS, "flags", true},
}};

constexpr bool areInOrder() {
    for (int i = 0; i < PLANE_COUNT; ++i)
        if (kPlanes[std::size_t(i)].plane != i) return false;
    return true;
}
static_assert(areInOrder(), "one entry per PLANE_ of layout.h, in the order of their numbers");

/// "P" of "P.X".
std::string_view aovOf(const PlaneInfo& info) {
    const std::string_view channel = info.channel;
    return channel.substr(0, channel.find('.'));
}

bool isAov(const PlaneInfo& info) {
    return (planeBit(info.plane) & kAovPlanes) != 0;
}

}  // namespace

std::span<const PlaneInfo> planeInfos() {
    return kPlanes;
}

std::string aovNames(std::string_view separator) {
    std::string names;
    std::string_view last;
    for (const PlaneInfo& info : kPlanes) {
        if (!isAov(info) || aovOf(info) == last) continue;
        last = aovOf(info);
        names += fmt::format("{}{}", names.empty() ? "" : separator, last);
    }
    return names;
}

std::uint32_t parseAovs(std::string_view list) {
    if (list.empty()) return 0;
    if (list == "all") return kAovPlanes;
    std::uint32_t mask = 0;
    while (!list.empty()) {
        std::size_t comma = std::min(list.find(','), list.size());
        std::string_view word = list.substr(0, comma);
        std::uint32_t found = 0;
        for (const PlaneInfo& info : kPlanes)
            if (isAov(info) && aovOf(info) == word) found |= planeBit(info.plane);
        if (!found)
            throw Error(ExitCode::Usage,
                        fmt::format("--aov: unknown output '{}'; there are all, {}", word, aovNames(", ")));
        mask |= found;
        list.remove_prefix(std::min(comma + 1, list.size()));
    }
    return mask;
}

}  // namespace dsphere
