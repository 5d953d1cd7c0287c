#pragma once

// What one pass over a map that stays in its file tells of it: all that must be known of every texel.

#include "surface/blocks.h"
#include "surface/gaps.h"
#include "surface/nodes.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace dsphere {

/// Least and greatest stored value below each of the finest cells of the bounds' cube map (see Bounds, CubeCells).
struct CellExtremes {
    int side = 0;
    std::vector<float> least, greatest;

    std::size_t index(int face, int i, int j) const {
        return (std::size_t(face) * std::size_t(side) + std::size_t(j)) * std::size_t(side) + std::size_t(i);
    }
};

struct Survey {
    float north_pole = 0.0f, south_pole = 0.0f;
    float least = 0.0f, greatest = 0.0f;
    float second_least = 0.0f;   ///< the least value above `least`; infinite: there is none
    std::uint64_t at_least = 0;  ///< texels that hold `least`
    CellExtremes cells;
    BlockExtremes blocks;
    /// The map at 1 / reduction of its columns and rows, as a level of detail; empty: its counts cannot be divided.
    /// Texel registration: means; gridline: every so manieth node. As stored values, each within those that it stands
    /// for.
    int reduction = 0;
    std::vector<float> reduced;
    /// How far the reduced map's bilinear surface is from the whole one's, at most, in stored units.
    double reduced_error = 0.0;
};

/// Reads the map once, in bands of rows, on all cores. `grid` is that of `map`, and not subdivided.
Survey surveyMap(const geo::LargeMap& source, const Gaps& gaps, const NodeGrid& grid,
                 const SurveyProgress& progress = {});

}  // namespace dsphere
