#include "surface/slope.h"

#include "base/parallel.h"

#include <algorithm>
#include <cmath>

namespace dsphere {

namespace {

struct RowBound {
    double slope = 0.0;  ///< of stored values per radian of arc on the unit sphere
    float least = 0.0f, greatest = 0.0f;
};

// In a row of cells the slope in longitude is at most its greatest difference over the shorter of its two circles. In a
// row that touches a pole it is (D theta' / height) / sin theta', theta' the angle from the pole and D the difference
// on the row's circle: greatest on that circle too, because theta' / sin theta' grows.
RowBound boundRow(const NodeGrid& nodes, int j) {
    const float *north = nodes.row(j), *south = nodes.row(j + 1);
    double north_sine = j == 0 ? 1.0 : std::sin(nodes.colatitude(j));
    double south_sine = j + 1 == nodes.rows() ? 1.0 : std::sin(nodes.colatitude(j + 1));
    double across = 1.0 / (nodes.cellWidth() * std::min(north_sine, south_sine));
    double down = 1.0 / (nodes.colatitude(j + 1) - nodes.colatitude(j));
    RowBound bound{0.0, north[0], north[0]};
    double steepest = 0.0;
    for (int i = 0; i < nodes.width(); ++i) {
        int next = i + 1 == nodes.width() ? 0 : i + 1;
        double east =
            across * std::max(std::abs(double(north[next]) - north[i]), std::abs(double(south[next]) - south[i]));
        double along =
            down * std::max(std::abs(double(south[i]) - north[i]), std::abs(double(south[next]) - north[next]));
        steepest = std::max(steepest, east * east + along * along);
        bound.least = std::min({bound.least, north[i], south[i]});
        bound.greatest = std::max({bound.greatest, north[i], south[i]});
    }
    bound.slope = std::sqrt(steepest);
    return bound;
}

}  // namespace

// grad f = e_r - grad_S r / |p| with grad_S r across the radius, and |p| is at least the least radius.
double gradientBound(const NodeGrid& nodes, double base, double scale) {
    std::vector<RowBound> rows(std::size_t(nodes.rows()));
    parallelFor(rows.size(), [&](std::size_t j) { rows[j] = boundRow(nodes, int(j)); });
    RowBound all = rows[0];
    for (const RowBound& row : rows) {
        all.slope = std::max(all.slope, row.slope);
        all.least = std::min(all.least, row.least);
        all.greatest = std::max(all.greatest, row.greatest);
    }
    double least_radius = std::min(base + scale * all.least, base + scale * all.greatest);
    constexpr double kRounding = 1.0 + 1e-6;
    return kRounding * std::hypot(1.0, scale * all.slope / least_radius);
}

}  // namespace dsphere
