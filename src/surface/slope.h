#pragma once

#include "surface/nodes.h"

namespace dsphere {

/// A proven bound of |grad f|, f(p) = |p| - r(p / |p|), r = base + scale * stored value, over all p outside the
/// surface; 1 for a smooth sphere. base and scale in any one unit. Uses all cores.
double gradientBound(const NodeGrid& nodes, double base, double scale);

}  // namespace dsphere
