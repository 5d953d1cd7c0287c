#pragma once

// What is known of square blocks of a grid's cells: least and greatest stored value, and the steepest slope.

#include "surface/cubecells.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace dsphere {

/// Over square blocks of the grid's cells, both edges' nodes included.
struct BlockExtremes {
    int shift = 0;              ///< a block is 2^shift cells wide and high
    int columns = 0, rows = 0;  ///< blocks, the last perhaps smaller
    std::vector<float> least, greatest;
    /// At least the greatest slope of the surface, on a sphere of radius 1: stored units per radian of arc.
    std::vector<float> steepest;

    std::size_t index(int i, int j) const { return std::size_t(j) * std::size_t(columns) + std::size_t(i); }
};

/// Blocks of 2^shift cells of a grid, with no values yet: least infinite, greatest -infinite, steepest 0.
BlockExtremes emptyBlocks(const NodeGrid& nodes, int shift);

/// Of the surface that `filter` makes of a map in memory (of a spline by its Bezier points), or of ripples. Uses all
/// cores.
BlockExtremes measureBlocks(const NodeGrid& nodes, Filter filter);

/// Of the B-spline whose control points are the nodes, from the blocks of the bilinear surface through them: not the
/// least and greatest that it has, but what its control points have.
BlockExtremes splineBlocks(const BlockExtremes& of_nodes, const NodeGrid& nodes);

/// Calls `visit(index)` for each block that has a cell among the nodes of a box.
template <typename Visit>
void visitBlocks(const BlockExtremes& blocks, const NodeGrid& nodes, const NodeBox& box, const Visit& visit) {
    const auto visitColumns = [&](int first, int end) {
        for (int bj = box.top >> blocks.shift; bj <= (box.bottom - 1) >> blocks.shift; ++bj)
            for (int bi = first >> blocks.shift; bi <= (end - 1) >> blocks.shift; ++bi) visit(blocks.index(bi, bj));
    };
    const int end = box.first + box.count;
    visitColumns(box.first, std::min(end, nodes.width()));
    if (end > nodes.width()) visitColumns(0, end - nodes.width());
}

/// What turns differences between the nodes of one row of cells into slopes, per radian of arc. In longitude that is at
/// most the greatest difference over the shorter of the row's two circles. In a row that touches a pole it is (D theta'
/// / height) / sin theta', theta' the angle from the pole and D the difference on the row's circle: greatest on that
/// circle too, because theta' / sin theta' grows.
struct RowSlopes {
    float across, down;

    RowSlopes(const NodeGrid& nodes, int row);
};

/// Raises squares[i] to the squared slope of cell i of a row at least; `north` and `south` are the `width` nodes of its
/// edges, and columns wrap.
template <typename North, typename South>
void raiseSlopes(const RowSlopes& slopes, const North* north, const South* south, int width, float* squares) {
    const auto squareOf = [&](int i, int next) {
        const float nw = float(north[i]), ne = float(north[next]), sw = float(south[i]), se = float(south[next]);
        const float north_east = std::abs(ne - nw), south_east = std::abs(se - sw);
        const float west_down = std::abs(sw - nw), east_down = std::abs(se - ne);
        const float east = slopes.across * (north_east > south_east ? north_east : south_east);
        const float down = slopes.down * (west_down > east_down ? west_down : east_down);
        return east * east + down * down;
    };
    constexpr int kLanes = 8;  // side by side, so that they become vectors
    int i = 0;
    for (; i + kLanes < width; i += kLanes) {
        float lanes[kLanes];
        for (int k = 0; k < kLanes; ++k) lanes[k] = squareOf(i + k, i + k + 1);
        for (int k = 0; k < kLanes; ++k) squares[i + k] = squares[i + k] > lanes[k] ? squares[i + k] : lanes[k];
    }
    for (; i < width; ++i) squares[i] = std::max(squares[i], squareOf(i, i + 1 == width ? 0 : i + 1));
}

/// Raises the blocks' steepest slopes in one row of blocks to those of `squares`, of all columns of cells.
void raiseSteepest(BlockExtremes& blocks, int row, const std::vector<float>& squares);

}  // namespace dsphere
