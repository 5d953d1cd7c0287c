#pragma once

#include <memory>
#include <optional>

#include "geo/largemap.h"

namespace dsphere {

/// Maps that are wider do not fit an image of every device: they are cut into tiles, as maps in their files are.
inline constexpr int kWidestHeldMap = 16384;

/// A prepared map (prepareMap) in memory as one that is read in windows. Its samples are kept in 16 bits where all are
/// whole numbers of that range.
std::shared_ptr<const geo::LargeMap> holdMap(RawMap map);

/// Same as holdMap(map) for samples that `kind` holds exactly. `unknown`: see LargeMap::unknownCode().
std::shared_ptr<const geo::LargeMap> holdMap(RawMap map, geo::SampleKind kind, std::optional<int> unknown = {});

}  // namespace dsphere
