#include "reference/grid.h"

#include "base/math.h"
#include "surface/tiledheights.h"

#include <cassert>
#include <cmath>

namespace dsphere::reference {

PatchGrid::PatchGrid(const Heightmap& map) : map_(&map), columns_(map.width) {
    const bool texel = map.registration == Registration::Texel;
    assert(map.width >= 1 && map.height >= (texel ? 1 : 2));
    assert(map.tiled || map.samples.size() == std::size_t(map.width) * std::size_t(map.height));
    rows_ = texel ? map.height + 1 : map.height - 1;
    line_offset_ = texel ? -1 : 0;
    line_shift_ = texel ? 0.5 : 0.0;
    row_height_ = kPi / (texel ? map.height : map.height - 1);
    cap_height_ = texel ? 0.5 * row_height_ : row_height_;
    if (map.ripples) {
        columns_ = kCellsPerRipple * map.ripples->u_frequency;
        rows_ = kCellsPerRipple / 2 * map.ripples->v_frequency;
        line_offset_ = 0;
        line_shift_ = 0.0;
        row_height_ = cap_height_ = kPi / rows_;
    }
    cell_width_ = 2.0 * kPi / columns_;
    double turns = (map.longitude_origin + 180.0) / 360.0;
    double shift = columns_ * (turns - std::floor(turns)) + (texel && !map.ripples ? 0.5 : 0.0);
    column_shift_ = shift - columns_ * std::floor(shift / columns_);
}

double PatchGrid::columnOf(double longitude) const {
    double x = (longitude + kPi) / cell_width_ - column_shift_;
    if (x < 0.0) x += columns_;
    return x < columns_ ? x : std::max(0.0, x - columns_);
}

double PatchGrid::rowOf(double colatitude) const {
    double y = colatitude / row_height_ + line_shift_;
    // A cap is half a row high (line_shift = 1/2) or a whole one (0), and one unit of the row coordinate.
    if (line_shift_ > 0.0) {
        if (y < 1.0) y = colatitude / cap_height_;
        if (y > rows_ - 1) y = rows_ - 1 + 2.0 * (y - (rows_ - 1));
    }
    return std::clamp(y, 0.0, double(rows_));
}

double PatchGrid::colatitudeOf(double row) const {
    if (row <= 1.0) return row * cap_height_;
    if (row >= rows_ - 1) return kPi - (rows_ - row) * cap_height_;
    return (row - line_shift_) * row_height_;
}

Patch PatchGrid::patch(int column, int row) const {
    const int next = column + 1 < columns_ ? column + 1 : 0;
    const int north = row + line_offset_, south = north + 1;
    Patch p;
    if (row == 0) {
        p.nw = p.ne = map_->north_pole;
    } else {
        p.nw = map_->at(column, north);
        p.ne = map_->at(next, north);
    }
    if (row == rows_ - 1) {
        p.sw = p.se = map_->south_pole;
    } else {
        p.sw = map_->at(column, south);
        p.se = map_->at(next, south);
    }
    return p;
}

const BlockExtremes* PatchGrid::blocks() const {
    return map_->tiled ? &map_->tiled->survey().blocks : nullptr;
}

double PatchGrid::value(double column, double row) const {
    int i = std::min(int(column), columns_ - 1), j = std::min(int(row), rows_ - 1);
    return patch(i, j).value(column - i, row - j);
}

}  // namespace dsphere::reference
