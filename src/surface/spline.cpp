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
    ControlRow() = default;
    ControlRow(const Heightmap& map, int j) : map_(&map) {
        int last = map.height - 1;
        bool beyond = j < 0 || j > last;
        row_ = std::clamp(j, 0, last);
        mirrored_ = beyond && map.registration == Registration::Gridline;
        if (mirrored_) row_ = j < 0 ? std::min(-j, last) : std::max(2 * last - j, 0);
        twice_pole_ = 2.0 * double(j < 0 ? map.north_pole : map.south_pole);
    }

    double at(int i) const {
        double stored = map_->at(i, row_);
        return mirrored_ ? twice_pole_ - stored : stored;
    }

  private:
    const Heightmap* map_ = nullptr;
    int row_ = 0;
    bool mirrored_ = false;
    double twice_pole_ = 0.0;
};

/// A control point and its slope southward on a parallel, summed over the four rows about it.
struct ColumnSum {
    double value = 0.0, slope = 0.0;
};

/// The spline along a row of a grid's nodes, still to be summed over columns.
class Parallel {
  public:
    Parallel(const NodeGrid& nodes, int j) : nodes_(nodes) {
        const Heightmap& map = nodes.map();
        const double map_row = nodes.mapRow(j), last = map.height - 1;
        const bool texel = map.registration == Registration::Texel;
        cap_ = texel && (map_row < 0.0 || map_row > last);
        pole_ = map_row < 0.0 ? map.north_pole : map.south_pole;
        if (cap_) share_ = 2.0 * (map_row < 0.0 ? map_row + 0.5 : last + 0.5 - map_row);
        per_column_ = double(map.width) / nodes.width();
        per_row_ = double(texel ? map.height : map.height - 1) * nodes.cellHeight() / kPi;
        const double on_circle = std::clamp(map_row, 0.0, last);
        const int first = std::clamp(int(std::floor(on_circle)), 0, std::max(map.height - 1, 0));
        weights_ = SplineWeights(on_circle - first);
        for (int k = 0; k < 4; ++k) rows_[std::size_t(k)] = ControlRow(map, first - 1 + k);
    }

    ColumnSum column(int i) const {
        ColumnSum sum;
        for (std::size_t k = 0; k < 4; ++k) {
            const double control = rows_[k].at(i);
            sum.value += weights_.value[k] * control;
            sum.slope += weights_.slope[k] * control;
        }
        return sum;
    }

    /// `columnAt(i)`: column(i).
    template <typename ColumnAt>
    SplineNodes::Node node(int i, const ColumnAt& columnAt) const {
        const int width = nodes_.map().width;
        const double column = nodes_.mapColumn(i);
        const int first = int(std::floor(column));
        const SplineWeights weights(column - first);
        double value = 0.0, east = 0.0, south = 0.0, twist = 0.0;
        for (int k = 0; k < 4; ++k) {
            const ColumnSum sum = columnAt(((first - 1 + k) % width + width) % width);
            const std::size_t w = std::size_t(k);
            value += weights.value[w] * sum.value;
            east += weights.slope[w] * sum.value;
            south += weights.value[w] * sum.slope;
            twist += weights.slope[w] * sum.slope;
        }
        if (cap_) return {float(pole_ + share_ * (value - pole_)), float(share_ * east * per_column_), 0.0f, 0.0f};
        return {float(value), float(east * per_column_), float(south * per_row_),
                float(twist * per_column_ * per_row_)};
    }

  private:
    const NodeGrid& nodes_;
    bool cap_ = false;
    double pole_ = 0.0, share_ = 1.0, per_column_ = 1.0, per_row_ = 1.0;
    SplineWeights weights_{0.0};
    std::array<ControlRow, 4> rows_;
};

}  // namespace

SplineWeights::SplineWeights(double t) {
    const double r = 1.0 - t;
    value = {r * r * r / 6.0, (4.0 - 6.0 * t * t + 3.0 * t * t * t) / 6.0, (4.0 - 6.0 * r * r + 3.0 * r * r * r) / 6.0,
             t * t * t / 6.0};
    slope = {-r * r / 2.0, (3.0 * t * t - 4.0 * t) / 2.0, (4.0 * r - 3.0 * r * r) / 2.0, t * t / 2.0};
}

std::vector<SplineNodes::Node> SplineNodes::row(int j) const {
    const Parallel parallel(nodes_, j);
    std::vector<ColumnSum> columns(std::size_t(nodes_.map().width));
    for (std::size_t i = 0; i < columns.size(); ++i) columns[i] = parallel.column(int(i));
    std::vector<Node> row(std::size_t(nodes_.width()));
    for (std::size_t i = 0; i < row.size(); ++i)
        row[i] = parallel.node(int(i), [&](int column) { return columns[std::size_t(column)]; });
    return row;
}

SplineNodes::Node SplineNodes::at(int i, int j) const {
    const Parallel parallel(nodes_, j);
    return parallel.node(i, [&](int column) { return parallel.column(column); });
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
