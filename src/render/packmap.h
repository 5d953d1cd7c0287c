#pragma once

#include "shaders/layout.h"
#include "surface/bounds.h"
#include "surface/nodes.h"

#include <vector>

namespace dsphere {

/// Shader view of one map but for its place in the images: data.heights_y, layer, nodes_y, nodes_layer, bounds_y,
/// bounds_layer, edges_y and what is said of tiles are 0.
struct PackedMap {
    layout::MapData data;
    /// Sine and cosine of the west edge of each column as floats, then what that rounding left of both.
    std::vector<layout::vec4> longitude_edges;
    std::vector<layout::vec4> colatitude_edges;  ///< the same of the north edge of each row
    /// Ripples: the same of the sines' arguments at those edges; the edges' next two rows. Else empty.
    std::vector<layout::vec4> longitude_phases, colatitude_phases;
};

PackedMap packMap(const NodeGrid& nodes, const Bounds& bounds, const Relief& relief);

}  // namespace dsphere
