#include "render/packmap.h"

#include <cmath>

namespace dsphere {

namespace {

// cos(pi / 2) of a double is 6e-17; the equator must be an exact plane.
double exactCos(double angle) {
    double value = std::cos(angle);
    return std::abs(value) < 1e-15 ? 0.0 : value;
}

glm::dvec4 edgePair(double first, double second) {
    return {std::sin(first), exactCos(first), std::sin(second), exactCos(second)};
}

}  // namespace

PackedMap packMap(const NodeGrid& nodes, const Bounds& bounds) {
    PackedMap packed;
    layout::MapData& data = packed.data;
    data = {};
    data.width = nodes.width();
    data.rows = nodes.rows();
    data.bounds_side = bounds.side;
    data.bounds_levels = bounds.levels;
    data.caps = nodes.halfCaps() ? 1 : 0;
    data.columns_per_turn = float(nodes.width());
    data.first_column = float(-nodes.column(0.0));
    data.cells_per_radian_u = float(1.0 / nodes.cellWidth());
    data.cells_per_radian_v = float(1.0 / nodes.cellHeight());
    data.tan_width = float(std::tan(nodes.cellWidth()));
    data.tan_height = float(std::tan(nodes.cellHeight()));
    data.cap_shift = nodes.halfCaps() ? 0.5f : 0.0f;
    for (int i = 0; i < nodes.width(); ++i)
        packed.longitude_edges.push_back(edgePair(nodes.longitude(i), nodes.longitude(i + 1)));
    for (int j = 0; j < nodes.rows(); ++j)
        packed.colatitude_edges.push_back(edgePair(nodes.colatitude(j), nodes.colatitude(j + 1)));
    return packed;
}

}  // namespace dsphere
