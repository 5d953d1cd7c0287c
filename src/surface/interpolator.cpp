#include "surface/interpolator.h"

#include "base/math.h"
#include "surface/ripples.h"
#include "surface/spline.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

namespace dsphere {

Interpolator::Interpolator(const Heightmap& map, Filter filter)
    : map_(&map), spline_(filter == Filter::BSpline), texel_(map.registration == Registration::Texel) {
    const double turns = (map.longitude_origin + 180.0) / 360.0 - 0.5;
    steps_.columns_per_radian = map.width / (2.0 * kPi);
    steps_.first_column = map.width * (turns - std::floor(turns)) + (texel_ ? 0.5 : 0.0);
    steps_.rows_per_radian = (texel_ ? map.height : map.height - 1) / kPi;
    steps_.first_row = texel_ ? 0.5 : 0.0;
}

HeightSample Interpolator::ripples(double longitude, double colatitude) const {
    const double a = ripplePhase(*map_, longitude), m = map_->ripples->u_frequency, n = map_->ripples->v_frequency;
    const double b = n * colatitude;
    return {0.5 + 0.5 * std::sin(a) * std::sin(b), 0.5 * m * std::cos(a) * std::sin(b),
            0.5 * n * std::sin(a) * std::cos(b)};
}

HeightSample Interpolator::at(double longitude, double colatitude) const {
    if (map_->ripples) return ripples(longitude, colatitude);
    const double column = longitude * steps_.columns_per_radian - steps_.first_column;
    const double row = colatitude * steps_.rows_per_radian - steps_.first_row;
    HeightSample sample = spline_ ? splineWithCaps(column, row) : ofPatch(patchAt(column, row));
    sample.per_longitude *= steps_.columns_per_radian;
    sample.per_colatitude *= steps_.rows_per_radian;
    sample.mixed *= steps_.columns_per_radian * steps_.rows_per_radian;
    return sample;
}

HeightSample Interpolator::ofPatch(const BilinearPatch& patch) const {
    const auto& [nw, ne, sw, se, east, south, rows_inverse] = patch;
    const double north_edge = nw + east * (ne - nw), south_edge = sw + east * (se - sw);
    return {north_edge + south * (south_edge - north_edge), (1.0 - south) * (ne - nw) + south * (se - sw),
            (south_edge - north_edge) * rows_inverse, ((se - sw) - (ne - nw)) * rows_inverse};
}

// Rows from a pole to the row of values next to it have floors of their own: -1 and that of the last row.
bool Interpolator::onOnePatch(double longitude_a, double colatitude_a, double longitude_b, double colatitude_b) const {
    if (!isBilinear()) return false;
    const auto column = [this](double longitude) {
        return std::floor(longitude * steps_.columns_per_radian - steps_.first_column);
    };
    const auto row = [this](double colatitude) {
        return std::floor(colatitude * steps_.rows_per_radian - steps_.first_row);
    };
    return column(longitude_a) == column(longitude_b) && row(colatitude_a) == row(colatitude_b);
}

// Rows of gridline registration that are poles hold one value.
double Interpolator::texel(int column, int row) const {
    if (!texel_ && row == 0) return map_->north_pole;
    if (!texel_ && row == map_->height - 1) return map_->south_pole;
    return map_->at(column, row);
}

BilinearPatch Interpolator::patchAt(double column, double row) const {
    const int width = map_->width, last = map_->height - 1;
    assert(column > -2.0 * width && column < 2.0 * width);
    const double floor = std::floor(column);
    int i = int(floor);
    while (i < 0) i += width;
    if (i >= width) i -= width;
    const int next = i + 1 < width ? i + 1 : 0;
    const double east = column - floor, north_pole = map_->north_pole, south_pole = map_->south_pole;
    // Between a pole and the row of values next to it heights run linearly.
    if (texel_ && row < 0.0) return {north_pole, north_pole, texel(i, 0), texel(next, 0), east, 2.0 * (row + 0.5), 2.0};
    if (texel_ && row > last)
        return {texel(i, last), texel(next, last), south_pole, south_pole, east, 2.0 * (row - last), 2.0};
    const int j = std::clamp(int(row), 0, std::max(last - 1, 0)), below = std::min(j + 1, last);
    return {texel(i, j), texel(next, j), texel(i, below), texel(next, below), east, row - j, 1.0};
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

HeightSample Interpolator::splineWithCaps(double column, double row) const {
    const double last = map_->height - 1;
    if (!texel_ || (row >= 0.0 && row <= last)) return spline(column, row);
    // Between a pole and the row of values next to it heights run linearly.
    const bool north = row < 0.0;
    const double pole = north ? map_->north_pole : map_->south_pole;
    const double share = 2.0 * (north ? row + 0.5 : last + 0.5 - row);
    const HeightSample edge = spline(column, north ? 0.0 : last);
    return {pole + share * (edge.value - pole), share * edge.per_longitude, (north ? 2.0 : -2.0) * (edge.value - pole),
            (north ? 2.0 : -2.0) * edge.per_longitude};
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
            sum.value += down.value[m] * across.value[k] * point;
            sum.per_longitude += down.value[m] * across.slope[k] * point;
            sum.per_colatitude += down.slope[m] * across.value[k] * point;
        }
    return sum;
}

}  // namespace dsphere
