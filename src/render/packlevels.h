#pragma once

#include "render/pack.h"

namespace dsphere {

/// Adds the levels of detail of a relief to the scene, coarser and coarser, as long as its map can be halved and up to
/// MAX_LEVELS. None of a surface that is not bilinear. `relief` is what it was packed from.
void packLevels(PackedScene& packed, int finest, const Relief& relief);

}  // namespace dsphere
