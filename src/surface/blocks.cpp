#include "surface/blocks.h"

#include "base/parallel.h"
#include "surface/ripples.h"
#include "surface/spline.h"

#include <array>
#include <limits>

namespace dsphere {

namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();

void measureBilinear(BlockExtremes& blocks, const NodeGrid& nodes, int row) {
    const int width = nodes.width(), block = 1 << blocks.shift;
    const int first = row * block, end = std::min(first + block, nodes.rows());
    std::vector<float> least(nodes.row(first), nodes.row(first) + width), greatest = least;
    std::vector<float> squares(least.size(), 0.0f);
    for (int j = first; j < end; ++j) {
        const float* const south = nodes.row(j + 1);
        for (int i = 0; i < width; ++i) {
            least[std::size_t(i)] = std::min(least[std::size_t(i)], south[i]);
            greatest[std::size_t(i)] = std::max(greatest[std::size_t(i)], south[i]);
        }
        raiseSlopes(RowSlopes(nodes, j), nodes.row(j), south, width, squares.data());
    }
    for (int bi = 0; bi < blocks.columns; ++bi) {
        const std::size_t at = blocks.index(bi, row);
        for (int i = bi * block; i <= std::min((bi + 1) * block, width); ++i) {
            const std::size_t column = std::size_t(i < width ? i : 0);
            blocks.least[at] = std::min(blocks.least[at], least[column]);
            blocks.greatest[at] = std::max(blocks.greatest[at], greatest[column]);
        }
    }
    raiseSteepest(blocks, row, squares);
}

/// A cell of a spline by its Bezier points, [row][column]: in the caps, where it is linear in latitude, those of its
/// two edges.
class BezierCell {
  public:
    using Node = SplineNodes::Node;

    BezierCell(const Node& nw, const Node& ne, const Node& sw, const Node& se, bool cap) : cap_(cap) {
        fillCorner(nw, 0, 1, 1.0f, 0, 1, 1.0f);
        fillCorner(ne, 3, 2, -1.0f, 0, 1, 1.0f);
        fillCorner(sw, 0, 1, 1.0f, rows() - 1, 2, -1.0f);
        fillCorner(se, 3, 2, -1.0f, rows() - 1, 2, -1.0f);
    }

    std::size_t rows() const { return cap_ ? 2 : 4; }
    const std::array<float, 4>& row(std::size_t j) const { return points_[j]; }

    /// The greatest |slope| eastward and southward, per cell: a Bezier curve's is at most three times the greatest
    /// difference.
    glm::vec2 steepest() const {
        glm::vec2 steepest(0.0f);
        const float down = cap_ ? 1.0f : 3.0f;
        for (std::size_t j = 0; j < rows(); ++j)
            for (std::size_t i = 0; i < 4; ++i) {
                if (i > 0) steepest.x = std::max(steepest.x, 3.0f * std::abs(points_[j][i] - points_[j][i - 1]));
                if (j > 0) steepest.y = std::max(steepest.y, down * std::abs(points_[j][i] - points_[j - 1][i]));
            }
        return steepest;
    }

  private:
    /// The points about a corner: `edge` and `column` are its own, the others a step into the cell.
    void fillCorner(const Node& node, std::size_t column, std::size_t inner_column, float east, std::size_t edge,
                    std::size_t inner_edge, float south) {
        const auto [value, east_slope, south_slope, twist] = node;
        points_[edge][column] = value;
        points_[edge][inner_column] = value + east * east_slope / 3.0f;
        if (cap_) return;
        points_[inner_edge][column] = value + south * south_slope / 3.0f;
        points_[inner_edge][inner_column] =
            value + (east * east_slope + south * south_slope) / 3.0f + east * south * twist / 9.0f;
    }

    bool cap_;
    std::array<std::array<float, 4>, 4> points_{};
};

void measureSpline(BlockExtremes& blocks, const NodeGrid& nodes, int row) {
    const SplineNodes spline(nodes);
    const std::size_t width = std::size_t(nodes.width());
    const int first = row << blocks.shift, end = std::min(first + (1 << blocks.shift), nodes.rows());
    std::vector<SplineNodes::Node> north = spline.row(first);
    for (int j = first; j < end; ++j) {
        std::vector<SplineNodes::Node> south = spline.row(j + 1);
        const RowSlopes slopes(nodes, j);
        const bool pole = j == 0 || j + 1 == nodes.rows();
        const bool cap = j < nodes.capRows() || j >= nodes.rows() - nodes.capRows();
        // Towards a pole the slope eastward falls with the distance from it, but is up to three times its share of it.
        const float across = slopes.across * (pole ? 3.0f : 1.0f);
        for (std::size_t i = 0; i < width; ++i) {
            const std::size_t next = i + 1 == width ? 0 : i + 1;
            const BezierCell cell(north[i], north[next], south[i], south[next], cap);
            const std::size_t at = blocks.index(int(i) >> blocks.shift, row);
            for (std::size_t k = 0; k < cell.rows(); ++k)
                for (float point : cell.row(k)) {
                    blocks.least[at] = std::min(blocks.least[at], point);
                    blocks.greatest[at] = std::max(blocks.greatest[at], point);
                }
            const glm::vec2 steepest = cell.steepest();
            blocks.steepest[at] =
                std::max(blocks.steepest[at], std::hypot(across * steepest.x, slopes.down * steepest.y));
        }
        north = std::move(south);
    }
}

void measureRipples(BlockExtremes& blocks, const NodeGrid& nodes, int row) {
    const auto column = [&](int bi) { return nodes.longitude(std::min(bi << blocks.shift, nodes.width())); };
    const auto edge = [&](int bj) { return nodes.colatitude(std::min(bj << blocks.shift, nodes.rows())); };
    for (int bi = 0; bi < blocks.columns; ++bi) {
        const Interval longitude{column(bi), column(bi + 1)}, colatitude{edge(row), edge(row + 1)};
        const Interval range = rippleRange(nodes.map(), longitude, colatitude);
        const std::size_t at = blocks.index(bi, row);
        blocks.least[at] = float(range.low);
        blocks.greatest[at] = float(range.high);
        blocks.steepest[at] = float(steepestRipple(nodes.map(), longitude, colatitude));
    }
}

}  // namespace

