#include "reference/curved.h"

#include "base/math.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dsphere::reference {

namespace {

/// Radians of its sine that a cell of the ripples' grid has: an eighth of a period.
constexpr double kPhase = 2.0 * kPi / PatchGrid::kCellsPerRipple;

SlopeRange around(double middle, double reach) {
    return {middle - reach, middle + reach};
}

SlopeRange scaled(double by, const SlopeRange& x) {
    return by >= 0.0 ? SlopeRange{by * x.least, by * x.greatest} : SlopeRange{by * x.greatest, by * x.least};
}

// The four basis functions' values, by repeated averaging of knots (de Boor), and their slopes.
std::array<double, 4> basis(double t) {
    const double s = 1.0 - t;
    return {s * s * s / 6.0, 2.0 / 3.0 - t * t * (1.0 - 0.5 * t), 2.0 / 3.0 - s * s * (1.0 - 0.5 * s), t * t * t / 6.0};
}

/// Of point(row, column), weighed by a basis of rows and one of columns.
template <std::size_t kRows, std::size_t kColumns>
double weighed(const std::array<double, kRows>& v, const std::array<double, kColumns>& u, const auto& point) {
    double sum = 0.0;
    for (std::size_t m = 0; m < kRows; ++m)
        for (std::size_t k = 0; k < kColumns; ++k) sum += v[m] * u[k] * point(m, k);
    return sum;
}

// Of the differences of neighbouring control points: the quadratic B-spline.
std::array<double, 3> slopeBasis(double t) {
    const double s = 1.0 - t;
    return {0.5 * s * s, 0.5 + t * s, 0.5 * t * t};
}

SlopeRange sines(double x0, double x1) {
    const double a = std::sin(x0), b = std::sin(x1);
    const auto reaches = [&](double crest) {
        return std::floor((x1 - crest) / (2.0 * kPi)) >= std::ceil((x0 - crest) / (2.0 * kPi));
    };
    return {reaches(1.5 * kPi) ? -1.0 : std::min(a, b), reaches(0.5 * kPi) ? 1.0 : std::max(a, b)};
}

SlopeRange cosines(double x0, double x1) {
    return sines(x0 + 0.5 * kPi, x1 + 0.5 * kPi);
}

}  // namespace

/// The 4x4 control points of a cell, [row][column].
struct SplineField::Controls {
    std::array<std::array<double, 4>, 4> c;

    double value(double a, double b) const {
        return weighed(basis(b), basis(a), [&](std::size_t m, std::size_t k) { return c[m][k]; });
    }
    double east(double a, double b) const {
        return weighed(basis(b), slopeBasis(a), [&](std::size_t m, std::size_t k) { return c[m][k + 1] - c[m][k]; });
    }
    double south(double a, double b) const {
        return weighed(slopeBasis(b), basis(a), [&](std::size_t m, std::size_t k) { return c[m + 1][k] - c[m][k]; });
    }
    // The second derivatives are averages of second differences, so these bound them over the cell.
    double bendEast() const {
        double most = 0.0;
        for (const auto& row : c)
            for (std::size_t k = 0; k < 2; ++k) most = std::max(most, std::abs(row[k] - 2.0 * row[k + 1] + row[k + 2]));
        return most;
    }
    double bendSouth() const {
        double most = 0.0;
        for (std::size_t k = 0; k < 4; ++k)
            for (std::size_t m = 0; m < 2; ++m)
                most = std::max(most, std::abs(c[m][k] - 2.0 * c[m + 1][k] + c[m + 2][k]));
        return most;
    }
    double twist() const {
        double most = 0.0;
        for (std::size_t m = 0; m < 3; ++m)
            for (std::size_t k = 0; k < 3; ++k)
                most = std::max(most, std::abs((c[m + 1][k + 1] - c[m + 1][k]) - (c[m][k + 1] - c[m][k])));
        return most;
    }
};

/// Four control points of a spline of u alone.
struct SplineField::Ring {
    std::array<double, 4> c;

    double value(double a) const {
        const auto u = basis(a);
        return u[0] * c[0] + u[1] * c[1] + u[2] * c[2] + u[3] * c[3];
    }
    double slope(double a) const {
        const auto u = slopeBasis(a);
        return u[0] * (c[1] - c[0]) + u[1] * (c[2] - c[1]) + u[2] * (c[3] - c[2]);
    }
    double steepest() const { return std::max({std::abs(c[1] - c[0]), std::abs(c[2] - c[1]), std::abs(c[3] - c[2])}); }
    double bend() const { return std::max(std::abs(c[0] - 2.0 * c[1] + c[2]), std::abs(c[1] - 2.0 * c[2] + c[3])); }
};

double SplineField::control(int i, int line) const {
    const int columns = map_->width, last = map_->height - 1;
    if (i < 0 || i >= columns) i = (i % columns + columns) % columns;
    if (line >= 0 && line <= last) return map_->at(i, line);
    if (map_->registration == Registration::Texel) return map_->at(i, std::clamp(line, 0, last));
    const double pole = line < 0 ? map_->north_pole : map_->south_pole;
    return 2.0 * pole - map_->at(i, line < 0 ? -line : 2 * last - line);
}

SplineField::Controls SplineField::controls(int i, int j) const {
    const int north = j + (map_->registration == Registration::Texel ? -1 : 0);
    Controls all;
    for (int m = 0; m < 4; ++m)
        for (int k = 0; k < 4; ++k) all.c[std::size_t(m)][std::size_t(k)] = control(i - 1 + k, north - 1 + m);
    return all;
}

