#pragma once

#include "base/hash.h"
#include "surface/scenemaps.h"

#include <cstdint>

namespace dsphere {

/// Of all that decides the light in a picture of the scene: not its names and places, nor the number and the seed of
/// its samples; of maps and images what they hold, not where they lie.
std::uint64_t fingerprint(const Scene& scene, const SceneMaps& maps);

}  // namespace dsphere
