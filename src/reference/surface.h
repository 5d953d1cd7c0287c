#pragma once

#include "base/math.h"
#include "reference/curved.h"
#include "reference/grid.h"
#include "reference/pyramid.h"

#include <optional>
#include <vector>

namespace dsphere::reference {

/// lower <= r <= upper, object units, rounded outward.
struct RadiusBounds {
    double lower, upper;
};

/// The displaced sphere in object space and double precision, and bounds of it. Refers to the map, which must outlive
/// it; thread-safe. Takes about 1.6 times the memory of the map's floats.
class Surface {
  public:
    Surface(const Heightmap& map, const Relief& relief);

    /// Of a point or direction other than 0: u in [0, 1] wraps, not shifted by the map's longitude origin; v in [0, 1].
    static double u(const dvec3& p);
    static double v(const dvec3& p);

    double stored(const dvec3& p) const;  ///< the map's interpolated value in the direction of p
    double height(const dvec3& p) const;  ///< h: 0 and 1 at the stored values that the scene says
    double radius(const dvec3& w) const;  ///< r in the direction of w, object units
    double f(const dvec3& p) const;       ///< |p| - r(p / |p|)

    /// Of f, in closed form from the patch that p is over (at a crease: one of them). On the axis e_r. p is not 0.
    dvec3 gradient(const dvec3& p) const;
    dvec3 normal(const dvec3& p) const;  ///< the gradient's direction: unit, outward
    /// The shading normal: the B-spline's if the relief asks for smooth normals, else normal(p).
    dvec3 shadingNormal(const dvec3& p) const;

    /// The stored value at cell coordinates as PatchGrid gives them.
    double valueAt(double column, double row) const;
    /// Of a point of a cell, and bounds over a part of one.
    CellSlopes slopesAt(int i, int j, double a, double b) const;
    CellSlopeRanges slopesOver(int i, int j, const CellPart& part) const;

    /// Bounds of r over u0 <= u <= u1 (any reals; wraps), 0 <= v0 <= v <= v1 <= 1.
    RadiusBounds bounds(double u0, double u1, double v0, double v1) const;
    /// bounds() in cell coordinates: column0 in [0, columns), column1 >= column0 unwrapped.
    RadiusBounds cellBounds(double column0, double column1, double row0, double row1) const;

    double greatestRadius() const { return greatest_radius_; }  ///< R: over all nodes, rounded outward
    double leastRadius() const { return least_radius_; }        ///< rounded inward
    /// Bounds the rounding error of f as computed for a p with |p| <= 2 R whose coordinates are off by 2 ulp of |p|:
    /// over the whole surface, and within the rows of cells from row0 to row1 (near the poles it is greater).
    double evaluationError() const { return evaluation_error_; }
    double evaluationError(double row0, double row1) const;

    const PatchGrid& grid() const { return grid_; }
    const Relief& relief() const { return relief_; }
    double radiusOf(double stored) const { return relief_.base + relief_.scale * stored; }

  private:
    std::vector<double> boundEvaluationErrors() const;
    CellSlopes steepest(int j) const;
    dvec3 gradientFrom(const dvec3& p, CellSlopes (Surface::*slopes)(int, int, double, double) const) const;
    CellSlopes smoothSlopesAt(int i, int j, double a, double b) const { return smooth_->slopes(i, j, a, b); }
    SlopeRange valueRange(double column0, double column1, double row0, double row1) const;

    PatchGrid grid_;
    std::optional<SplineField> spline_, smooth_;  // smooth_: of the shading normals alone
    std::optional<RippleField> ripples_;
    std::optional<BoundsPyramid> pyramid_;  // of patches; ripples have none
    Relief relief_;
    double greatest_stored_;  // magnitude
    double greatest_radius_, least_radius_, evaluation_error_;
    std::vector<double> row_errors_;  // of each row of cells
};

}  // namespace dsphere::reference
