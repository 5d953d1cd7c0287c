#pragma once

#include "surface/nodes.h"

#include <vector>

namespace dsphere {

/// A pyramid of upper bounds of r^2 over the cells of a cube map: no poles, no seam. Face 2k + (negative ? 1 : 0) looks
/// along axis k; its gnomonic coordinates a, b in [-1, 1] lie along axes k + 1 and k + 2 (cyclic). Level 0 is the
/// finest, the last has one cell a face.
///
/// Every bound covers all nodes of the patches that the cell touches, the cell dilated by kDilation (of a spline: the
/// Bezier points about them; of ripples: the closed form over the cell's box of longitude and latitude), and lies
/// kSlack above that maximum, so that the marcher's float rounding never skips a cell or a hit in it.
///
/// Beside them lie horizons, over cells of the cube map four times as wide and as high as the finest: a ray that starts
/// in such a cell, dilated too, at or above the least radius of its ground, and there rises above the horizontal plane
/// by more than the horizon's angle, meets nothing of the planet. Shadow rays to a high sun end with that.
struct Bounds {
    static constexpr double kDilation = 4e-6;  ///< in face coordinates
    static constexpr double kSlack = 6e-7;     ///< in units of R

    int side = 0;    ///< cells along a face edge at level 0; a power of two
    int levels = 0;  ///< log2(side) + 1
    /// Squared bounds in units of R^2. Rows of `side` values: per face 1.5 side rows, level 0 first, below it the
    /// coarser levels side by side: see index().
    std::vector<float> squared;

    int imageHeight() const { return 9 * side; }
    std::size_t index(int face, int level, int i, int j) const;
    float at(int face, int level, int i, int j) const { return squared[index(face, level, i, j)]; }

    /// Cells of the horizons along a face edge.
    int horizonSide() const { return side / 4; }
    /// Where `squared` holds the squared tangent of a horizon's angle, and the squared least
    /// radius in units of R; in what the coarser levels leave free.
    std::size_t horizonIndex(int face, int i, int j) const;
    std::size_t horizonLeastIndex(int face, int i, int j) const;
};

/// The side of the bounds over a grid of that many columns; the grids of NodeGrid have at least 512.
int boundsSide(int columns);

/// Builds the bounds of r = base + scale * stored value, in units of R = `greatest_radius`. Uses all cores.
Bounds buildBounds(const NodeGrid& nodes, const Relief& relief);

}  // namespace dsphere
