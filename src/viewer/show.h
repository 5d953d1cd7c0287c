#pragma once

#include "render/method.h"

#include <cstdint>
#include <iterator>

namespace dsphere::viewer {

/// What of the first hits the window shows; the order of SHOW_ in displaylayout.h.
enum class Show { Colour, Heights, Slope, Graticule, Distance, Normal, Uv, Albedo, Steps, Residual };
inline constexpr int kShowCount = 10;
extern const char* const kShowNames[kShowCount];

/// The marchers' names, in the order of Marcher.
inline constexpr const char* kMarcherNames[] = {"exact", "naive", "naive-shell", "lipschitz"};
static_assert(std::size(kMarcherNames) == kMarcherCount);

/// The film planes that it takes.
std::uint32_t planesOf(Show show);

/// How the picture is made: what a change of makes it anew.
struct ViewSettings {
    MarchMethod method;
    bool split = false;    ///< the naive marcher on the left, `method` on the right
    double divider = 0.5;  ///< where between them, as a share of the width
    Show show = Show::Colour;

    bool operator==(const ViewSettings&) const = default;
};

/// How it is coloured: a change costs no ray.
struct ToneSettings {
    float exposure = 0.0f;      ///< stops
    float most_steps = 100.0f;  ///< the reddest of the steps
    float most_slope = 45.0f;   ///< the reddest of the slopes, degrees

    bool operator==(const ToneSettings&) const = default;
};

/// What the scales of colours and the lines range over. Heights are in the map's unit.
struct ShownRange {
    double near = 0.0, far = 1.0;  ///< distances, world units
    double least_height = 0.0, greatest_height = 1.0;
    double contour_spacing = 1.0;
    double graticule_spacing = 15.0;  ///< degrees
};

}  // namespace dsphere::viewer
