#pragma once

#include "render/method.h"

#include <cstdint>

namespace dsphere::viewer {

/// What of the first hits the window shows; the order of SHOW_ in displaylayout.h.
enum class Show { Colour, Steps, Distance, Normal, Uv, Albedo, Residual };
inline constexpr int kShowCount = 7;
extern const char* const kShowNames[kShowCount];

/// The marchers' names, in the order of Marcher.
inline constexpr const char* kMarcherNames[] = {"exact", "naive", "naive-shell", "lipschitz"};

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

    bool operator==(const ToneSettings&) const = default;
};

}  // namespace dsphere::viewer
