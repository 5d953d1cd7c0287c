#pragma once

// Surfaces that are not bilinear, in the cell coordinates of the PatchGrid: the reference's own reading of the B-spline
// and of the ripples, and proven bounds of their slopes.

#include "reference/grid.h"
#include "reference/sloperange.h"

namespace dsphere::reference {

/// Of stored values, per cell; in rows that touch a pole the slope eastward is that over the share of the way from the
/// pole to the row's other edge, which stays finite at the pole.
struct CellSlopes {
    double east, south;
};
struct CellSlopeRanges {
    SlopeRange east, south;
};

/// A part of one cell: a0 <= a <= a1 eastward and b0 <= b <= b1 southward, in [0, 1].
struct CellPart {
    double a0, a1, b0, b1;
};

/// The uniform bicubic B-spline with the map's values as control points. Texel registration: rows clamped, linear
/// between the poles and the first (last) row's circle. Gridline: the row beyond a pole is the next one mirrored
/// through the pole's value. Refers to the map.
class SplineField {
  public:
    SplineField(const PatchGrid& grid, const Heightmap& map) : grid_(grid), map_(&map) {}

    double value(int i, int j, double a, double b) const;
    CellSlopes slopes(int i, int j, double a, double b) const;
    CellSlopeRanges slopes(int i, int j, const CellPart& part) const;

  private:
    struct Controls;
    struct Ring;

    double control(int i, int line) const;
    Controls controls(int i, int j) const;
    Ring ring(int i, int line) const;
    Ring circle(int i, bool south) const;
    bool isLinear(int j) const { return map_->registration == Registration::Texel && grid_.isCap(j); }

    PatchGrid grid_;
    const Heightmap* map_;
};

/// h = 0.5 + 0.5 sin(2 pi u_frequency u) sin(pi v_frequency v), on the PatchGrid that ripples have.
class RippleField {
  public:
    explicit RippleField(const PatchGrid& grid) : grid_(grid) {}

    double value(double column, double row) const;
    CellSlopes slopes(int i, int j, double a, double b) const;
    CellSlopeRanges slopes(int i, int j, const CellPart& part) const;
    /// Over cell coordinates; exact but for rounding.
    SlopeRange range(double column0, double column1, double row0, double row1) const;

  private:
    PatchGrid grid_;
};

}  // namespace dsphere::reference
