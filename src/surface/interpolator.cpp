#include "surface/interpolator.h"

#include "base/math.h"
#include "surface/ripples.h"
#include "surface/spline.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dsphere {

Interpolator::Interpolator(const Heightmap& map, Filter filter)
    : map_(&map), spline_(filter == Filter::BSpline), texel_(map.registration == Registration::Texel) {
    const double turns = (map.longitude_origin + 180.0) / 360.0 - 0.5;
    columns_per_radian_ = map.width / (2.0 * kPi);
    first_column_ = map.width * (turns - std::floor(turns)) + (texel_ ? 0.5 : 0.0);
    rows_per_radian_ = (texel_ ? map.height : map.height - 1) / kPi;
}

HeightSample Interpolator::ripples(double longitude, double colatitude) const {
    const double a = ripplePhase(*map_, longitude), m = map_->ripples->u_frequency, n = map_->ripples->v_frequency;
    const double b = n * colatitude;
    return {0.5 + 0.5 * std::sin(a) * std::sin(b), 0.5 * m * std::cos(a) * std::sin(b),
            0.5 * n * std::sin(a) * std::cos(b)};
}

HeightSample Interpolator::atTexel(double column, double row) const {
    return spline_ ? spline(column, row) : bilinear(column, row);
}

HeightSample Interpolator::at(double longitude, double colatitude) const {
    if (map_->ripples) return ripples(longitude, colatitude);
    const double column = longitude * columns_per_radian_ - first_column_;
    const double row = colatitude * rows_per_radian_ - (texel_ ? 0.5 : 0.0), last = map_->height - 1;
    HeightSample sample;
    if (texel_ && (row < 0.0 || row > last)) {
        // Between a pole and the row of values next to it heights run linearly.
        const bool north = row < 0.0;
        const double pole = north ? map_->north_pole : map_->south_pole;
        const double share = 2.0 * (north ? row + 0.5 : last + 0.5 - row);
        const HeightSample edge = atTexel(column, north ? 0.0 : last);
        sample.stored = pole + share * (edge.stored - pole);
        sample.per_longitude = share * edge.per_longitude;
        sample.per_colatitude = (north ? 2.0 : -2.0) * (edge.stored - pole);
        sample.mixed = (north ? 2.0 : -2.0) * edge.per_longitude;
    } else {
        sample = atTexel(column, row);
    }
    sample.per_longitude *= columns_per_radian_;
    sample.per_colatitude *= rows_per_radian_;
    sample.mixed *= columns_per_radian_ * rows_per_radian_;
    return sample;
}

// Rows from a pole to the row of values next to it have floors of their own: -1 and that of the last row.
bool Interpolator::onOnePatch(double longitude_a, double colatitude_a, double longitude_b, double colatitude_b) const {
    if (spline_ || map_->ripples) return false;
    const auto column = [&](double longitude) { return std::floor(longitude * columns_per_radian_ - first_column_); };
    const auto row = [&](double colatitude) {
        return std::floor(colatitude * rows_per_radian_ - (texel_ ? 0.5 : 0.0));
    };
    return column(longitude_a) == column(longitude_b) && row(colatitude_a) == row(colatitude_b);
}

// Rows of gridline registration that are poles hold one value.
double Interpolator::texel(int column, int row) const {
    if (!texel_ && row == 0) return map_->north_pole;
    if (!texel_ && row == map_->height - 1) return map_->south_pole;
    return map_->at(column, row);
}

HeightSample Interpolator::bilinear(double column, double row) const {
    const int width = map_->width, last = map_->height - 1;
    const double floor = std::floor(column);
    const double a = column - floor;
    int i = int(floor);  // from minus one and a half widths on
    while (i < 0) i += width;
    if (i >= width) i -= width;
    const int next = i + 1 < width ? i + 1 : 0;
    const int j = std::clamp(int(row), 0, std::max(last - 1, 0)), below = std::min(j + 1, last);
    const double b = row - j;
    const double nw = texel(i, j), ne = texel(next, j), sw = texel(i, below), se = texel(next, below);
    const double north = nw + a * (ne - nw), south = sw + a * (se - sw);
    return {north + b * (south - north), (1.0 - b) * (ne - nw) + b * (se - sw), south - north, (se - sw) - (ne - nw)};
}

// Beyond the first and the last row texels repeat; gridline rows are mirrored through the pole's value.
double Interpolator::control(int column, int row) const {
    const int last = map_->height - 1;
    const bool beyond = row < 0 || row > last;
    if (!beyond) return texel(column, row);
    if (texel_) return texel(column, std::clamp(row, 0, last));
    const double pole = row < 0 ? map_->north_pole : map_->south_pole;
    return 2.0 * pole - texel(column, row < 0 ? std::min(-row, last) : std::max(2 * last - row, 0));
}

HeightSample Interpolator::spline(double column, double row) const {
    const int width = map_->width;
    const double floor = std::floor(column);
    const int first = int(floor) - 1, top = std::clamp(int(row), 0, map_->height - 1);
    const SplineWeights across(column - floor), down(row - top);
    HeightSample sum;
    for (std::size_t m = 0; m < 4; ++m)
        for (std::size_t k = 0; k < 4; ++k) {
            const double point = control(((first + int(k)) % width + width) % width, top - 1 + int(m));
            sum.stored += down.value[m] * across.value[k] * point;
            sum.per_longitude += down.value[m] * across.slope[k] * point;
            sum.per_colatitude += down.slope[m] * across.value[k] * point;
        }
    return sum;
}

}  // namespace dsphere
