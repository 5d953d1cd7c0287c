#pragma once

#include "base/image.h"

namespace dsphere {

/// The edges of tiles lie at multiples of these from the picture's corner, where tiles are not small: workgroups then
/// hold the same pixels as in the whole picture, and so does what one invocation does in turn (see NEXT_PIXEL_STEPS).
inline constexpr int kTileColumnStep = 64, kTileRowStep = 16;

/// The piece number `tile`, 1 to `tiles`, of a picture that is cut into pieces of nearly equal areas; `tiles` is not
/// more than the picture has pixels.
Box tileBox(const Box& picture, int tile, int tiles);

/// Whether a piece's corner lies where kTileColumnStep and kTileRowStep have it.
bool isAligned(const Box& tile, const Box& picture);

}  // namespace dsphere
