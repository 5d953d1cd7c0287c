#pragma once

#include "reference/grid.h"

#include <vector>

namespace dsphere::reference {

struct Range {
    float least, greatest;
};

/// Least and greatest stored value over blocks of cells. Blocks are 2^k rows high and 2^k, 4 * 2^k, 16 * 2^k ...
/// columns wide: near the poles a short arc covers many columns and few rows. Single cells are read from the map. Of a
/// map that stays in its file k begins with its survey's blocks.
class BoundsPyramid {
  public:
    explicit BoundsPyramid(const PatchGrid& grid);

    /// Encloses the values of all patches in columns first_column..last_column, unwrapped, 0 <= first_column < columns
    /// (last_column >= first_column may reach beyond), and rows first_row..last_row. `grid` is the constructor's.
    Range range(const PatchGrid& grid, int first_column, int last_column, int first_row, int last_row) const;

  private:
    struct Level {
        int columns = 0, rows = 0;  // in blocks
        std::vector<Range> blocks;

        const Range& at(int i, int j) const { return blocks[std::size_t(j) * std::size_t(columns) + std::size_t(i)]; }
    };

    static Level coarsen(const Level& fine, int columns, int rows);
    static Level fromCells(const PatchGrid& grid, int columns, int rows);
    static Level fromBlocks(const BlockExtremes& extremes);
    static Range ofPatches(const PatchGrid& grid, int first_column, int last_column, int first_row, int last_row);
    Range strip(const PatchGrid& grid, int first_column, int last_column, int first_row, int last_row) const;

    // [k - finest_][m]: blocks of 2^k rows and 2^(k + 2 m) columns; of a map that is held [0][0] is empty.
    int finest_ = 0;
    std::vector<std::vector<Level>> levels_;
};

}  // namespace dsphere::reference
