#pragma once

#include <compare>

namespace dsphere {

/// Order as MARCHER_ of layout.h.
enum class Marcher { Exact, Naive, NaiveShell, Lipschitz };
inline constexpr int kMarcherCount = 4;

/// How rays find hits, and whether they look for shadows; a marcher alone stands for it with its defaults.
struct MarchMethod {
    Marcher marcher = Marcher::Exact;
    float threshold = 3e-6f;  ///< baselines: a hit where |p| - r falls under it, units of R
    float detail = 0.0f;      ///< exact: pixels that a level of detail may be off; 0: the map itself
    bool shadows = true;      ///< false: light fades beyond the horizons of mean spheres instead

    MarchMethod(Marcher chosen = Marcher::Exact, float hit_below = 3e-6f, float pixels = 0.0f)
        : marcher(chosen), threshold(hit_below), detail(pixels) {}
    auto operator<=>(const MarchMethod&) const = default;
};

}  // namespace dsphere