SplineField::Ring SplineField::ring(int i, int line) const {
    Ring ring;
    for (int k = 0; k < 4; ++k) ring.c[std::size_t(k)] = control(i - 1 + k, line);
    return ring;
}

// The spline on the first (last) row's circle.
SplineField::Ring SplineField::circle(int i, bool south) const {
    const int line = south ? map_->height - 1 : 0;
    const Ring before = ring(i, line - 1), at = ring(i, line), after = ring(i, line + 1);
    Ring circle;
    for (std::size_t k = 0; k < 4; ++k) circle.c[k] = (before.c[k] + 4.0 * at.c[k] + after.c[k]) / 6.0;
    return circle;
}

double SplineField::value(int i, int j, double a, double b) const {
    if (!isLinear(j)) return controls(i, j).value(a, b);
    const bool south = j > 0;
    const double share = south ? 1.0 - b : b, pole = grid_.pole(south);
    return pole + share * (circle(i, south).value(a) - pole);
}

// Gridline, the row that touches a pole: with the mirrored row its spline is p + (s - s^3 / 3) (C1 - p) + s^3 / 6 (C2 -
// p), s the share of the way from the pole p, C1 and C2 the splines of u of the next two rows.
CellSlopes SplineField::slopes(int i, int j, double a, double b) const {
    const bool south = j > 0;
    if (isLinear(j)) {
        const Ring ring = circle(i, south);
        const double rise = ring.value(a) - grid_.pole(south);
        return {ring.slope(a), south ? -rise : rise};
    }
    const Controls all = controls(i, j);
    if (!grid_.isCap(j)) return {all.east(a, b), all.south(a, b)};
    const double s = south ? 1.0 - b : b;
    const Ring first = ring(i, south ? j : 1), second = ring(i, south ? j - 1 : 2);
    return {(1.0 - s * s / 3.0) * first.slope(a) + s * s / 6.0 * second.slope(a), all.south(a, b)};
}

CellSlopeRanges SplineField::slopes(int i, int j, const CellPart& part) const {
    const double a = 0.5 * (part.a0 + part.a1), b = 0.5 * (part.b0 + part.b1);
    const double reach_a = 0.5 * (part.a1 - part.a0), reach_b = 0.5 * (part.b1 - part.b0);
    const CellSlopes middle = slopes(i, j, a, b);
    const bool south = j > 0;
    if (isLinear(j)) {
        const Ring ring = circle(i, south);
        return {around(middle.east, ring.bend() * reach_a), around(middle.south, ring.steepest() * reach_a)};
    }
    const Controls all = controls(i, j);
    const double twist = all.twist();
    const SlopeRange down = around(middle.south, twist * reach_a + all.bendSouth() * reach_b);
    if (!grid_.isCap(j)) return {around(middle.east, all.bendEast() * reach_a + twist * reach_b), down};
    const Ring first = ring(i, south ? j : 1), second = ring(i, south ? j - 1 : 2);
    const double by_a = first.bend() + second.bend() / 6.0;
    const double by_b = 2.0 / 3.0 * first.steepest() + second.steepest() / 3.0;
    return {around(middle.east, by_a * reach_a + by_b * reach_b), down};
}

double RippleField::value(double column, double row) const {
    return 0.5 + 0.5 * std::sin(kPhase * column) * std::sin(kPhase * row);
}

// In the rows that touch a pole sin(phase s) / s, s the share of the way from it; the south pole's row is mirrored.
CellSlopes RippleField::slopes(int i, int j, double a, double b) const {
    const double u = kPhase * (i + a), v = kPhase * (j + b), half = 0.5 * kPhase;
    double over_share = std::sin(v);
    if (grid_.isCap(j)) {
        const double s = j == 0 ? b : 1.0 - b, x = kPhase * s;
        const double sinc = x > 1e-4 ? std::sin(x) / s : kPhase * (1.0 - x * x / 6.0);
        over_share = j == 0 || std::sin(kPhase * (j + 0.5)) > 0.0 ? sinc : -sinc;
    }
    return {half * std::cos(u) * over_share, half * std::sin(u) * std::cos(v)};
}

CellSlopeRanges RippleField::slopes(int i, int j, const CellPart& part) const {
    const double u0 = kPhase * (i + part.a0), u1 = kPhase * (i + part.a1);
    const double v0 = kPhase * (j + part.b0), v1 = kPhase * (j + part.b1), half = 0.5 * kPhase;
    SlopeRange over_share = sines(v0, v1);
    if (grid_.isCap(j)) {
        // sin(x) / x falls from the pole on.
        const double s0 = j == 0 ? part.b0 : 1.0 - part.b1, s1 = j == 0 ? part.b1 : 1.0 - part.b0;
        const auto sinc = [](double s) {
            const double x = kPhase * s;
            return x > 1e-4 ? std::sin(x) / s : kPhase * (1.0 - x * x / 6.0);
        };
        over_share = {sinc(s1), sinc(s0)};
        if (j > 0 && std::sin(kPhase * (j + 0.5)) < 0.0) over_share = {-over_share.greatest, -over_share.least};
    }
    return {scaled(half, product(cosines(u0, u1), over_share)), scaled(half, product(sines(u0, u1), cosines(v0, v1)))};
}

SlopeRange RippleField::range(double column0, double column1, double row0, double row1) const {
    const SlopeRange both = product(sines(kPhase * column0, kPhase * column1), sines(kPhase * row0, kPhase * row1));
    return {0.5 + 0.5 * both.least, 0.5 + 0.5 * both.greatest};
}

}  // namespace dsphere::reference
