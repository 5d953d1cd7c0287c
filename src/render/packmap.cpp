#include "render/packmap.h"

#include <bit>
#include <cmath>

namespace dsphere {

namespace {

float leadingBits(double value) {
    return std::bit_cast<float>(std::bit_cast<std::uint32_t>(float(value)) & 0xfffff000u);
}

layout::vec4 splitEdge(double angle) {
    double sine = std::sin(angle), cosine = std::cos(angle);
    float lead_sine = leadingBits(sine), lead_cosine = leadingBits(cosine);
    return {lead_sine, lead_cosine, float(sine - lead_sine), float(cosine - lead_cosine)};
}

float versin(double angle) {
    double half = std::sin(0.5 * angle);
    return float(2.0 * half * half);
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
    data.cap_shift = nodes.halfCaps() ? 0.5f : 0.0f;
    double width = nodes.cellWidth(), height = nodes.cellHeight(), cap = nodes.colatitude(1);
    data.tan_width = float(std::tan(width));
    data.tan_height = float(std::tan(height));
    data.sin_width = float(std::sin(width));
    data.versin_width = versin(width);
    data.sin_height = float(std::sin(height));
    data.versin_height = versin(height);
    data.sin_cap = float(std::sin(cap));
    data.versin_cap = versin(cap);
    for (int i = 0; i < nodes.width(); ++i) packed.longitude_edges.push_back(splitEdge(nodes.longitude(i)));
    for (int j = 0; j < nodes.rows(); ++j) packed.colatitude_edges.push_back(splitEdge(nodes.colatitude(j)));
    return packed;
}

}  // namespace dsphere
