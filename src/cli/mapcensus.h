#pragma once

// What the samples of a heightmap are, counted row by row.

#include <cstdint>
#include <functional>
#include <optional>
#include <span>

#include "geo/largemap.h"
#include "image/rawmap.h"

namespace dsphere::cli {

/// A texel by its place in the file.
struct CountedTexel {
    float value = 0.0f;  ///< as stored
    int column = 0, row = 0;
};

/// Samples that are no height (see isHeight) are unknown.
struct MapCensus {
    std::uint64_t known = 0, unknown = 0;
    std::uint64_t not_finite = 0;  ///< of the unknown ones
    double sum = 0.0;              ///< of the known ones
    std::optional<CountedTexel> least,
        greatest;  ///< the first of several in the order of the file; unset: none is known
};

/// Counts all cores' share of the rows at once; the result does not depend on how many there are.
MapCensus censusOf(const RawMap& map);
/// Reads the map in bands of rows. Throws Error: (InvalidInput) where it cannot be read, (Interrupted) when `progress`,
/// which is given the share that is done, returns false.
MapCensus censusOf(const geo::LargeMap& map, const std::function<bool(double)>& progress);

}  // namespace dsphere::cli
