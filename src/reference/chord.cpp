#include "reference/chord.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace dsphere::reference {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kDilation = 1e-9;  // cells; rounding of cell coordinates stays below it or counts as evaluation error

SlopeRange hull(const SlopeRange& a, const SlopeRange& b) {
    return {std::min(a.least, b.least), std::max(a.greatest, b.greatest)};
}

SlopeRange ordered(double a, double b) {
    return {std::min(a, b), std::max(a, b)};
}

double magnitude(const SlopeRange& a) {
    return std::max(std::abs(a.least), std::abs(a.greatest));
}

}  // namespace

Chord::Chord(const Surface& surface, const Line& line) : surface_(&surface), line_(line) {
    const dvec3 &c = line.c, &d = line.d;
    c2_ = glm::dot(c, c);
    moment_y_ = c.z * d.x - c.x * d.z;
    const double speed2 = d.x * d.x + d.z * d.z;
    axis_speed_ = std::sqrt(speed2);
    axis_s_ = speed2 > 0.0 ? -(c.x * d.x + c.z * d.z) / speed2 : 0.0;
    axis_distance_ = speed2 > 0.0 ? std::abs(moment_y_) / axis_speed_ : std::hypot(c.x, c.z);
    // d(y / |p|)/ds = (d_y |c|^2 - c_y s) / |p|^3
    turn_s_ = c.y != 0.0 ? d.y * c2_ / c.y : kInfinity;
    if (std::isfinite(turn_s_)) turn_row_ = point(turn_s_).row;
}

ChordPoint Chord::point(double s) const {
    const dvec3 p = line_.at(s);
    const double q2 = p.x * p.x + p.z * p.z;
    // Squares underflow beside the axis; hypot does not, and is slow.
    const double q = q2 > 1e-280 ? std::sqrt(q2) : std::hypot(p.x, p.z);
    const PatchGrid& grid = surface_->grid();
    return {s, std::sqrt(c2_ + s * s), grid.columnOf(std::atan2(p.x, p.z)), grid.rowOf(std::atan2(q, p.y))};
}

ChordBox Chord::box(const ChordPoint& a, const ChordPoint& b) const {
    const PatchGrid& grid = surface_->grid();
    const double columns = grid.columns();
    ChordBox box;
    box.s0 = a.s;
    box.s1 = b.s;
    box.rho0 = a.s <= 0.0 && b.s >= 0.0 ? std::sqrt(c2_) : std::min(a.rho, b.rho);
    box.rho1 = std::max(a.rho, b.rho);
    // The longitude turns one way, by at most half a turn in all. A computed sweep beyond that is a rounding below 0,
    // or an end that lies on the axis to within rounding, where its longitude means nothing: then the other way round
    // covers both ends.
    double west = moment_y_ >= 0.0 ? a.column : b.column, east = moment_y_ >= 0.0 ? b.column : a.column;
    if (east < west) east += columns;
    if (east - west > (0.5 + 1e-6) * columns) std::swap(west, east);
    if (east < west) east += columns;
    box.column0 = west - kDilation;
    box.column1 = east + kDilation;
    if (box.column0 >= columns) {
        box.column0 -= columns;
        box.column1 -= columns;
    }
    if (box.column0 < 0.0) {
        box.column0 += columns;
        box.column1 += columns;
    }
    box.row0 = std::min(a.row, b.row);
    box.row1 = std::max(a.row, b.row);
    if (a.s < turn_s_ && turn_s_ < b.s) {
        box.row0 = std::min(box.row0, turn_row_);
        box.row1 = std::max(box.row1, turn_row_);
    }
    box.row0 = std::max(box.row0 - kDilation, 0.0);
    box.row1 = std::min(box.row1 + kDilation, double(grid.rows()) - kDilation);
    box.row1 = std::max(box.row0, box.row1);
    return box;
}

/// Cells per unit of s within one row of cells.
struct Chord::Rates {
    SlopeRange east, south;
};

