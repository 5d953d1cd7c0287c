#include "reference/surface.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace dsphere::reference {

namespace {

double colatitude(const dvec3& p) {
    return std::atan2(std::hypot(p.x, p.z), p.y);
}

}  // namespace

Surface::Surface(const Heightmap& map, const Relief& relief) : grid_(map), relief_(relief) {
    if (map.ripples)
        ripples_.emplace(grid_);
    else
        pyramid_.emplace(grid_);
    if (!map.ripples && relief.filter == Filter::BSpline) spline_.emplace(grid_, map);
    if (relief.smooth_normals) smooth_.emplace(grid_, map);
    greatest_stored_ = std::max(std::abs(double(map.least)), std::abs(double(map.greatest)));
    const RadiusBounds all = cellBounds(0.0, grid_.columns(), 0.0, grid_.rows());
    greatest_radius_ = all.upper;
    least_radius_ = all.lower;
    assert(least_radius_ > 0.0 && "the surface must be star-shaped");
    row_errors_ = boundEvaluationErrors();
    evaluation_error_ = *std::max_element(row_errors_.begin(), row_errors_.end());
}

double Surface::u(const dvec3& p) {
    return 0.5 + std::atan2(p.x, p.z) / (2.0 * kPi);
}

double Surface::v(const dvec3& p) {
    return colatitude(p) / kPi;
}

double Surface::stored(const dvec3& p) const {
    return valueAt(grid_.columnOf(std::atan2(p.x, p.z)), grid_.rowOf(colatitude(p)));
}

double Surface::height(const dvec3& p) const {
    return relief_.h_offset + relief_.h_scale * stored(p);
}

double Surface::radius(const dvec3& w) const {
    return radiusOf(stored(w));
}

double Surface::f(const dvec3& p) const {
    return glm::length(p) - radius(p);
}

double Surface::valueAt(double column, double row) const {
    if (ripples_) return ripples_->value(column, row);
    if (!spline_) return grid_.value(column, row);
    const int i = std::min(int(column), grid_.columns() - 1), j = std::min(int(row), grid_.rows() - 1);
    return spline_->value(i, j, column - i, row - j);
}

CellSlopes Surface::slopesAt(int i, int j, double a, double b) const {
    if (ripples_) return ripples_->slopes(i, j, a, b);
    if (spline_) return spline_->slopes(i, j, a, b);
    const Patch patch = grid_.patch(i, j);
    double east = patch.slopeEast(b);
    if (grid_.isCap(j)) east = j == 0 ? patch.se - patch.sw : patch.ne - patch.nw;
    return {east, patch.slopeSouth(a)};
}

CellSlopeRanges Surface::slopesOver(int i, int j, const CellPart& part) const {
    if (ripples_) return ripples_->slopes(i, j, part);
    if (spline_) return spline_->slopes(i, j, part);
    const CellSlopes first = slopesAt(i, j, part.a0, part.b0), last = slopesAt(i, j, part.a1, part.b1);
    return {{std::min(first.east, last.east), std::max(first.east, last.east)},
            {std::min(first.south, last.south), std::max(first.south, last.south)}};
}

// With longitude phi (east), colatitude theta (south) and rho = |p|:
//   grad f = e_r - (1 / rho) (dr/dtheta e_south + dr/dphi / sin(theta) e_east).
// In a row that touches a pole dr/dphi is given over b = theta' / row height, theta' the angle from that pole:
// theta' / sin(theta') has no pole.
dvec3 Surface::gradientFrom(const dvec3& p, CellSlopes (Surface::*slopes)(int, int, double, double) const) const {
    const double rho = glm::length(p), q = std::hypot(p.x, p.z);
    const dvec3 e_r = p / rho;
    if (q == 0.0) return e_r;
    const double theta = colatitude(p), column = grid_.columnOf(std::atan2(p.x, p.z)), row = grid_.rowOf(theta);
    const int i = std::min(int(column), grid_.columns() - 1), j = std::min(int(row), grid_.rows() - 1);
    const CellSlopes slope = (this->*slopes)(i, j, column - i, row - j);
    double east = slope.east / (q / rho);  // dstored/dcolumn / sin(theta)
    if (grid_.isCap(j)) {
        const double from_pole = j == 0 ? theta : std::atan2(q, -p.y);
        east = slope.east == 0.0 ? 0.0 : slope.east / grid_.cellHeight(j) * (from_pole / (q / rho));
    }
    const double g_east = relief_.scale * east / (grid_.cellWidth() * rho);
    const double g_south = relief_.scale * slope.south / (grid_.cellHeight(j) * rho);
    const double sin_phi = p.x / q, cos_phi = p.z / q;
    const dvec3 e_east(cos_phi, 0.0, -sin_phi);
    const dvec3 e_south(e_r.y * sin_phi, -q / rho, e_r.y * cos_phi);
    return e_r - g_east * e_east - g_south * e_south;
}

dvec3 Surface::gradient(const dvec3& p) const {
    return gradientFrom(p, &Surface::slopesAt);
}

dvec3 Surface::shadingNormal(const dvec3& p) const {
    return smooth_ ? glm::normalize(gradientFrom(p, &Surface::smoothSlopesAt)) : normal(p);
}

dvec3 Surface::normal(const dvec3& p) const {
    return glm::normalize(gradient(p));
}

