#include "render/tiles.h"

#include <algorithm>

namespace dsphere {

namespace {

// Tiles follow the objects' silhouettes; a dispatch costs 14 us on lavapipe. Multiples of the group size.
constexpr int kTileRows = 16, kTileColumns = 2048;

}  // namespace

std::vector<Box> makeTiles(const std::vector<Span>& spans, int x0, int x1) {
    std::vector<Box> tiles;
    int height = int(spans.size());
    for (int y = 0; y < height; y += kTileRows) {
        int y1 = std::min(y + kTileRows, height);
        Span all;
        for (int row = y; row < y1; ++row) {
            Span span = spans[std::size_t(row)];
            span = {std::max(span.x0, x0), std::min(span.x1, x1)};
            if (span.empty()) continue;
            all = all.empty() ? span : Span{std::min(all.x0, span.x0), std::max(all.x1, span.x1)};
        }
        for (int x = all.x0; x < all.x1; x += kTileColumns)
            tiles.push_back({x, y, std::min(x + kTileColumns, all.x1), y1});
    }
    return tiles;
}

// Rounds of tiles: as many a round as fit the time target and the pass.
double TileRun::step(Pass& pass, int sample, std::uint32_t seed, double target) {
    std::vector<layout::RenderParams> round;
    std::uint64_t pixels = 0;
    while (!done() && round.size() < at_once_ && pixels + kTileRows * kTileColumns <= Pass::kMostPixels) {
        const Box& box = tiles_[next_++];
        round.push_back({box.x0, box.y0, box.x1, box.y1, film_x_, film_y_, sample, seed});
        pixels += std::uint64_t(box.width()) * std::uint64_t(box.height());
    }
    double seconds = pass.run(round);
    if (seconds < 0.5 * target) at_once_ = std::min(2 * at_once_, tiles_.size());
    if (seconds > 2.0 * target) at_once_ = std::max<std::size_t>(1, at_once_ / 2);
    return seconds;
}

}  // namespace dsphere
