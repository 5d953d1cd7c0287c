// SplineNodes against the B-spline written down plainly in double: one control point after the other.

#include "surface/spline.h"

#include "tests/surface/grids.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace dsphere::test {
namespace {

/// The centred cubic basis function and its slope.
double basis(double x) {
    x = std::abs(x);
    if (x >= 2.0) return 0.0;
    return x < 1.0 ? 2.0 / 3.0 - x * x + 0.5 * x * x * x : (2.0 - x) * (2.0 - x) * (2.0 - x) / 6.0;
}

double basisSlope(double x) {
    double y = std::abs(x), sign = x < 0.0 ? -1.0 : 1.0;
    if (y >= 2.0) return 0.0;
    return sign * (y < 1.0 ? -2.0 * y + 1.5 * y * y : -0.5 * (2.0 - y) * (2.0 - y));
}

/// A row of control points, mapped; beyond the ends clamped, or mirrored through the pole's value.
double control(const Heightmap& map, int i, int j) {
    int column = (i % map.width + map.width) % map.width, last = map.height - 1;
    if (map.registration == Registration::Texel) return map.at(column, std::clamp(j, 0, last));
    if (j < 0) return 2.0 * map.north_pole - map.at(column, -j);
    if (j > last) return 2.0 * map.south_pole - map.at(column, 2 * last - j);
    return map.at(column, j);
}

/// Sum of the control points about a place in the map's rows and columns, weighed by the two functions.
template <typename WeighU, typename WeighV>
double sum(const Heightmap& map, double column, double row, WeighU weigh_u, WeighV weigh_v) {
    double total = 0.0;
    int i0 = int(std::floor(column)) - 2, j0 = int(std::floor(row)) - 2;
    for (int j = j0; j <= j0 + 5; ++j)
        for (int i = i0; i <= i0 + 5; ++i) {
            double weight = weigh_u(column - i) * weigh_v(row - j);
            if (weight != 0.0) total += weight * control(map, i, j);
        }
    return total;
}

struct SplineCase {
    const char* map;
    int width, height;
    Registration registration;
};

void PrintTo(const SplineCase& c, std::ostream* out) {
    *out << c.map << ' ' << c.width << 'x' << c.height
         << (c.registration == Registration::Texel ? " texel" : " gridline");
}

class SplineTest : public testing::TestWithParam<SplineCase> {
  protected:
    std::unique_ptr<Planet> planet_ = makePlanet(namedMap(GetParam().map, GetParam().width, GetParam().height),
                                                 GetParam().registration, 20.0, 0.0, Filter::BSpline);
    const Heightmap& map_ = planet_->map;
    NodeGrid nodes_{map_};
    SplineNodes spline_{nodes_};

    /// Share of the way from the pole to the first (last) row's circle; 1 elsewhere.
    double shareOf(double row) const {
        if (map_.registration == Registration::Gridline) return 1.0;
        return std::min({1.0, 2.0 * (row + 0.5), 2.0 * (map_.height - 0.5 - row)});
    }
    /// Cells of the grid a map's column and row.
    double perColumn() const { return double(map_.width) / nodes_.width(); }
    double perRow() const { return nodes_.mapRow(nodes_.capRows() + 1) - nodes_.mapRow(nodes_.capRows()); }
};

TEST_P(SplineTest, NodesAreTheBSplines) {
    // A node is four floats: half an ulp of 65535 each.
    const double rounding = 65535.0 * 0x1p-24;
    for (int j = 0; j <= nodes_.rows(); j += j < 4 || j > nodes_.rows() - 5 ? 1 : 17) {
        const std::vector<SplineNodes::Node> row = spline_.row(j);
        ASSERT_EQ(int(row.size()), nodes_.width());
        double map_row = nodes_.mapRow(j), share = shareOf(map_row);
        double on_map = std::clamp(map_row, 0.0, map_.height - 1.0);
        double pole = map_row < 0.5 * map_.height ? map_.north_pole : map_.south_pole;
        for (int i = 0; i < nodes_.width(); i += 5) {
            double column = nodes_.mapColumn(i);
            const auto [value, east, south, twist] = row[std::size_t(i)];
            double truth = sum(map_, column, on_map, basis, basis);
            ASSERT_NEAR(value, pole + share * (truth - pole), rounding) << i << ", " << j;
            ASSERT_NEAR(east, share * perColumn() * sum(map_, column, on_map, basisSlope, basis), rounding);
            bool cap = share < 1.0;
            ASSERT_NEAR(south, cap ? 0.0 : perRow() * sum(map_, column, on_map, basis, basisSlope), rounding);
            double cross = perColumn() * perRow() * sum(map_, column, on_map, basisSlope, basisSlope);
            ASSERT_NEAR(twist, cap ? 0.0 : cross, rounding);
        }
    }
}

// A spline stays within its control points, so bounds above these would be worse than none; and it lies below the
// extremes of the corners of each cell.
TEST_P(SplineTest, ExtremesHoldTheSplineWithinItsControlPoints) {
    const double rounding = 65535.0 * 0x1p-22;
    const std::vector<float> most = spline_.extremes(true), least = spline_.extremes(false);
    auto corner = [&](const std::vector<float>& extremes, int i, int j) {
        return extremes[std::size_t(j) * std::size_t(nodes_.width()) + std::size_t(i % nodes_.width())];
    };
    for (int j = 0; j < nodes_.rows(); j += j < 3 || j > nodes_.rows() - 4 ? 1 : 13)
        for (int i = 0; i < nodes_.width(); i += 7) {
            double low = std::min(
                {corner(least, i, j), corner(least, i + 1, j), corner(least, i, j + 1), corner(least, i + 1, j + 1)});
            double high = std::max(
                {corner(most, i, j), corner(most, i + 1, j), corner(most, i, j + 1), corner(most, i + 1, j + 1)});
            for (int k = 0; k < 25; ++k) {
                double column = nodes_.mapColumn(i) + k % 5 * 0.25 * perColumn();
                double row = nodes_.mapRow(j) + k / 5 * 0.25 * (nodes_.mapRow(j + 1) - nodes_.mapRow(j));
                double pole = row < 0.5 * map_.height ? map_.north_pole : map_.south_pole, share = shareOf(row);
                double on_map = std::clamp(row, 0.0, map_.height - 1.0);
                double value = pole + share * (sum(map_, column, on_map, basis, basis) - pole);
                ASSERT_LE(value, high + rounding) << i << ", " << j;
                ASSERT_GE(value, low - rounding) << i << ", " << j;
            }
            ASSERT_LE(high, double(map_.greatest) + rounding);
            ASSERT_GE(low, double(map_.least) - rounding);
        }
}

using enum Registration;
INSTANTIATE_TEST_SUITE_P(Maps, SplineTest,
                         testing::Values(SplineCase{"random", 1, 1, Texel}, SplineCase{"random", 3, 2, Texel},
                                         SplineCase{"random", 7, 2, Gridline}, SplineCase{"random", 5, 3, Gridline},
                                         SplineCase{"spikes", 65, 33, Gridline}, SplineCase{"spikes", 64, 32, Texel},
                                         SplineCase{"checkerboard", 512, 256, Texel},
                                         SplineCase{"random", 513, 257, Gridline},
                                         SplineCase{"random", 600, 40, Texel}));

}  // namespace
}  // namespace dsphere::test
