#include "surface/bounds.h"

#include "base/parallel.h"
#include "surface/cubecells.h"
#include "surface/horizons.h"
#include "surface/ripples.h"
#include "surface/spline.h"
#include "surface/tiledheights.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace dsphere {

namespace {

/// Rows of values at the nodes between which the surface of every cell lies: the nodes' own under bilinear patches, the
/// extremes of the Bezier points about them under a spline.
class Hull {
  public:
    Hull(const NodeGrid& nodes, const Relief& relief) : nodes_(nodes) {
        if (relief.filter == Filter::BSpline) extremes_ = SplineNodes(nodes).extremes(relief.scale >= 0.0);
    }

    const NodeGrid& nodes() const { return nodes_; }
    const float* row(int j) const {
        return extremes_.empty() ? nodes_.row(j) : &extremes_[std::size_t(j) * std::size_t(nodes_.width())];
    }

  private:
    const NodeGrid& nodes_;
    std::vector<float> extremes_;
};

constexpr int kLanes = 8;

// The greatest scale * value over all nodes of the patches that a footprint touches.
double greatestDisplacement(const Hull& hull, double scale, const Footprint& box) {
    const int width = hull.nodes().width();
    const auto [first, count, top, bottom] = nodesUnder(hull.nodes(), box);
    const float sign = scale < 0.0 ? -1.0f : 1.0f;
    float greatest = -std::numeric_limits<float>::infinity();
    // Most footprints are a few nodes wide: whole lanes, without a branch a row, and at the end those that count.
    if (count <= kLanes && first + kLanes <= width) {
        std::array<float, kLanes> lanes;
        lanes.fill(greatest);
        for (int j = top; j <= bottom; ++j) {
            const float* values = hull.row(j) + first;
            for (int k = 0; k < kLanes; ++k) lanes[k] = std::max(lanes[k], sign * values[k]);
        }
        for (int k = 0; k < kLanes; ++k) greatest = k < count ? std::max(greatest, lanes[k]) : greatest;
    } else {
        int before_seam = std::min(count, width - first);
        for (int j = top; j <= bottom; ++j) {
            const float* row = hull.row(j);
            for (int k = 0; k < before_seam; ++k) greatest = std::max(greatest, sign * row[first + k]);
            for (int k = 0; k < count - before_seam; ++k) greatest = std::max(greatest, sign * row[k]);
        }
    }
    return scale * (sign * greatest);
}

void fillCoarser(Bounds& bounds, int face) {
    for (int level = 1; level < bounds.levels; ++level) {
        int side = bounds.side >> level;
        for (int j = 0; j < side; ++j)
            for (int i = 0; i < side; ++i) {
                auto child = [&](int di, int dj) { return bounds.at(face, level - 1, 2 * i + di, 2 * j + dj); };
                bounds.squared[bounds.index(face, level, i, j)] =
                    std::max(std::max(child(0, 0), child(1, 0)), std::max(child(0, 1), child(1, 1)));
            }
    }
}

}  // namespace

std::size_t Bounds::index(int face, int level, int i, int j) const {
    int level_side = side >> level;
    int x = i + (level > 0 ? side - 2 * level_side : 0);
    int y = face * (side + side / 2) + j + (level > 0 ? side : 0);
    return std::size_t(y) * std::size_t(side) + std::size_t(x);
}

std::size_t Bounds::horizonIndex(int face, int i, int j) const {
    return std::size_t(face * (side + side / 2) + side + horizonSide() + j) * std::size_t(side) +
           std::size_t(side / 2 + i);
}

std::size_t Bounds::horizonLeastIndex(int face, int i, int j) const {
    return horizonIndex(face, i, j) + std::size_t(horizonSide());
}

int boundsSide(int columns) {
    // A face spans a quarter of the columns, so a finest cell spans four to eight cells of the map; fewer of a coarse
    // one, whose cells are large as they are, and about eight, 6 to 11, of a large one, whose bounds would leave the
    // caches.
    const unsigned width = unsigned(columns);
    const unsigned side = width < 8192 ? std::bit_floor(width) / 16 : std::bit_floor(width + width / 3) / 32;
    return std::clamp(int(side), 64, 1024);
}

