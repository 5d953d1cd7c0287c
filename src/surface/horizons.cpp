#include "surface/horizons.h"

#include "base/parallel.h"
#include "surface/cubecells.h"
#include "surface/cubeneighbours.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace dsphere {

namespace {

// How far a start may lie below the ground, in units of R: it is a hit, rounded.
constexpr double kBelowGround = 2e-6;
// Beyond what rounding makes of a tangent, here and on the device.
constexpr double kTangentSlack = 1e-4;
// A start may lie beside its cell by what cells are dilated by.
constexpr double kBeside = 2.0 * Bounds::kDilation;

/// The greatest radius, in units of R, and slope, |grad r| / r, in each cell of a cube map, or about each.
struct Extremes {
    CubeGrid radius, slope;
};

/// The cells at most `rings` cells of a level away, along either edge of a face.
struct Neighbourhood {
    int level, rings;
    Extremes about;
};

class Builder {
  public:
    Builder(Bounds& bounds, const NodeGrid& nodes, const Relief& relief, const BlockExtremes& blocks)
        : bounds_(bounds), least_(bounds.horizonSide()) {
        std::vector<Extremes> levels{measureCells(nodes, relief, blocks)};
        while (levels.back().radius.side() > 4)
            levels.push_back({levels.back().radius.halved(), levels.back().slope.halved()});
        for (int level = 0; level < int(levels.size()); ++level)
            for (int rings = level == 0 ? 1 : 2; rings <= 3; ++rings) neighbourhoods_.push_back({level, rings, {}});
        parallelFor(neighbourhoods_.size(), [&](std::size_t n) {
            Neighbourhood& of = neighbourhoods_[n];
            const Extremes& cells = levels[std::size_t(of.level)];
            of.about = {cells.radius.dilated(of.rings), cells.slope.dilated(of.rings)};
        });
        greatest_ = levels.back().radius.greatest();
        steepest_ = levels.back().slope.greatest();
    }

    void fill() {
        const int side = least_.side();
        parallelFor(std::size_t(6) * std::size_t(side), [&](std::size_t row) {
            const int face = int(row) / side, j = int(row) % side;
            for (int i = 0; i < side; ++i) {
                const double least = double(least_.at(face, i, j)) - kBelowGround;
                const double tangent = (1.0 + 1e-5) * tangentOf(face, i, j, least) + kTangentSlack;
                bounds_.squared[bounds_.horizonIndex(face, i, j)] = float(tangent * tangent);
                bounds_.squared[bounds_.horizonLeastIndex(face, i, j)] = float(least * least);
            }
        });
    }

  private:
    /// Of the horizons' own cells; fills their least radii as well.
    Extremes measureCells(const NodeGrid& nodes, const Relief& relief, const BlockExtremes& blocks) {
        const int side = least_.side();
        Extremes extremes{CubeGrid(side), CubeGrid(side)};
        const CubeCells cells(side);
        const double unit = 1.0 / relief.greatest_radius;
        const auto measure = [&](int face, int i, int j, const Footprint& footprint) {
            double least = std::numeric_limits<double>::infinity(), slope = 0.0;
            visitBlocks(blocks, nodes, nodesUnder(nodes, footprint), [&](std::size_t at) {
                const float lowest = relief.scale < 0.0 ? blocks.greatest[at] : blocks.least[at];
                least = std::min(least, unit * (relief.base + relief.scale * double(lowest)));
                slope = std::max(slope, double(blocks.steepest[at]));
            });
            slope *= unit * std::abs(relief.scale) / least;
            least_.at(face, i, j) = std::nextafter(float(least), 0.0f);
            extremes.slope.at(face, i, j) = std::nextafter(float(slope), std::numeric_limits<float>::infinity());
            extremes.radius.at(face, i, j) = std::sqrt(bounds_.at(face, 2, i, j));
        };
        parallelFor(std::size_t(side), [&](std::size_t n) { cells.visitLine(int(n), measure); });
        return extremes;
    }

    double tangentOf(int face, int i, int j, double least) const {
        const double width = 2.0 / least_.side();
        const auto farthest = [&](int k) {
            return std::max(std::abs(k * width - 1.0), std::abs((k + 1) * width - 1.0));
        };
        const double across = std::hypot(farthest(i), farthest(j)) + kBeside;
        // From the largest neighbourhood inwards: `beyond` is what the ground outside of it needs.
        double beyond = 0.0, enough = steepest_;
        double greatest = greatest_;
        for (auto of = neighbourhoods_.rbegin(); of != neighbourhoods_.rend(); ++of) {
            const int ci = i >> of->level, cj = j >> of->level;
            const double cell = width * double(1 << of->level), away = of->rings * cell - kBeside;
            // Of the face's plane, a length `away` is seen under the least angle where it points away from the middle.
            const double x = away / (1.0 + across * across + away * across);  // its tangent
            const double ground = (1.0 - least / greatest * std::sqrt(1.0 + x * x)) / x;
            beyond = std::max(beyond, ground);
            enough = std::min(enough, std::max(beyond, double(of->about.slope.at(face, ci, cj))));
            greatest = of->about.radius.at(face, ci, cj);
        }
        return enough;
    }

    Bounds& bounds_;
    CubeGrid least_;                             ///< radius, units of R
    std::vector<Neighbourhood> neighbourhoods_;  ///< from the smallest
    double greatest_ = 0.0, steepest_ = 0.0;     ///< of all
};

}  // namespace

void fillHorizons(Bounds& bounds, const NodeGrid& nodes, const Relief& relief, const BlockExtremes& blocks) {
    Builder(bounds, nodes, relief, blocks).fill();
}

}  // namespace dsphere
