#include "surface/slope.h"

#include "surface/blocks.h"

#include <algorithm>
#include <cmath>

namespace dsphere {

// grad f = e_r - grad_S r / |p| with grad_S r across the radius, and |p| is at least the least radius.
double gradientBound(const NodeGrid& nodes, double base, double scale) {
    const BlockExtremes blocks = measureBlocks(nodes, Filter::Bilinear);
    const double least = std::ranges::min(blocks.least), greatest = std::ranges::max(blocks.greatest);
    const double least_radius = std::min(base + scale * least, base + scale * greatest);
    constexpr double kRounding = 1.0 + 1e-6;
    return kRounding * std::hypot(1.0, scale * double(std::ranges::max(blocks.steepest)) / least_radius);
}

}  // namespace dsphere