RadiusBounds Surface::bounds(double u0, double u1, double v0, double v1) const {
    // 1e-9 cells cover the rounding of both coordinates.
    const double turns = u0 - std::floor(u0), columns = grid_.columns();
    double column0 = grid_.columnOf((2.0 * turns - 1.0) * kPi) - 1e-9;
    const double column1 = column0 + (u1 - u0) * columns + 2e-9;
    const double row0 = grid_.rowOf(v0 * kPi) - 1e-9, row1 = grid_.rowOf(v1 * kPi) + 1e-9;
    const double wrap = column0 < 0.0 ? columns : 0.0;
    return cellBounds(column0 + wrap, column1 + wrap, std::max(row0, 0.0), std::min(row1, double(grid_.rows())));
}

SlopeRange Surface::valueRange(double column0, double column1, double row0, double row1) const {
    if (ripples_) return ripples_->range(column0, column1, row0, row1);
    const int last_row = grid_.rows() - 1;
    int i0 = std::min(int(column0), grid_.columns() - 1), i1 = std::max(i0, int(column1));
    int j0 = std::min(int(row0), last_row), j1 = std::min(int(row1), last_row);
    const bool north = j1 == 0, south = j0 == last_row;
    if (spline_) {  // it lies between its cell's 4x4 control points and the pole's value
        const int wrap = i0 == 0 ? grid_.columns() : 0;
        i0 += wrap - 1;
        i1 += wrap + 1;
        j0 = std::max(j0 - 1, 0);
        j1 = std::min(j1 + 1, last_row);
    }
    const Range range = pyramid_->range(grid_, i0, i1, j0, j1);
    double least = range.least, greatest = range.greatest;
    // Within a cap a value lies between the pole's and the circle's in proportion to the distance from the pole.
    if (north) {
        const double pole = grid_.pole(false);
        least = std::max(least, pole + row1 * (range.least - pole));
        greatest = std::min(greatest, pole + row1 * (range.greatest - pole));
    }
    if (south) {
        const double pole = grid_.pole(true), share = grid_.rows() - row0;
        least = std::max(least, pole + share * (range.least - pole));
        greatest = std::min(greatest, pole + share * (range.greatest - pole));
    }
    return {least, greatest};
}

RadiusBounds Surface::cellBounds(double column0, double column1, double row0, double row1) const {
    const SlopeRange range = valueRange(column0, column1, row0, row1);
    const double a = radiusOf(range.least), b = radiusOf(range.greatest);
    const double margin = (spline_ || ripples_ ? 16.0 : 4.0) * kEpsilon *
                          (std::abs(relief_.base) + std::abs(relief_.scale) * greatest_stored_);
    return {std::min(a, b) - margin, std::max(a, b) + margin};
}

double Surface::evaluationError(double row0, double row1) const {
    const std::size_t end = row_errors_.size() - 1;  // the south pole counts as the last row
    const std::size_t first = std::min(std::size_t(row0), end), last = std::min(std::size_t(row1), end);
    if (last > first + 1) return evaluation_error_;
    return std::max(row_errors_[first], row_errors_[last]);
}

// The greatest slopes of a row, per cell. A spline's are averages of differences of the control points about it; its
// caps lead to averages of two rows.
CellSlopes Surface::steepest(int j) const {
    if (ripples_) return {kPi / PatchGrid::kCellsPerRipple, kPi / PatchGrid::kCellsPerRipple};
    double across = 0.0, down = 0.0;
    const int reach = spline_ ? 1 : 0, first = std::max(j - reach, 0), last = std::min(j + reach, grid_.rows() - 1);
    if (const BlockExtremes* blocks = grid_.blocks()) {  // no two values of a block differ by more
        double both = 0.0;
        for (int bj = first >> blocks->shift; bj <= last >> blocks->shift; ++bj) {
            double range = 0.0;
            for (int i = 0; i < blocks->columns; ++i) {
                const std::size_t at = blocks->index(i, bj);
                range = std::max(range, double(blocks->greatest[at]) - double(blocks->least[at]));
            }
            both += range;
        }
        return {both, both};
    }
    for (int k = first; k <= last; ++k) {
        double row_down = 0.0;
        for (int i = 0; i < grid_.columns(); ++i) {
            const Patch p = grid_.patch(i, k);
            across = std::max({across, std::abs(p.ne - p.nw), std::abs(p.se - p.sw)});
            row_down = std::max({row_down, std::abs(p.sw - p.nw), std::abs(p.se - p.ne)});
        }
        down = spline_ && grid_.isCap(j) ? down + row_down : std::max(down, row_down);
    }
    return {across, down};
}

// Coordinates off by 2 ulp turn the longitude by 3 eps / sin(theta), atan2 and the scaling to columns add less than
// 20 eps; the colatitude errs by less than 8 eps; lengths and interpolation by a few eps of their size, those of a
// spline by some more. In a cap b / sin(theta) is greatest at its circle.
std::vector<double> Surface::boundEvaluationErrors() const {
    const double stored = greatest_stored_, scale = std::abs(relief_.scale);
    const double everywhere =
        16.0 * greatest_radius_ + 8.0 * std::abs(relief_.base) + (spline_ || ripples_ ? 24.0 : 8.0) * scale * stored;
    std::vector<double> errors;
    for (int j = 0; j < grid_.rows(); ++j) {
        const CellSlopes slope = steepest(j);
        const double north_sine = j == 0 ? 1.0 : std::sin(grid_.colatitudeOf(j));
        const double south_sine = j == grid_.rows() - 1 ? 1.0 : std::sin(grid_.colatitudeOf(j + 1));
        const double east = slope.east / (grid_.cellWidth() * std::min(north_sine, south_sine));
        errors.push_back(kEpsilon * (everywhere + scale * (24.0 * east + 8.0 * slope.south / grid_.cellHeight(j))));
    }
    return errors;
}

}  // namespace dsphere::reference