// d longitude/ds = moment_y / q^2 and d colatitude/ds = (c_y s - d_y |c|^2) / (|p|^2 q), never more than |c| / |p|^2.
// In a cap the east rate is given times b, the share of the way from the pole to the circle, as it is only used so:
// b / q = (theta / sin theta) / (|p| cap height), theta the angle from the pole, and |moment_y| / q <= axis_speed.
Chord::Rates Chord::rates(const ChordBox& box, int row) const {
    const PatchGrid& grid = surface_->grid();
    const double w0 = (box.s0 - axis_s_) * axis_speed_, w1 = (box.s1 - axis_s_) * axis_speed_;
    double q0 =
        w0 <= 0.0 && w1 >= 0.0 ? axis_distance_ : std::hypot(axis_distance_, std::min(std::abs(w0), std::abs(w1)));
    double q1 = std::hypot(axis_distance_, std::max(std::abs(w0), std::abs(w1)));
    const double height = grid.cellHeight(row), moment = std::abs(moment_y_);
    Rates rates;
    if (grid.isCap(row)) {
        const double reach = row == 0 ? std::min(box.row1, 1.0) : std::min(grid.rows() - box.row0, 1.0);
        const double theta = reach * height, stretch = theta > 1e-4 ? theta / std::sin(theta) : 1.0 + theta * theta;
        const double turn = q0 > 0.0 ? std::min(moment / q0, axis_speed_) : axis_speed_;
        const double least = q1 > 0.0 ? moment / (q1 * box.rho1) : 0.0;
        rates.east = {least / (height * grid.cellWidth()), turn * stretch / (box.rho0 * height * grid.cellWidth())};
    } else {
        // Away from the poles the row itself keeps q from 0: 1e-7 is far above the dilation in angle.
        if (q0 < 0.5 * q1) {
            const double sine = std::min(std::sin(grid.colatitudeOf(row)), std::sin(grid.colatitudeOf(row + 1)));
            q0 = std::max(q0, box.rho0 * sine * (1.0 - 1e-7));
            q1 = std::max(q0, q1);
        }
        rates.east = {moment / (q1 * q1 * grid.cellWidth()), moment / (q0 * q0 * grid.cellWidth())};
    }
    if (moment_y_ < 0.0) rates.east = {-rates.east.greatest, -rates.east.least};
    if (q1 == 0.0) return {rates.east, {0.0, 0.0}};

    const double n0 = line_.c.y * box.s0 - line_.d.y * c2_, n1 = line_.c.y * box.s1 - line_.d.y * c2_;
    const double margin =
        4.0 * kEpsilon *
        (std::abs(line_.c.y) * std::max(std::abs(box.s0), std::abs(box.s1)) + std::abs(line_.d.y) * c2_);
    const double least = std::min(n0, n1) - margin, greatest = std::max(n0, n1) + margin;
    const double near = box.rho0 * box.rho0 * q0, far = box.rho1 * box.rho1 * q1;
    const double fastest = std::sqrt(c2_) / (box.rho0 * box.rho0) * (1.0 + 8.0 * kEpsilon);
    rates.south.least = std::max(least < 0.0 ? least / near : least / far, -fastest) / height;
    rates.south.greatest = std::min(greatest > 0.0 ? greatest / near : greatest / far, fastest) / height;
    return rates;
}

SlopeRange Chord::slopes(const ChordBox& box) const {
    const PatchGrid& grid = surface_->grid();
    const int last_row = std::min(int(box.row1), grid.rows() - 1);
    SlopeRange all{kInfinity, -kInfinity};
    double size = 0.0;
    for (int j = int(box.row0); j <= last_row; ++j) {
        const Rates rate = rates(box, j);
        const double b0 = std::max(box.row0 - j, 0.0), b1 = std::min(box.row1 - j, 1.0);
        for (int i = int(box.column0); i <= int(box.column1); ++i) {
            const double a0 = std::max(box.column0 - i, 0.0), a1 = std::min(box.column1 - i, 1.0);
            const CellSlopeRanges slope = surface_->slopesOver(i % grid.columns(), j, {a0, a1, b0, b1});
            const SlopeRange along = product(slope.east, rate.east);
            const SlopeRange down = product(slope.south, rate.south);
            all = hull(all, {along.least + down.least, along.greatest + down.greatest});
            size = std::max(size, magnitude(along) + magnitude(down));
        }
    }
    const double scale = surface_->relief().scale;
    const SlopeRange r = ordered(scale * all.least, scale * all.greatest);
    const double p0 = std::sqrt(c2_ + box.s0 * box.s0), p1 = std::sqrt(c2_ + box.s1 * box.s1);
    const double rise0 = p0 > 0.0 ? box.s0 / p0 : -1.0, rise1 = p1 > 0.0 ? box.s1 / p1 : 1.0;
    // A few dozen roundings of the terms: generous.
    const double margin = 1e-12 * (1.0 + std::abs(scale) * size);
    return {rise0 - r.greatest - margin, rise1 - r.least + margin};
}

}  // namespace dsphere::reference
