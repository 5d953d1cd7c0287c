#pragma once

#include "image/rawmap.h"
#include "scene/scene.h"

#include <cmath>
#include <cstdint>

namespace dsphere {

/// Whether a stored value may be a height: a number that is not at the end of float's range.
inline bool isHeight(float stored) {
    // -3.4028235e38 is the most common value for "unknown" in float maps; some programs write fewer of its digits.
    constexpr float kLargestHeight = 3.39e38f;
    return std::abs(stored) < kLargestHeight;  // not so for NaN
}

/// What is done with a file's map before its samples are heights, each with a notice in `map.notices`:
/// - Samples that are no height (isHeight) become NaN and count as unknown. That is a warning unless the scene or the
///   file said that some values are.
/// - A last column that repeats the first, as maps on grid lines have it, is left out. Where nothing tells the
///   registration and the shape is that of such a map (2 H - 1 columns of H rows), it becomes gridline.
/// - Nothing is done about a common nodata value far below all others, nor about the shape of a map on grid lines
///   without the repeated column, but they are told.
void prepareMap(RawMap& map, const DisplacedSphere& shape);

/// Of a map's known texels, as stored.
struct LowestValues {
    float least, second_least, greatest;  ///< second_least: the least above `least`; infinite: there is none
    std::uint64_t at_least, texels;       ///< how many hold `least`; how many there are
};

/// Tells of a common nodata value far below all others that nothing declares.
void warnOfNodata(Notices& notices, const DisplacedSphere& shape, const LowestValues& values);

}  // namespace dsphere
