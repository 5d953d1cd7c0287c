#include "surface/bounds.h"

#include "base/parallel.h"
#include "surface/ripples.h"
#include "surface/spline.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

namespace dsphere {

namespace {

struct Range {
    double low, high;
};

/// The (longitude, colatitude) box of a dilated cube cell, radians.
struct Footprint {
    Range longitude, colatitude;
};

/// The extent of a cell in one face coordinate, and the angles from the face's middle to its ends.
struct Side : Range {
    Range angle;
};

/// Of all cells along a face's edge, dilated.
std::vector<Side> sidesOf(int side) {
    std::vector<Side> sides;
    for (int i = 0; i < side; ++i) {
        double width = 2.0 / side;
        Range extent{i * width - 1.0 - Bounds::kDilation, (i + 1) * width - 1.0 + Bounds::kDilation};
        sides.push_back({extent, {std::atan(extent.low), std::atan(extent.high)}});
    }
    return sides;
}

Range squares(Range x) {
    double low = x.low > 0.0 ? x.low : (x.high < 0.0 ? -x.high : 0.0);
    double high = std::max(std::abs(x.low), std::abs(x.high));
    return {low * low, high * high};
}

// A cell of the face around the north pole: longitude from the corners, or a whole turn when the cell holds the pole.
Footprint polarFootprint(Range z, Range x) {
    Range zz = squares(z), xx = squares(x);
    Footprint box{{-kPi, kPi}, {std::atan(std::sqrt(zz.low + xx.low)), std::atan(std::sqrt(zz.high + xx.high))}};
    if (zz.low == 0.0 && xx.low == 0.0) return box;
    double mid_x = 0.5 * (x.low + x.high), mid_z = 0.5 * (z.low + z.high);
    double middle = std::atan2(mid_x, mid_z);
    // The pole is outside, so that all corners are less than a quarter turn from the middle, and the tangent tells.
    double tangent = 0.0;
    for (double cx : {x.low, x.high})
        for (double cz : {z.low, z.high})
            tangent = std::max(tangent, std::abs(cx * mid_z - cz * mid_x) / (cx * mid_x + cz * mid_z));
    double spread = std::atan(tangent);
    box.longitude = {middle - spread, middle + spread};
    return box;
}

// The same of a cell around the other pole.
Footprint mirrored(const Footprint& box) {
    return {box.longitude, {kPi - box.colatitude.high, kPi - box.colatitude.low}};
}

// A cell of a face around the equator: its vertical edges are meridians, so the longitude range is exact; `across` is
// the horizontal face coordinate, `longitude_0 + turn * atan(across)` its longitude.
Range sideLongitude(double longitude_0, double turn, const Side& across) {
    double first = longitude_0 + turn * across.angle.low, last = longitude_0 + turn * across.angle.high;
    return {std::min(first, last), std::max(first, last)};
}

// The same on all four such faces; y is the vertical face coordinate.
Range sideColatitude(Range across, Range y) {
    Range squared = squares(across);
    double near = std::sqrt(1.0 + squared.low), far = std::sqrt(1.0 + squared.high);
    return {std::atan2(y.high > 0.0 ? near : far, y.high), std::atan2(y.low > 0.0 ? far : near, y.low)};
}

/// Rows of values at the nodes between which the surface of every cell lies: the nodes' own under bilinear patches, the
/// extremes of the Bezier points about them under a spline.
class Hull {
  public:
    Hull(const NodeGrid& nodes, const Relief& relief) : nodes_(nodes) {
        if (relief.filter == Filter::BSpline) extremes_ = SplineNodes(nodes).extremes(relief.scale >= 0.0);
    }

    int width() const { return nodes_.width(); }
    const float* row(int j) const {
        return extremes_.empty() ? nodes_.row(j) : &extremes_[std::size_t(j) * std::size_t(width())];
    }
    /// Of the last node before a longitude, not yet wrapped.
    int column(double longitude) const { return int(std::floor(nodes_.column(longitude))); }
    /// Of the cell that holds a colatitude.
    int cellRow(double colatitude) const {
        return std::clamp(int(std::floor(nodes_.nodeRow(colatitude))), 0, nodes_.rows() - 1);
    }

