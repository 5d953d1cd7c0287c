#include "surface/spline.h"

#include "base/parallel.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dsphere {

namespace {

/// One row of control points: of the map, or beyond its ends.
class ControlRow {
  public:
    ControlRow(const Heightmap& map, int j) : map_(map) {
        int last = map.height - 1;
        bool beyond = j < 0 || j > last;
        row_ = std::clamp(j, 0, last);
        mirrored_ = beyond && map.registration == Registration::Gridline;
        if (mirrored_) row_ = j < 0 ? std::min(-j, last) : std::max(2 * last - j, 0);
        twice_pole_ = 2.0 * double(j < 0 ? map.north_pole : map.south_pole);
    }

    double at(int i) const {
        double stored = map_.at(i, row_);
        return mirrored_ ? twice_pole_ - stored : stored;
    }

  private:
    const Heightmap& map_;
    int row_ = 0;
    bool mirrored_ = false;
    double twice_pole_ = 0.0;
};

/// A row's control points and their slopes southward, summed over the four rows about it.
struct Columns {
    std::vector<double> value, slope;

    Columns(const Heightmap& map, double map_row) : value(std::size_t(map.width)), slope(std::size_t(map.width)) {
        int first = std::clamp(int(std::floor(map_row)), 0, std::max(map.height - 1, 0));
        SplineWeights weights(map_row - first);
        for (int k = 0; k < 4; ++k) {
            ControlRow row(map, first - 1 + k);
            for (int i = 0; i < map.width; ++i) {
                value[std::size_t(i)] += weights.value[std::size_t(k)] * row.at(i);
                slope[std::size_t(i)] += weights.slope[std::size_t(k)] * row.at(i);
            }
        }
    }
};

}  // namespace

SplineWeights::SplineWeights(double t) {
    const double r = 1.0 - t;
    value = {r * r * r / 6.0, (4.0 - 6.0 * t * t + 3.0 * t * t * t) / 6.0, (4.0 - 6.0 * r * r + 3.0 * r * r * r) / 6.0,
             t * t * t / 6.0};
    slope = {-r * r / 2.0, (3.0 * t * t - 4.0 * t) / 2.0, (4.0 * r - 3.0 * r * r) / 2.0, t * t / 2.0};
}

std::vector<SplineNodes::Node> SplineNodes::row(int j) const {
    const Heightmap& map = nodes_.map();
    double map_row = nodes_.mapRow(j), last = map.height - 1;
    bool texel = map.registration == Registration::Texel, cap = texel && (map_row < 0.0 || map_row > last);
    double pole = map_row < 0.0 ? map.north_pole : map.south_pole;
    double share = cap ? 2.0 * (map_row < 0.0 ? map_row + 0.5 : last + 0.5 - map_row) : 1.0;
    Columns columns(map, std::clamp(map_row, 0.0, last));
    double per_column = double(map.width) / nodes_.width();
    double per_row = double(texel ? map.height : map.height - 1) * nodes_.cellHeight() / kPi;
    std::vector<Node> row(std::size_t(nodes_.width()));
    for (int i = 0; i < nodes_.width(); ++i) {
        double column = nodes_.mapColumn(i);
        int first = int(std::floor(column));
        SplineWeights weights(column - first);
        double value = 0.0, east = 0.0, south = 0.0, twist = 0.0;
        for (int k = 0; k < 4; ++k) {
            std::size_t at = std::size_t(((first - 1 + k) % map.width + map.width) % map.width), w = std::size_t(k);
            value += weights.value[w] * columns.value[at];
            east += weights.slope[w] * columns.value[at];
            south += weights.value[w] * columns.slope[at];
            twist += weights.slope[w] * columns.slope[at];
        }
        if (cap)
            row[std::size_t(i)] = {float(pole + share * (value - pole)), float(share * east * per_column), 0.0f, 0.0f};
        else
            row[std::size_t(i)] = {float(value), float(east * per_column), float(south * per_row),
                                   float(twist * per_column * per_row)};
    }
    return row;
}

std::vector<float> SplineNodes::extremes(bool greatest) const {
    std::size_t width = std::size_t(nodes_.width());
    std::vector<float> all(width * std::size_t(nodes_.rows() + 1));
    parallelFor(std::size_t(nodes_.rows() + 1), [&](std::size_t j) {
        std::vector<Node> nodes = row(int(j));
        for (std::size_t i = 0; i < width; ++i) {
            const auto [value, east, south, twist] = nodes[i];
            const float sign = greatest ? 1.0f : -1.0f, a = sign * east / 3.0f;
            float reach = std::abs(a);
            for (float side : {-1.0f, 1.0f}) {
                if (int(j) == (side < 0.0f ? 0 : nodes_.rows())) continue;  // beyond a pole there is no cell
                const float b = sign * side * south / 3.0f, c = sign * side * twist / 9.0f;
                reach = std::max(reach, b + std::max({0.0f, a + c, -a - c}));
            }
            all[j * width + i] = value + sign * reach;
        }
    });
    return all;
}

}  // namespace dsphere
