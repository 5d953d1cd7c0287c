#pragma once

// The finest cells of the cube map that bounds lie on, and where they lie on a map.

#include "surface/interval.h"
#include "surface/nodes.h"

#include <vector>

namespace dsphere {

/// The (longitude, colatitude) box of a dilated cube cell, radians.
struct Footprint {
    Interval longitude, colatitude;
};

/// The nodes of all patches that a footprint touches: `count` columns from `first` on, which wrap, and rows `top` to
/// `bottom`, both included.
struct NodeBox {
    int first, count, top, bottom;
};

NodeBox nodesUnder(const NodeGrid& nodes, const Footprint& box);

/// The cells of all faces of a cube of side x side cells each, dilated by Bounds::kDilation. Faces as in Bounds.
class CubeCells {
  public:
    explicit CubeCells(int side);

    int side() const { return int(sides_.size()); }

    /// Calls `visit(face, i, j, footprint)` for a line of cells on each face, of one row or one column: the footprints
    /// of a face serve the others, turned or mirrored. All `side` lines are all cells.
    template <typename Visit>
    void visitLine(int n, const Visit& visit) const {
        const Side& fixed = sides_[std::size_t(n)];
        for (int k = 0; k < side(); ++k) {
            const Side& side = sides_[std::size_t(k)];
            const Footprint polar = polarFootprint(side, fixed);
            visit(2, k, n, polar);
            visit(3, k, n, mirrored(polar));
            const Interval colatitude = sideColatitude(side, fixed);
            visit(0, n, k, Footprint{sideLongitude(kPi / 2, -1.0, side), colatitude});
            visit(1, n, k, Footprint{sideLongitude(-kPi / 2, 1.0, side), colatitude});
            visit(4, k, n, Footprint{sideLongitude(0.0, 1.0, side), colatitude});
            visit(5, k, n, Footprint{sideLongitude(kPi, -1.0, side), colatitude});
        }
    }

  private:
    /// The extent of a cell in one face coordinate, and the angles from the face's middle to its ends.
    struct Side : Interval {
        Interval angle;
    };

    static Footprint polarFootprint(Interval z, Interval x);
    static Footprint mirrored(const Footprint& box);
    static Interval sideLongitude(double longitude_0, double turn, const Side& across);
    static Interval sideColatitude(Interval across, Interval y);

    std::vector<Side> sides_;  ///< of all cells along a face's edge, dilated
};

}  // namespace dsphere
