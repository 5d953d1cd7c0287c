#pragma once

#include "surface/heightmap.h"

namespace dsphere {

/// A stored value, and how it grows eastward and southward: stored units per radian.
struct HeightSample {
    double stored = 0.0, per_longitude = 0.0, per_colatitude = 0.0;
    double mixed = 0.0;  ///< on a bilinear patch, which it describes entirely: how one slope grows along the other
};

/// The stored value at any place of a map, in double: the definition of docs/scene-format.md as it stands, read from
/// the map's own values. For single places; the marcher has its own way. Refers to the map, which must outlive it.
class Interpolator {
  public:
    Interpolator(const Heightmap& map, Filter filter);

    /// Of a longitude in [-pi, pi], atan2(x, z), and a colatitude in [0, pi], counted from +y. Radians. On a crease the
    /// slopes are those of one side.
    HeightSample at(double longitude, double colatitude) const;

    /// Whether two places, which may have left the ranges of at() by a step, are on one and the same bilinear patch.
    bool onOnePatch(double longitude_a, double colatitude_a, double longitude_b, double colatitude_b) const;

  private:
    /// With slopes per column and row.
    HeightSample atTexel(double column, double row) const;
    HeightSample bilinear(double column, double row) const;
    HeightSample spline(double column, double row) const;
    HeightSample ripples(double longitude, double colatitude) const;
    double control(int column, int row) const;
    double texel(int column, int row) const;

    const Heightmap* map_;
    bool spline_, texel_;
    double columns_per_radian_, first_column_;  ///< column = longitude * columns_per_radian - first_column
    double rows_per_radian_;
};

}  // namespace dsphere
