#include "reference/surface.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace dsphere::reference {

namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

double colatitude(const dvec3& p) {
    return std::atan2(std::hypot(p.x, p.z), p.y);
}

}  // namespace

Surface::Surface(const Heightmap& map, const Relief& relief) : grid_(map), pyramid_(grid_), relief_(relief) {
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
    return grid_.value(grid_.columnOf(std::atan2(p.x, p.z)), grid_.rowOf(colatitude(p)));
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

// With longitude phi (east), colatitude theta (south) and rho = |p|:
//   grad f = e_r - (1 / rho) (dr/dtheta e_south + dr/dphi / sin(theta) e_east).
// In a cap dr/dphi = b D / cell width with b = theta' / cap height, theta' the angle from that pole, D the difference
// along the cap's circle: theta' / sin(theta') has no pole.
dvec3 Surface::gradient(const dvec3& p) const {
    const double rho = glm::length(p), q = std::hypot(p.x, p.z);
    const dvec3 e_r = p / rho;
    if (q == 0.0) return e_r;
    const double theta = colatitude(p), column = grid_.columnOf(std::atan2(p.x, p.z)), row = grid_.rowOf(theta);
    const int i = std::min(int(column), grid_.columns() - 1), j = std::min(int(row), grid_.rows() - 1);
    const Patch patch = grid_.patch(i, j);
    double east;  // dstored/dcolumn / sin(theta)
    if (grid_.isCap(j)) {
        const double from_pole = j == 0 ? theta : std::atan2(q, -p.y);
        const double along = j == 0 ? patch.se - patch.sw : patch.ne - patch.nw;
        east = along == 0.0 ? 0.0 : along / grid_.cellHeight(j) * (from_pole / (q / rho));
    } else {
        east = patch.slopeEast(row - j) / (q / rho);
    }
    const double g_east = relief_.scale * east / (grid_.cellWidth() * rho);
    const double g_south = relief_.scale * patch.slopeSouth(column - i) / (grid_.cellHeight(j) * rho);
    const double sin_phi = p.x / q, cos_phi = p.z / q;
    const dvec3 e_east(cos_phi, 0.0, -sin_phi);
    const dvec3 e_south(e_r.y * sin_phi, -q / rho, e_r.y * cos_phi);
    return e_r - g_east * e_east - g_south * e_south;
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

RadiusBounds Surface::cellBounds(double column0, double column1, double row0, double row1) const {
    const int last_row = grid_.rows() - 1;
    const int i0 = std::min(int(column0), grid_.columns() - 1), i1 = std::max(i0, int(column1));
    const int j0 = std::min(int(row0), last_row), j1 = std::min(int(row1), last_row);
    const Range range = pyramid_.range(grid_, i0, i1, j0, j1);
    double least = range.least, greatest = range.greatest;
    // Within a cap a value lies between the pole's and the circle's in proportion to the distance from the pole.
    if (j1 == 0) {
        const double pole = grid_.pole(false);
        least = std::max(least, pole + row1 * (range.least - pole));
        greatest = std::min(greatest, pole + row1 * (range.greatest - pole));
    }
    if (j0 == last_row) {
        const double pole = grid_.pole(true), share = grid_.rows() - row0;
        least = std::max(least, pole + share * (range.least - pole));
        greatest = std::min(greatest, pole + share * (range.greatest - pole));
    }
    const double a = radiusOf(least), b = radiusOf(greatest);
    const double margin =
        4.0 * kEpsilon *
        (std::abs(relief_.base) + std::abs(relief_.scale) * std::max(std::abs(range.least), std::abs(range.greatest)));
    return {std::min(a, b) - margin, std::max(a, b) + margin};
}

double Surface::evaluationError(double row0, double row1) const {
    const std::size_t end = row_errors_.size() - 1;  // the south pole counts as the last row
    const std::size_t first = std::min(std::size_t(row0), end), last = std::min(std::size_t(row1), end);
    if (last > first + 1) return evaluation_error_;
    return std::max(row_errors_[first], row_errors_[last]);
}

// Coordinates off by 2 ulp turn the longitude by 3 eps / sin(theta), atan2 and the scaling to columns add less than
// 20 eps; the colatitude errs by less than 8 eps; lengths and interpolation by a few eps of their size. In a cap
// b / sin(theta) is greatest at its circle. Slopes are the steepest of each row.
std::vector<double> Surface::boundEvaluationErrors() const {
    const Range all = pyramid_.range(grid_, 0, grid_.columns() - 1, 0, grid_.rows() - 1);
    const double stored = std::max(std::abs(all.least), std::abs(all.greatest)), scale = std::abs(relief_.scale);
    const double everywhere = 16.0 * greatest_radius_ + 8.0 * (std::abs(relief_.base) + scale * stored);
    std::vector<double> errors;
    for (int j = 0; j < grid_.rows(); ++j) {
        double across = 0.0, down = 0.0;
        for (int i = 0; i < grid_.columns(); ++i) {
            const Patch p = grid_.patch(i, j);
            across = std::max({across, std::abs(p.ne - p.nw), std::abs(p.se - p.sw)});
            down = std::max({down, std::abs(p.sw - p.nw), std::abs(p.se - p.ne)});
        }
        const double north_sine = j == 0 ? 1.0 : std::sin(grid_.colatitudeOf(j));
        const double south_sine = j == grid_.rows() - 1 ? 1.0 : std::sin(grid_.colatitudeOf(j + 1));
        const double east = across / (grid_.cellWidth() * std::min(north_sine, south_sine));
        errors.push_back(kEpsilon * (everywhere + scale * (24.0 * east + 8.0 * down / grid_.cellHeight(j))));
    }
    return errors;
}

}  // namespace dsphere::reference
