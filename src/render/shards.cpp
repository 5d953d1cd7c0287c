#include "render/shards.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>

namespace dsphere {

namespace {

/// How many of `size` columns (or rows) go to the first `share` of `tiles`: at least one, and not all.
int cutAt(int size, int share, int tiles, int step) {
    const double ideal = double(size) * share / tiles;
    int cut = int(std::lround(ideal));
    if (ideal >= 2 * step && size - ideal >= 2 * step) cut = int(std::lround(ideal / step)) * step;
    return std::clamp(cut, 1, size - 1);
}

}  // namespace

Box tileBox(const Box& picture, int tile, int tiles) {
    assert(tile >= 1 && tile <= tiles && tiles <= std::int64_t(picture.width()) * picture.height());
    Box box = picture;
    for (int before = tile - 1; tiles > 1;) {
        const bool wide = box.width() >= box.height();
        const int size = wide ? box.width() : box.height(), across = wide ? box.height() : box.width();
        const int cut = cutAt(size, tiles / 2, tiles, wide ? kTileColumnStep : kTileRowStep);
        // Nearly as many tiles as pixels: each side gets no more than it has pixels.
        const std::int64_t most = std::int64_t(cut) * across, rest = std::int64_t(size - cut) * across;
        const int share = int(std::clamp<std::int64_t>(tiles / 2, tiles - rest, most));
        const bool first = before < share;
        if (wide)
            (first ? box.x1 : box.x0) = box.x0 + cut;
        else
            (first ? box.y1 : box.y0) = box.y0 + cut;
        if (!first) before -= share;
        tiles = first ? share : tiles - share;
    }
    return box;
}

bool isAligned(const Box& tile, const Box& picture) {
    return (tile.x0 - picture.x0) % kTileColumnStep == 0 && (tile.y0 - picture.y0) % kTileRowStep == 0;
}

}  // namespace dsphere
