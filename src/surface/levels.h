#pragma once

// Levels of detail of a heightmap: the same ground with half the columns and rows, and how far off it is.

#include "surface/nodes.h"

#include <optional>

namespace dsphere {

/// The map at half its width and height. A texel (texel registration) is the mean of the four that it replaces; a node
/// (gridline) that of its neighbourhood under a tent two cells wide; both lie within the least and greatest of those.
/// The poles keep their values. Nothing where the counts of columns or rows are odd, or where NodeGrid would subdivide
/// the result again.
std::optional<Heightmap> halved(const Heightmap& map);

/// The map that the survey of one in its file made: at 1 / reduction of its width and height. Nothing where there is
/// none.
std::optional<Heightmap> reducedMap(const Heightmap& map);

/// The greatest difference between the surfaces of two grids of one sphere, in stored units. Both are bilinear between
/// the lines of either, so that it stands where two lines cross. Takes some 5 ns for each crossing, on all cores.
double greatestDifference(const NodeGrid& a, const NodeGrid& b);

}  // namespace dsphere
