#include "surface/bounds.h"

#include "base/parallel.h"
#include "surface/ripples.h"
#include "surface/spline.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>

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

// A face around a pole, y = sign: longitude from the corners, or a whole turn when the cell holds the pole.
Footprint polarFootprint(double sign, Range z, Range x) {
    Range zz = squares(z), xx = squares(x);
    double near = std::atan2(std::sqrt(zz.low + xx.low), sign), far = std::atan2(std::sqrt(zz.high + xx.high), sign);
    Footprint box{{-kPi, kPi}, {std::min(near, far), std::max(near, far)}};
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

// A face around the equator: its vertical edges are meridians, so the longitude range is exact; `across` is the
// horizontal face coordinate, `longitude_0 + turn * atan(across)` its longitude, y the vertical one.
Footprint sideFootprint(double longitude_0, double turn, const Side& across, Range y) {
    double first = longitude_0 + turn * across.angle.low, last = longitude_0 + turn * across.angle.high;
    Range squared = squares(across);
    double near = std::sqrt(1.0 + squared.low), far = std::sqrt(1.0 + squared.high);
    Footprint box;
    box.longitude = {std::min(first, last), std::max(first, last)};
    box.colatitude = {std::atan2(y.high > 0.0 ? near : far, y.high), std::atan2(y.low > 0.0 ? far : near, y.low)};
    return box;
}

Footprint footprint(int face, const Side& a, const Side& b) {
    bool negative = face % 2 == 1;
    switch (face / 2) {
        case 0:
            return sideFootprint(negative ? -kPi / 2 : kPi / 2, negative ? 1.0 : -1.0, b, a);
        case 1:
            return polarFootprint(negative ? -1.0 : 1.0, a, b);
        default:
            return sideFootprint(negative ? kPi : 0.0, negative ? -1.0 : 1.0, a, b);
    }
}

/// Rows of values at the nodes between which the surface of every cell lies: the nodes' own under bilinear patches, the
/// extremes of the Bezier points about them under a spline.
class Hull {
  public:
    Hull(const NodeGrid& nodes, const Relief& relief) : nodes_(nodes) {
        if (relief.filter == Filter::BSpline) extremes_ = SplineNodes(nodes).extremes(relief.scale >= 0.0);
    }

    const float* row(int j) const {
        return extremes_.empty() ? nodes_.row(j) : &extremes_[std::size_t(j) * std::size_t(nodes_.width())];
    }

  private:
    const NodeGrid& nodes_;
    std::vector<float> extremes_;
};

// The greatest scale * value over all nodes of the patches that a footprint touches.
double greatestDisplacement(const NodeGrid& nodes, const Hull& hull, double scale, const Footprint& box) {
    int width = nodes.width();
    int first = int(std::floor(nodes.column(box.longitude.low)));
    int count = std::min(int(std::floor(nodes.column(box.longitude.high))) + 1 - first + 1, width);
    first = (first % width + width) % width;
    int top = std::clamp(int(std::floor(nodes.nodeRow(box.colatitude.low))), 0, nodes.rows() - 1);
    int bottom = std::clamp(int(std::floor(nodes.nodeRow(box.colatitude.high))), 0, nodes.rows() - 1) + 1;
    int before_seam = std::min(count, width - first);
    float least = hull.row(top)[first], greatest = least;
    auto scan = [&](const float* values, int n) {
        for (int k = 0; k < n; ++k) {
            least = std::min(least, values[k]);
            greatest = std::max(greatest, values[k]);
        }
    };
    for (int j = top; j <= bottom; ++j) {
        const float* row = hull.row(j);
        scan(row + first, before_seam);
        scan(row, count - before_seam);
    }
    return std::max(scale * least, scale * greatest);
}

/// The greatest stored value (times scale) over the cell of a cube face, dilated.
using Greatest = std::function<double(const Footprint&)>;

void fillFinestRow(Bounds& bounds, const Relief& relief, const Greatest& greatest, const std::vector<Side>& sides,
                   int face, int j) {
    const Side& b = sides[std::size_t(j)];
    for (int i = 0; i < bounds.side; ++i) {
        const Side& a = sides[std::size_t(i)];
        double radius = relief.base + greatest(footprint(face, a, b));
        double bound = radius / relief.greatest_radius + Bounds::kSlack;
        bounds.squared[bounds.index(face, 0, i, j)] =
            std::nextafter(float(bound * bound), std::numeric_limits<float>::infinity());
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
    // A face spans a quarter of the columns, so a finest cell spans about two cells of the map.
    return std::min(int(std::bit_floor(unsigned(columns) / 8u)), 1024);
}

Bounds buildBounds(const NodeGrid& nodes, const Relief& relief) {
    Bounds bounds;
    bounds.side = boundsSide(nodes.width());
    bounds.levels = std::bit_width(unsigned(bounds.side));
    bounds.squared.assign(std::size_t(bounds.side) * std::size_t(bounds.imageHeight()), 0.0f);
    const Hull hull(nodes, relief);
    Greatest greatest = [&](const Footprint& box) { return greatestDisplacement(nodes, hull, relief.scale, box); };
    if (nodes.map().ripples)
        greatest = [&](const Footprint& box) {
            Interval h = rippleRange(nodes.map(), {box.longitude.low, box.longitude.high},
                                     {box.colatitude.low, box.colatitude.high});
            return std::max(relief.scale * h.low, relief.scale * h.high);
        };
    const std::vector<Side> sides = sidesOf(bounds.side);
    parallelFor(std::size_t(6 * bounds.side), [&](std::size_t task) {
        fillFinestRow(bounds, relief, greatest, sides, int(task) / bounds.side, int(task) % bounds.side);
    });
    parallelFor(6, [&](std::size_t face) { fillCoarser(bounds, int(face)); });
    return bounds;
}

}  // namespace dsphere
