#include "surface/cubecells.h"

#include "surface/bounds.h"

#include <algorithm>
#include <cmath>

namespace dsphere {

namespace {

Interval squares(Interval x) {
    double low = x.low > 0.0 ? x.low : (x.high < 0.0 ? -x.high : 0.0);
    double high = std::max(std::abs(x.low), std::abs(x.high));
    return {low * low, high * high};
}

}  // namespace

NodeBox nodesUnder(const NodeGrid& nodes, const Footprint& box) {
    const int width = nodes.width();
    const auto column = [&](double longitude) { return int(std::floor(nodes.column(longitude))); };
    const auto row = [&](double colatitude) {
        return std::clamp(int(std::floor(nodes.nodeRow(colatitude))), 0, nodes.rows() - 1);
    };
    const int first = column(box.longitude.low);
    const int count = std::min(column(box.longitude.high) + 1 - first + 1, width);
    return {first - width * int(std::floor(double(first) / width)), count, row(box.colatitude.low),
            row(box.colatitude.high) + 1};
}

CubeCells::CubeCells(int side) {
    for (int i = 0; i < side; ++i) {
        const double width = 2.0 / side;
        const Interval extent{i * width - 1.0 - Bounds::kDilation, (i + 1) * width - 1.0 + Bounds::kDilation};
        sides_.push_back({extent, {std::atan(extent.low), std::atan(extent.high)}});
    }
}

// A cell of the face around the north pole: longitude from the corners, or a whole turn when the cell holds the pole.
Footprint CubeCells::polarFootprint(Interval z, Interval x) {
    Interval zz = squares(z), xx = squares(x);
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

// A cell around the south pole by its mirror image around the north pole.
Footprint CubeCells::mirrored(const Footprint& box) {
    return {box.longitude, {kPi - box.colatitude.high, kPi - box.colatitude.low}};
}

// A cell of a face around the equator: its vertical edges are meridians, so the longitude range is exact; `across` is
// the horizontal face coordinate, `longitude_0 + turn * atan(across)` its longitude.
Interval CubeCells::sideLongitude(double longitude_0, double turn, const Side& across) {
    double first = longitude_0 + turn * across.angle.low, last = longitude_0 + turn * across.angle.high;
    return {std::min(first, last), std::max(first, last)};
}

// The colatitudes of a cell on any of the four faces around the equator; y is the vertical face coordinate.
Interval CubeCells::sideColatitude(Interval across, Interval y) {
    Interval squared = squares(across);
    double near = std::sqrt(1.0 + squared.low), far = std::sqrt(1.0 + squared.high);
    return {std::atan2(y.high > 0.0 ? near : far, y.high), std::atan2(y.low > 0.0 ? far : near, y.low)};
}

}  // namespace dsphere
