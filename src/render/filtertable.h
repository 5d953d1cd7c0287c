#pragma once

#include "scene/scene.h"

#include <vector>

namespace dsphere {

/// How the device draws places along one axis of a pixel filter, in FILTER_INTERVALS intervals of equal probability,
/// each within one lobe of the kernel. A sample counts `weights` times, which makes up for lobes below 0: the mean of
/// all weights is 1, and where no lobe is negative all are 1.
struct FilterTable {
    std::vector<float> places;   ///< FILTER_INTERVALS + 1 ends of intervals, pixels from the centre, ascending
    std::vector<float> weights;  ///< of each interval
};
FilterTable filterTable(const PixelFilter& filter, double radius);

/// FILTER_BOX, FILTER_POSITIVE or FILTER_SIGNED, by what the tables must hold.
int filterKind(const PixelFilter& filter);

}  // namespace dsphere
