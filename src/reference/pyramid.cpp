#include "reference/pyramid.h"

#include <algorithm>
#include <limits>

namespace dsphere::reference {

namespace {

constexpr int kMostBlocks = 4;  // columns of blocks that a query reads at most

constexpr Range kEmpty{std::numeric_limits<float>::infinity(), -std::numeric_limits<float>::infinity()};

void include(Range& range, const Range& other) {
    range.least = std::min(range.least, other.least);
    range.greatest = std::max(range.greatest, other.greatest);
}

void include(Range& range, const Patch& patch) {
    // The corners are floats widened to double: narrowing them back is exact.
    include(range, Range{float(std::min({patch.nw, patch.ne, patch.sw, patch.se})),
                         float(std::max({patch.nw, patch.ne, patch.sw, patch.se}))});
}

int ceilDiv(int a, int b) {
    return (a + b - 1) / b;
}

}  // namespace

BoundsPyramid::Level BoundsPyramid::fromCells(const PatchGrid& grid, int columns, int rows) {
    Level level{ceilDiv(grid.columns(), columns), ceilDiv(grid.rows(), rows), {}};
    level.blocks.assign(std::size_t(level.columns) * std::size_t(level.rows), kEmpty);
    for (int j = 0; j < grid.rows(); ++j) {
        Range* row = level.blocks.data() + std::size_t(j / rows) * std::size_t(level.columns);
        for (int i = 0; i < grid.columns(); ++i) include(row[i / columns], grid.patch(i, j));
    }
    return level;
}

BoundsPyramid::Level BoundsPyramid::coarsen(const Level& fine, int columns, int rows) {
    Level level{ceilDiv(fine.columns, columns), ceilDiv(fine.rows, rows), {}};
    level.blocks.assign(std::size_t(level.columns) * std::size_t(level.rows), kEmpty);
    for (int j = 0; j < fine.rows; ++j) {
        Range* row = level.blocks.data() + std::size_t(j / rows) * std::size_t(level.columns);
        for (int i = 0; i < fine.columns; ++i) include(row[i / columns], fine.at(i, j));
    }
    return level;
}

BoundsPyramid::Level BoundsPyramid::fromBlocks(const BlockExtremes& extremes) {
    Level level{extremes.columns, extremes.rows, {}};
    for (std::size_t n = 0; n < extremes.least.size(); ++n)
        level.blocks.push_back({extremes.least[n], extremes.greatest[n]});
    return level;
}

BoundsPyramid::BoundsPyramid(const PatchGrid& grid) {
    const BlockExtremes* extremes = grid.blocks();
    finest_ = extremes ? extremes->shift : 0;
    for (int k = finest_;; ++k) {
        std::vector<Level> wide;
        if (k > finest_)
            wide.push_back(k == 1 ? fromCells(grid, 2, 2) : coarsen(levels_.back()[0], 2, 2));
        else if (extremes)
            wide.push_back(fromBlocks(*extremes));
        else
            wide.push_back({grid.columns(), grid.rows(), {}});
        while (wide.back().columns > kMostBlocks)
            wide.push_back(k == 0 && wide.size() == 1 ? fromCells(grid, 4, 1) : coarsen(wide.back(), 4, 1));
        levels_.push_back(std::move(wide));
        if (levels_.back()[0].rows <= 2) break;
    }
}

// Of a few patches, one by one.
Range BoundsPyramid::ofPatches(const PatchGrid& grid, int first_column, int last_column, int first_row, int last_row) {
    Range range = kEmpty;
    for (int j = first_row; j <= last_row; ++j)
        for (int i = first_column; i <= last_column; ++i) include(range, grid.patch(i, j));
    return range;
}

Range BoundsPyramid::strip(const PatchGrid& grid, int first_column, int last_column, int first_row,
                           int last_row) const {
    constexpr int kMostPatches = 32;
    if (finest_ > 0 && (last_column - first_column + 1) * (last_row - first_row + 1) <= kMostPatches)
        return ofPatches(grid, first_column, last_column, first_row, last_row);
    int k = finest_;
    while ((last_row >> k) - (first_row >> k) > 1) ++k;
    std::size_t m = 0;
    int shift = k;
    for (; (last_column >> shift) - (first_column >> shift) >= kMostBlocks; shift += 2) ++m;
    Range range = kEmpty;
    const Level& level = levels_[std::size_t(k - finest_)][m];
    for (int j = first_row >> k; j <= last_row >> k; ++j)
        for (int i = first_column >> shift; i <= last_column >> shift; ++i) {
            if (shift == 0)
                include(range, grid.patch(i, j));
            else
                include(range, level.at(i, j));
        }
    return range;
}

Range BoundsPyramid::range(const PatchGrid& grid, int first_column, int last_column, int first_row,
                           int last_row) const {
    const int columns = grid.columns();
    if (last_column - first_column >= columns - 1) return strip(grid, 0, columns - 1, first_row, last_row);
    if (last_column < columns) return strip(grid, first_column, last_column, first_row, last_row);
    Range range = strip(grid, first_column, columns - 1, first_row, last_row);
    include(range, strip(grid, 0, last_column - columns, first_row, last_row));
    return range;
}

}  // namespace dsphere::reference