BlockExtremes emptyBlocks(const NodeGrid& nodes, int shift) {
    const int block = 1 << shift;
    BlockExtremes blocks;
    blocks.shift = shift;
    blocks.columns = (nodes.width() + block - 1) / block;
    blocks.rows = (nodes.rows() + block - 1) / block;
    blocks.least.assign(std::size_t(blocks.columns) * std::size_t(blocks.rows), kInfinity);
    blocks.greatest.assign(blocks.least.size(), -kInfinity);
    blocks.steepest.assign(blocks.least.size(), 0.0f);
    return blocks;
}

BlockExtremes measureBlocks(const NodeGrid& nodes, Filter filter) {
    BlockExtremes blocks = emptyBlocks(nodes, 3);
    const auto measure =
        nodes.map().ripples ? measureRipples : (filter == Filter::BSpline ? measureSpline : measureBilinear);
    parallelFor(std::size_t(blocks.rows), [&](std::size_t row) { measure(blocks, nodes, int(row)); });
    return blocks;
}

// A cell of the spline depends on the 4x4 nodes at its corners and around: on cells at most one away, which are in this
// block or a neighbour. Value and slopes are means of those of these control points. But slopes eastward are counted in
// the cell's own row, and become steeper than those of a row nearer the equator by what its circle is shorter: three
// times in the second row from a pole, 17/15 in the ninth; and the greatest slopes eastward and southward may be those
// of two cells. Beside a pole the mean of two rows' circles has up to 4/3 of the slope southward.
BlockExtremes splineBlocks(const BlockExtremes& of_nodes, const NodeGrid& nodes) {
    constexpr float kNearPoles = 3.3f, kElsewhere = 1.6f;  // hypot(3, 4/3), hypot(17/15, 1)
    constexpr int kRowsNearPoles = 8;
    BlockExtremes blocks = emptyBlocks(nodes, of_nodes.shift);
    parallelFor(std::size_t(blocks.rows), [&](std::size_t row) {
        const int bj = int(row), first = bj << blocks.shift, end = std::min((bj + 1) << blocks.shift, nodes.rows());
        const bool near_pole = first < kRowsNearPoles || end > nodes.rows() - kRowsNearPoles;
        for (int bi = 0; bi < blocks.columns; ++bi) {
            const std::size_t at = blocks.index(bi, bj);
            for (int j = std::max(bj - 1, 0); j <= std::min(bj + 1, blocks.rows - 1); ++j)
                for (int i : {bi == 0 ? blocks.columns - 1 : bi - 1, bi, bi + 1 == blocks.columns ? 0 : bi + 1}) {
                    const std::size_t from = of_nodes.index(i, j);
                    blocks.least[at] = std::min(blocks.least[at], of_nodes.least[from]);
                    blocks.greatest[at] = std::max(blocks.greatest[at], of_nodes.greatest[from]);
                    blocks.steepest[at] = std::max(blocks.steepest[at], of_nodes.steepest[from]);
                }
            blocks.steepest[at] *= near_pole ? kNearPoles : kElsewhere;
        }
    });
    return blocks;
}

RowSlopes::RowSlopes(const NodeGrid& nodes, int row) {
    const double north_sine = row == 0 ? 1.0 : std::sin(nodes.colatitude(row));
    const double south_sine = row + 1 == nodes.rows() ? 1.0 : std::sin(nodes.colatitude(row + 1));
    across = float(1.0 / (nodes.cellWidth() * std::min(north_sine, south_sine)));
    down = float(1.0 / (nodes.colatitude(row + 1) - nodes.colatitude(row)));
}

void raiseSteepest(BlockExtremes& blocks, int row, const std::vector<float>& squares) {
    const std::size_t block = std::size_t(1) << blocks.shift;
    for (int bi = 0; bi < blocks.columns; ++bi) {
        const std::size_t first = std::size_t(bi) * block, end = std::min(first + block, squares.size());
        float square = 0.0f;
        for (std::size_t i = first; i < end; ++i) square = std::max(square, squares[i]);
        float& steepest = blocks.steepest[blocks.index(bi, row)];
        steepest = std::max(steepest, std::sqrt(square));
    }
}

}  // namespace dsphere
