#pragma once

#include <algorithm>

namespace dsphere::reference {

/// An interval that holds a slope, or another number, over a part of the surface or of a chord.
struct SlopeRange {
    double least, greatest;
};

inline SlopeRange product(const SlopeRange& x, const SlopeRange& y) {
    const double p = x.least * y.least, q = x.least * y.greatest, r = x.greatest * y.least, s = x.greatest * y.greatest;
    return {std::min({p, q, r, s}), std::max({p, q, r, s})};
}

}  // namespace dsphere::reference
