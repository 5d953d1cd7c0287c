#pragma once

#include "surface/heightmap.h"

namespace dsphere {

/// A height as the map's samples have it (Heightmap::zero), and how it grows eastward and southward: stored units per
/// radian.
struct HeightSample {
    double value = 0.0, per_longitude = 0.0, per_colatitude = 0.0;
    double mixed = 0.0;  ///< on a bilinear patch, which it describes entirely: how one slope grows along the other
};

/// A cell of a bilinear map, or its part in a polar cap, whose two corners at the pole are equal. Heights run from one
/// corner to the next by `east` and `south`, both 0 to 1.
struct BilinearPatch {
    double nw, ne, sw, se;
    double east, south;   ///< of the place that was asked for
    double rows_inverse;  ///< 1 / its height in rows: 1, or 2 in a cap
};

/// Columns and rows of a map's values: column = longitude * columns_per_radian - first_column, the row likewise.
struct MapSteps {
    double columns_per_radian, first_column, rows_per_radian, first_row;
};

/// The height at any place of a map, in double: the definition of docs/scene-format.md as it stands, read from
/// the map's own values. For single places; the marcher has its own way. Refers to the map, which must outlive it.
class Interpolator {
  public:
    Interpolator(const Heightmap& map, Filter filter);

    /// Of a longitude in [-pi, pi], atan2(x, z), and a colatitude in [0, pi], counted from +y. Radians. On a crease the
    /// slopes are those of one side.
    HeightSample at(double longitude, double colatitude) const;

    const Heightmap& map() const { return *map_; }

    /// Whether heights run bilinearly, so that there are patches.
    bool isBilinear() const { return !spline_ && !map_->ripples; }
    const MapSteps& steps() const { return steps_; }
    /// The patch of a place in columns (from minus one and a half widths on) and rows.
    BilinearPatch patchAt(double column, double row) const;
    /// Whether two places, which may have left the ranges of at() by a step, are on one and the same bilinear patch.
    bool onOnePatch(double longitude_a, double colatitude_a, double longitude_b, double colatitude_b) const;

  private:
    /// With slopes per column and row, as the next.
    HeightSample ofPatch(const BilinearPatch& patch) const;
    HeightSample splineWithCaps(double column, double row) const;
    HeightSample spline(double column, double row) const;
    HeightSample ripples(double longitude, double colatitude) const;
    double control(int column, int row) const;
    double texel(int column, int row) const;

    const Heightmap* map_;
    bool spline_, texel_;
    MapSteps steps_;
};

}  // namespace dsphere
