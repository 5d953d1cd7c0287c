#pragma once

// f along a line, and proven bounds of it and of its slope over pieces of the line.

#include "reference/line.h"
#include "reference/surface.h"

namespace dsphere::reference {

/// A point of the chord: s, |p| and the cell coordinates of its direction.
struct ChordPoint {
    double s, rho, column, row;
};

/// What a piece of the chord covers: exact but for rounding, which a dilation by 1e-9 cells absorbs.
struct ChordBox {
    double s0, s1;
    double rho0, rho1;        ///< least and greatest |p|
    double column0, column1;  ///< column0 in [0, columns), column1 unwrapped
    double row0, row1;
};

class Chord {
  public:
    Chord(const Surface& surface, const Line& line);

    ChordPoint point(double s) const;
    /// f at a point of the chord, to within surface().evaluationError().
    double f(const ChordPoint& p) const { return p.rho - surface_->radiusOf(surface_->valueAt(p.column, p.row)); }
    double f(double s) const { return f(point(s)); }

    /// The piece from a to b, a.s <= b.s.
    ChordBox box(const ChordPoint& a, const ChordPoint& b) const;
    /// Bounds of r over the box.
    RadiusBounds radii(const ChordBox& box) const {
        return surface_->cellBounds(box.column0, box.column1, box.row0, box.row1);
    }
    /// Whether the box lies in at most 2x2 cells.
    static bool isSmall(const ChordBox& box) {
        return int(box.column1) - int(box.column0) <= 1 && int(box.row1) - int(box.row0) <= 1;
    }
    /// Bounds of df/ds over a small box (both one-sided slopes at creases).
    SlopeRange slopes(const ChordBox& box) const;

    const Surface& surface() const { return *surface_; }
    const Line& line() const { return line_; }

  private:
    struct Rates;
    Rates rates(const ChordBox& box, int row) const;

    const Surface* surface_;
    Line line_;
    double c2_;          // |c|^2
    double moment_y_;    // d longitude / ds = moment_y / q^2, q the distance from the axis
    double axis_speed_;  // q^2 = axis_distance^2 + (axis_speed (s - axis_s))^2
    double axis_s_, axis_distance_;
    double turn_s_;  // where the colatitude has its extremum; infinite if nowhere
    double turn_row_ = 0.0;
};

}  // namespace dsphere::reference