namespace {

// `set(face, i, j, displacement)`.
template <typename Set>
void fillFromSurvey(int side, const Relief& relief, const CellExtremes& extremes, const Set& set) {
    const std::vector<float>& values = relief.scale < 0.0 ? extremes.least : extremes.greatest;
    parallelFor(std::size_t(6 * side), [&](std::size_t row) {
        const int face = int(row) / side, j = int(row) % side;
        for (int i = 0; i < side; ++i) set(face, i, j, relief.scale * double(values[extremes.index(face, i, j)]));
    });
}

/// A box of nodes and those around it.
NodeBox grown(const NodeBox& box, const NodeGrid& nodes) {
    const int first = box.first == 0 ? nodes.width() - 1 : box.first - 1;
    return {first, std::min(box.count + 2, nodes.width()), std::max(box.top - 1, 0),
            std::min(box.bottom + 1, nodes.rows())};
}

/// Of the B-spline of a map that stays in its file: no cell exceeds its control points, nor they the blocks that hold
/// them.
template <typename Set>
void fillFromControls(int side, const Relief& relief, const NodeGrid& nodes, const BlockExtremes& blocks,
                      const Set& set) {
    const CubeCells cells(side);
    const bool up = relief.scale >= 0.0;
    parallelFor(std::size_t(side), [&](std::size_t n) {
        cells.visitLine(int(n), [&](int face, int i, int j, const Footprint& footprint) {
            float highest = -std::numeric_limits<float>::infinity();
            visitBlocks(blocks, nodes, grown(nodesUnder(nodes, footprint), nodes), [&](std::size_t at) {
                highest = std::max(highest, up ? blocks.greatest[at] : -blocks.least[at]);
            });
            set(face, i, j, std::abs(relief.scale) * double(highest));
        });
    });
}

template <typename Set>
void fillFromNodes(int side, const Relief& relief, const NodeGrid& nodes, const Set& set) {
    const CubeCells cells(side);
    const auto fill = [&](const auto& displacement) {
        parallelFor(std::size_t(side), [&](std::size_t n) {
            cells.visitLine(int(n),
                            [&](int face, int i, int j, const Footprint& box) { set(face, i, j, displacement(box)); });
        });
    };
    if (nodes.map().ripples) {
        fill([&](const Footprint& box) {
            const Interval h = rippleRange(nodes.map(), box.longitude, box.colatitude);
            return std::max(relief.scale * h.low, relief.scale * h.high);
        });
    } else {
        const Hull hull(nodes, relief);
        fill([&](const Footprint& box) { return greatestDisplacement(hull, relief.scale, box); });
    }
}

}  // namespace

Bounds buildBounds(const NodeGrid& nodes, const Relief& relief) {
    Bounds bounds;
    bounds.side = boundsSide(nodes.width());
    bounds.levels = std::bit_width(unsigned(bounds.side));
    bounds.squared.assign(std::size_t(bounds.side) * std::size_t(bounds.imageHeight()), 0.0f);
    // `displacement` is the greatest stored value below a cell, times scale.
    const auto set = [&](int face, int i, int j, double displacement) {
        const double radius = relief.base + displacement;
        const double bound = radius / relief.greatest_radius + Bounds::kSlack;
        bounds.squared[bounds.index(face, 0, i, j)] =
            std::nextafter(float(bound * bound), std::numeric_limits<float>::infinity());
    };
    const TiledHeights* const tiled = nodes.map().tiled.get();
    const bool spline = relief.filter == Filter::BSpline;
    if (tiled && spline)
        fillFromControls(bounds.side, relief, nodes, tiled->survey().blocks, set);
    else if (tiled)
        fillFromSurvey(bounds.side, relief, tiled->survey().cells, set);
    else
        fillFromNodes(bounds.side, relief, nodes, set);
    parallelFor(6, [&](std::size_t face) { fillCoarser(bounds, int(face)); });
    if (tiled && !spline)
        fillHorizons(bounds, nodes, relief, tiled->survey().blocks);
    else
        fillHorizons(bounds, nodes, relief,
                     tiled ? splineBlocks(tiled->survey().blocks, nodes) : measureBlocks(nodes, relief.filter));
    return bounds;
}

}  // namespace dsphere
