#pragma once

#include "surface/blocks.h"
#include "surface/bounds.h"

namespace dsphere {

/// Fills the horizons of `bounds` (see Bounds), whose pyramid stands, from slopes nearby and the maxima beyond.
/// `blocks` are those of the relief's surface. Uses all cores.
///
/// Let a ray rise from p by the angle e above the horizontal plane there. Above a point of the ground at the angle x
/// from p, seen from the centre, it has the radius |p| cos e / cos(e + x), which grows at least as exp(x tan e). The
/// ground's grows at most as exp(K x) within a neighbourhood whose slope |grad r| / r is at most K, and is at most M
/// within a larger one. So the ray meets nothing if tan e > K, and, from the angle x on at which it may have left the
/// first neighbourhood, if tan e > (cos x - m / M) / sin x, m <= |p|. Both are asked of ever larger neighbourhoods of
/// cells of the cube map; the least tangent that suffices counts.
void fillHorizons(Bounds& bounds, const NodeGrid& nodes, const Relief& relief, const BlockExtremes& blocks);

}  // namespace dsphere
