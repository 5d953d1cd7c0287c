#pragma once

#include <compare>

namespace dsphere {

/// Order as MARCHER_ of layout.h.
enum class Marcher { Exact, Naive, NaiveShell, Lipschitz };

/// How rays find hits; a marcher alone stands for it with its defaults.
struct MarchMethod {
    Marcher marcher = Marcher::Exact;
    float threshold = 3e-6f;  ///< baselines: a hit where |p| - r falls under it, units of R

    MarchMethod(Marcher chosen = Marcher::Exact, float hit_below = 3e-6f) : marcher(chosen), threshold(hit_below) {}
    auto operator<=>(const MarchMethod&) const = default;
};

}  // namespace dsphere
