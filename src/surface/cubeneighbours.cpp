#include "surface/cubeneighbours.h"

#include "base/math.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dsphere {

namespace {

constexpr float kNothing = -std::numeric_limits<float>::infinity();

/// The direction of face coordinates (a, b), on the plane of a face or beyond.
dvec3 directionOf(int face, double a, double b) {
    const int axis = face / 2;
    dvec3 w;
    w[axis] = face % 2 == 1 ? -1.0 : 1.0;
    w[(axis + 1) % 3] = a;
    w[(axis + 2) % 3] = b;
    return w;
}

}  // namespace

CubeGrid::CubeGrid(int side) : side_(side), values_(std::size_t(6) * std::size_t(side) * std::size_t(side)) {}

float CubeGrid::greatest() const {
    return std::ranges::max(values_);
}

CubeGrid CubeGrid::halved() const {
    CubeGrid half(side_ / 2);
    for (int face = 0; face < 6; ++face)
        for (int j = 0; j < half.side_; ++j)
            for (int i = 0; i < half.side_; ++i)
                half.at(face, i, j) = std::max(std::max(at(face, 2 * i, 2 * j), at(face, 2 * i + 1, 2 * j)),
                                               std::max(at(face, 2 * i, 2 * j + 1), at(face, 2 * i + 1, 2 * j + 1)));
    return half;
}

// Of a cell beside its face: the part of its square that lies on a neighbouring face is there within the box of the
// corners' images, since lines stay lines.
float CubeGrid::greatestBehind(int face, int i, int j) const {
    const double width = 2.0 / side_;
    float greatest = kNothing;
    for (int step : {1, 2}) {
        const int across = step == 1 ? i : j;
        if (across >= 0 && across < side_) continue;
        const int axis = (face / 2 + step) % 3, other = 2 * axis + (across < 0 ? 1 : 0);
        double low[2] = {2.0, 2.0}, high[2] = {-2.0, -2.0};
        for (int di : {0, 1})
            for (int dj : {0, 1}) {
                const dvec3 w = directionOf(face, (i + di) * width - 1.0, (j + dj) * width - 1.0);
                for (int k : {0, 1}) {
                    const double along = w[(axis + 1 + k) % 3] / std::abs(w[axis]);
                    low[k] = std::min(low[k], along);
                    high[k] = std::max(high[k], along);
                }
            }
        if (low[0] > 1.0 || low[1] > 1.0 || high[0] < -1.0 || high[1] < -1.0) continue;
        const auto cell = [&](double along) {
            return std::clamp(int(std::floor((along + 1.0) / width)), 0, side_ - 1);
        };
        constexpr double kRounding = 1e-9;
        for (int l = cell(low[1] - kRounding); l <= cell(high[1] + kRounding); ++l)
            for (int k = cell(low[0] - kRounding); k <= cell(high[0] + kRounding); ++k)
                greatest = std::max(greatest, at(other, k, l));
    }
    return greatest;
}

CubeGrid CubeGrid::dilated(int rings) const {
    CubeGrid result(side_);
    const int padded = side_ + 2 * rings;
    std::vector<float> rows(std::size_t(padded) * std::size_t(padded)),
        columns(std::size_t(side_) * std::size_t(padded));
    for (int face = 0; face < 6; ++face) {
        for (int j = 0; j < padded; ++j)
            for (int i = 0; i < padded; ++i) {
                const int fi = i - rings, fj = j - rings;
                const bool inside = fi >= 0 && fj >= 0 && fi < side_ && fj < side_;
                rows[std::size_t(j) * std::size_t(padded) + std::size_t(i)] =
                    inside ? at(face, fi, fj) : greatestBehind(face, fi, fj);
            }
        for (int j = 0; j < padded; ++j)
            for (int i = 0; i < side_; ++i) {
                const float* const from = &rows[std::size_t(j) * std::size_t(padded) + std::size_t(i)];
                columns[std::size_t(j) * std::size_t(side_) + std::size_t(i)] =
                    *std::max_element(from, from + 2 * rings + 1);
            }
        for (int j = 0; j < side_; ++j)
            for (int i = 0; i < side_; ++i) {
                float greatest = kNothing;
                for (int k = 0; k <= 2 * rings; ++k)
                    greatest = std::max(greatest, columns[std::size_t(j + k) * std::size_t(side_) + std::size_t(i)]);
                result.at(face, i, j) = greatest;
            }
    }
    return result;
}

}  // namespace dsphere
