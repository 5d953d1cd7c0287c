#pragma once

// The map as a grid of bilinear patches in longitude and colatitude, caps included: the reference's own reading of the
// reconstruction. Cell coordinates: column x in [0, columns), wrapping; row y in [0, rows], row 0 at the north pole.

#include "surface/heightmap.h"
#include "surface/survey.h"

#include <algorithm>

namespace dsphere::reference {

/// Stored values at a cell's corners: north-west, north-east, south-west, south-east (east is growing u).
struct Patch {
    double nw, ne, sw, se;

    double value(double a, double b) const { return (nw + a * (ne - nw)) * (1.0 - b) + (sw + a * (se - sw)) * b; }
    double slopeEast(double b) const { return (ne - nw) * (1.0 - b) + (se - sw) * b; }   ///< per cell width
    double slopeSouth(double a) const { return (sw - nw) * (1.0 - a) + (se - ne) * a; }  ///< per cell height
};

/// Refers to the map, which must outlive it. Row 0 and the last row touch the poles: two of their corners are the pole
/// value. Texel registration: rows = height + 1 and these two are half as high as the others; gridline: height - 1.
/// Ripples have cells alone, kCellsPerRipple a period of each sine, rows from pole to pole; no patches.
class PatchGrid {
  public:
    static constexpr int kCellsPerRipple = 8;

    explicit PatchGrid(const Heightmap& map);

    int columns() const { return columns_; }
    int rows() const { return rows_; }
    double cellWidth() const { return cell_width_; }                                     ///< radians of longitude
    double cellHeight(int row) const { return isCap(row) ? cap_height_ : row_height_; }  ///< radians of colatitude
    bool isCap(int row) const { return row == 0 || row == rows_ - 1; }
    double pole(bool south) const { return south ? map_->south_pole : map_->north_pole; }

    /// The column coordinate, in [0, columns), of a longitude in [-pi, pi] (atan2(x, z)).
    double columnOf(double longitude) const;
    /// The row coordinate, in [0, rows], of a colatitude in [0, pi] counted from +y.
    double rowOf(double colatitude) const;
    /// The colatitude of a row coordinate in [0, rows], radians.
    double colatitudeOf(double row) const;
    /// 0 <= column < columns, 0 <= row < rows.
    Patch patch(int column, int row) const;
    /// Of a map that stays in its file: the extremes over blocks of patches that its survey found; else null.
    const BlockExtremes* blocks() const;
    /// The interpolated stored value at cell coordinates as columnOf and rowOf give them.
    double value(double column, double row) const;

  private:
    const Heightmap* map_;
    int columns_, rows_;
    int line_offset_;      // cell row j lies between the image rows j + line_offset and the next
    double line_shift_;    // cells between the north pole and where row 0 would begin if it were as high as the others
    double column_shift_;  // cells between longitude -pi and the first node, in [0, columns)
    double cell_width_, row_height_, cap_height_;
};

}  // namespace dsphere::reference
