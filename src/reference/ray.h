#pragma once

// The rays that the reference takes and the answers that it gives; object space unless said otherwise.

#include "base/math.h"

#include <limits>

namespace dsphere::reference {

/// The points origin + t direction, t_min <= t <= t_max. `direction` has any length: t is in units of it. A zero or
/// non-finite direction, a non-finite origin or t_min, or an empty range of t is a ray that misses everything.
struct Ray {
    dvec3 origin{0.0}, direction{0.0, 0.0, 1.0};
    double t_min = 0.0, t_max = std::numeric_limits<double>::infinity();
    /// Camera rays (true): starting inside or on the solid is a hit at t_min, flagged `inside`. Secondary rays (false):
    /// only a step from f > 0 to f < 0 is a hit; a ray that starts at f <= 0 and rises out of the solid goes on, one
    /// that goes down first, or does not come out before t_max, hits at t_min.
    bool may_start_inside = true;
};

enum class Verdict { Hit, Miss, Tangent };

struct FirstHit {
    /// Tangent only from `classify`: whether the ray itself hits is then told by `hit`.
    Verdict verdict = Verdict::Miss;
    bool hit = false;
    bool inside = false;  ///< the ray starts in the solid and the hit is its start
    /// Encloses the root, in units of |direction|: the sign of f changes in between. t_low = t_high = t_min if
    /// `inside`.
    double t_low = std::numeric_limits<double>::infinity(), t_high = std::numeric_limits<double>::infinity();
    double t_root = std::numeric_limits<double>::infinity();  ///< the likeliest t in the enclosure
    /// The root itself, within a few 1e-15 R of the surface even where t, for an origin 1e6 R away, is not.
    dvec3 position{0.0};
    /// Only from `classify`, of a ray that misses: the least f along it, to 1e-12 R, and where; infinite beyond 1e100
    /// R.
    double least_f = std::numeric_limits<double>::infinity(), least_t = std::numeric_limits<double>::infinity();

    double t() const { return t_root; }
};

}  // namespace dsphere::reference
