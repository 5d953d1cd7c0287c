#include "surface/nodes.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace dsphere {

namespace {

constexpr int kRippleWidth = 1024, kRippleRows = 512, kCellsPerRipple = 32;

int evenFactor(int least, int count) {
    int factor = (least + count - 1) / count;
    return std::max(2, factor + factor % 2);
}

}  // namespace

NodeGrid::NodeGrid(const Heightmap& map) : map_(map) {
    if (map.ripples) {
        spanRipples();
        return;
    }
    bool texel = map.registration == Registration::Texel;
    width_ = map.width;
    rows_ = texel ? map.height + 1 : map.height - 1;
    half_caps_ = texel;
    cap_rows_ = texel ? 1 : 0;
    first_node_ = texel ? 0.5 : 0.0;
    assert(rows_ >= 1);
    if (width_ < kLeastWidth || map.height < kLeastRows) {
        subdivide();
        return;
    }
    north_.assign(std::size_t(width_), map.north_pole);
    south_.assign(std::size_t(width_), map.south_pole);
}

void NodeGrid::spanRipples() {
    width_ = std::max(kRippleWidth, kCellsPerRipple * map_.ripples->u_frequency);
    rows_ = std::max(kRippleRows, kCellsPerRipple / 2 * map_.ripples->v_frequency);
}

// Even factors put the half-texel offset of texel registration, and its half-high caps, onto whole fine nodes.
void NodeGrid::subdivide() {
    bool texel = half_caps_;
    int coarse_rows = rows_, coarse_width = width_;
    int across = evenFactor(kLeastWidth, coarse_width);
    int down = evenFactor(kLeastRows, texel ? map_.height : coarse_rows);
    double u_shift = texel ? 0.5 : 0.0;

    auto coarse = [&](int i, int j) -> double {  // node of the coarse grid, pole rows included
        i = (i % coarse_width + coarse_width) % coarse_width;
        if (texel) --j;
        if (j < 0) return map_.north_pole;
        if (j >= map_.height) return map_.south_pole;
        return map_.at(i, j);
    };
    int fine_width = coarse_width * across;
    int fine_rows = (texel ? map_.height : coarse_rows) * down;
    fine_.resize(std::size_t(fine_width) * std::size_t(fine_rows + 1));
    for (int fj = 0; fj <= fine_rows; ++fj) {
        double y = double(fj) / down + (texel ? 0.5 : 0.0);  // in coarse node rows, caps as if whole
        int j = std::clamp(int(std::floor(y)), 0, coarse_rows - 1);
        double fv = y - j;
        if (texel && j == 0) fv = 2.0 * (y - 0.5);
        if (texel && j == coarse_rows - 1) fv = 2.0 * (y - j);
        // One row of a 1-row texel map holds both caps' ends: y in [0.5, 1] is north, [1, 1.5] south.
        for (int fi = 0; fi < fine_width; ++fi) {
            double x = double(fi) / across - u_shift;
            int i = int(std::floor(x));
            double fu = x - i;
            double north = coarse(i, j) + fu * (coarse(i + 1, j) - coarse(i, j));
            double south = coarse(i, j + 1) + fu * (coarse(i + 1, j + 1) - coarse(i, j + 1));
            fine_[std::size_t(fj) * std::size_t(fine_width) + std::size_t(fi)] = float(north + fv * (south - north));
        }
    }
    width_ = fine_width;
    rows_ = fine_rows;
    half_caps_ = false;
    cap_rows_ = texel ? down / 2 : 0;
    first_node_ = 0.0;
}

double NodeGrid::mapColumn(int i) const {
    bool texel = map_.registration == Registration::Texel;
    return (i + first_node_) * map_.width / width_ - (texel ? 0.5 : 0.0);
}

double NodeGrid::mapRow(int j) const {
    if (map_.registration == Registration::Gridline) return double(j) * (map_.height - 1) / rows_;
    if (!half_caps_) return double(j) * map_.height / rows_ - 0.5;
    if (j == 0) return -0.5;
    return j == rows_ ? map_.height - 0.5 : j - 1.0;
}

const float* NodeGrid::row(int j) const {
    assert(j >= 0 && j <= rows_ && !map_.ripples && !map_.tiled);
    if (!fine_.empty()) return &fine_[std::size_t(j) * std::size_t(width_)];
    if (half_caps_) {
        if (j == 0) return north_.data();
        if (j == rows_) return south_.data();
        --j;
    }
    return &map_.samples[std::size_t(j) * std::size_t(width_)];
}

float NodeGrid::tiledNode(int i, int j) const {
    if (j == 0) return map_.north_pole;
    if (j == rows_) return map_.south_pole;
    return map_.at(i, half_caps_ ? j - 1 : j);
}

double NodeGrid::cellWidth() const {
    return 2.0 * kPi / width_;
}

double NodeGrid::cellHeight() const {
    return kPi / (half_caps_ ? rows_ - 1 : rows_);
}

double NodeGrid::longitude(int i) const {
    double shift = (map_.longitude_origin + 180.0) / 360.0;
    return 2.0 * kPi * ((i + first_node_) / width_ + shift - 0.5);
}

double NodeGrid::colatitude(int j) const {
    if (!half_caps_) return cellHeight() * j;
    if (j == 0) return 0.0;
    if (j == rows_) return kPi;
    return cellHeight() * (j - 0.5);
}

double NodeGrid::column(double longitude) const {
    double shift = (map_.longitude_origin + 180.0) / 360.0;
    return (longitude / (2.0 * kPi) + 0.5 - shift) * width_ - first_node_;
}

double NodeGrid::nodeRow(double colatitude) const {
    return colatitude / cellHeight() + (half_caps_ ? 0.5 : 0.0);
}

}  // namespace dsphere
