#pragma once

#include "shaders/layout.h"
#include "surface/bounds.h"
#include "surface/nodes.h"

#include <vector>

namespace dsphere {

/// Shader view of one map but for its place in the images: data.heights_y, layer, bounds_y, bounds_layer, edges_y are 0.
struct PackedMap {
    layout::MapData data;
    std::vector<glm::dvec4> longitude_edges;   ///< `width` of (sin, cos) west then east edge
    std::vector<glm::dvec4> colatitude_edges;  ///< `rows` of (sin, cos) north then south edge
};

PackedMap packMap(const NodeGrid& nodes, const Bounds& bounds);

}  // namespace dsphere
