#pragma once

#include "surface/nodes.h"

#include <array>

namespace dsphere {

/// The four basis functions of the uniform cubic B-spline at t in [0, 1], and their slopes.
struct SplineWeights {
    std::array<double, 4> value, slope;

    explicit SplineWeights(double t);
};

/// The uniform bicubic B-spline whose control points are a map's values, at the nodes of a grid: within a cell of the
/// grid it is a bicubic polynomial, which the value, the two slopes and the twist at the cell's four corners determine.
/// Columns wrap. Rows of texel registration are clamped, and in the caps heights run linearly in latitude from the pole
/// to the spline on the first row's circle. Gridline registration has no caps: beyond the pole's row, which is
/// constant, the next row is mirrored through it, so that the spline meets the pole's value from all sides.
class SplineNodes {
  public:
    /// Value, slope eastward, slope southward and twist: stored units, per cell of the grid.
    using Node = std::array<float, 4>;

    /// Keeps a reference to the grid (of a map, not of ripples), which must outlive this.
    explicit SplineNodes(const NodeGrid& nodes) : nodes_(nodes) {}

    /// width() nodes, row 0 to rows(). In the caps slopes southward and twists are 0: two rows' difference is what
    /// counts.
    std::vector<Node> row(int j) const;
    /// One node of row j: also of a map that stays in its file.
    Node at(int i, int j) const;

    /// For each node the greatest (or least) of the Bezier points about it, in all four cells that meet there: over a
    /// cell the spline does not exceed the extremes of its corners. Row-major, rows() + 1 rows.
    std::vector<float> extremes(bool greatest) const;

  private:
    const NodeGrid& nodes_;
};

}  // namespace dsphere