  private:
    const NodeGrid& nodes_;
    std::vector<float> extremes_;
};

constexpr int kLanes = 8;

// The greatest scale * value over all nodes of the patches that a footprint touches.
double greatestDisplacement(const Hull& hull, double scale, const Footprint& box) {
    int width = hull.width();
    int first = hull.column(box.longitude.low);
    int count = std::min(hull.column(box.longitude.high) + 1 - first + 1, width);
    first %= width;
    if (first < 0) first += width;
    int top = hull.cellRow(box.colatitude.low), bottom = hull.cellRow(box.colatitude.high) + 1;
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

// A line of cells on each face, of one row or one column: the footprints of a face serve the others, turned or
// mirrored. `greatest(footprint)` is the greatest stored value, times scale.
template <typename Greatest>
void fillFinestRow(Bounds& bounds, const Relief& relief, const Greatest& greatest, const std::vector<Side>& sides,
                   int n) {
    const auto fill = [&](int face, int i, int j, const Footprint& box) {
        double radius = relief.base + greatest(box);
        double bound = radius / relief.greatest_radius + Bounds::kSlack;
        bounds.squared[bounds.index(face, 0, i, j)] =
            std::nextafter(float(bound * bound), std::numeric_limits<float>::infinity());
    };
    const Side& fixed = sides[std::size_t(n)];
    for (int k = 0; k < bounds.side; ++k) {
        const Side& side = sides[std::size_t(k)];
        const Footprint polar = polarFootprint(side, fixed);
        fill(2, k, n, polar);
        fill(3, k, n, mirrored(polar));
        const Range colatitude = sideColatitude(side, fixed);
        fill(0, n, k, {sideLongitude(kPi / 2, -1.0, side), colatitude});
        fill(1, n, k, {sideLongitude(-kPi / 2, 1.0, side), colatitude});
        fill(4, k, n, {sideLongitude(0.0, 1.0, side), colatitude});
        fill(5, k, n, {sideLongitude(kPi, -1.0, side), colatitude});
    }
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

int boundsSide(int columns) {
    // A face spans a quarter of the columns, so a finest cell spans four to eight cells of the map; fewer of a coarse
    // one, whose cells are large as they are, and about eight, 6 to 11, of a large one, whose bounds would leave the
    // caches.
    const unsigned width = unsigned(columns);
    const unsigned side = width < 8192 ? std::bit_floor(width) / 16 : std::bit_floor(width + width / 3) / 32;
    return std::clamp(int(side), 64, 1024);
}

Bounds buildBounds(const NodeGrid& nodes, const Relief& relief) {
    Bounds bounds;
    bounds.side = boundsSide(nodes.width());
    bounds.levels = std::bit_width(unsigned(bounds.side));
    bounds.squared.assign(std::size_t(bounds.side) * std::size_t(bounds.imageHeight()), 0.0f);
    const std::vector<Side> sides = sidesOf(bounds.side);
    const auto fillFinest = [&](const auto& greatest) {
        parallelFor(std::size_t(bounds.side),
                    [&](std::size_t n) { fillFinestRow(bounds, relief, greatest, sides, int(n)); });
    };
    if (nodes.map().ripples) {
        fillFinest([&](const Footprint& box) {
            Interval h = rippleRange(nodes.map(), {box.longitude.low, box.longitude.high},
                                     {box.colatitude.low, box.colatitude.high});
            return std::max(relief.scale * h.low, relief.scale * h.high);
        });
    } else {
        const Hull hull(nodes, relief);
        fillFinest([&](const Footprint& box) { return greatestDisplacement(hull, relief.scale, box); });
    }
    parallelFor(6, [&](std::size_t face) { fillCoarser(bounds, int(face)); });
    return bounds;
}

}  // namespace dsphere
