#pragma once

#include "image/rawmap.h"
#include "scene/scene.h"

namespace dsphere {

/// What is done with a file's map before its samples are heights, each with a notice in `map.notices`:
/// - Samples that are NaN, infinite or at the end of float's range become NaN and count as unknown. That is a warning
///   unless the scene or the file said that some values are.
/// - A last column that repeats the first, as maps on grid lines have it, is left out. Where nothing tells the
///   registration and the shape is that of such a map (2 H - 1 columns of H rows), it becomes gridline.
/// - Nothing is done about a common nodata value far below all others, nor about the shape of a map on grid lines
///   without the repeated column, but they are told.
void prepareMap(RawMap& map, const DisplacedSphere& shape);

}  // namespace dsphere
