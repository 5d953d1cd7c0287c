#include "render/tiles.h"

#include <algorithm>
#include <chrono>
#include <limits>

namespace dsphere {

namespace {

// Tiles follow the objects' silhouettes. Multiples of the group size.
constexpr int kTileRows = 16, kTileColumns = 2048;

// A dispatch takes lavapipe's two threads some 25 us to begin and to end, which is what so many pixels that miss take.
constexpr double kDispatchPixels = 2200.0;

std::uint64_t areaOf(const Box& box) {
    return std::uint64_t(box.width()) * std::uint64_t(box.height());
}

Box around(const Box& a, const Box& b) {
    return {std::min(a.x0, b.x0), std::min(a.y0, b.y0), std::max(a.x1, b.x1), std::max(a.y1, b.y1)};
}

}  // namespace

std::vector<Box> makeTiles(const std::vector<Span>& spans, int x0, int x1, int columns) {
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
        if (all.empty()) continue;
        for (int x = std::max(x0, all.x0 / columns * columns); x < all.x1; x += kTileColumns)
            tiles.push_back({x, y, std::min(x + kTileColumns, all.x1), y1});
    }
    return tiles;
}

// The cheapest way to cut the list into runs, from the first tile on: to end with one, it must begin where the rest was
// cheapest.
std::vector<Box> joinTiles(const std::vector<Box>& tiles) {
    struct Cut {
        double cost;
        std::size_t begin;
        Box box;  // of the run from `begin` to here
    };
    std::vector<Cut> cuts = {{0.0, 0, {}}};
    for (std::size_t end = 1; end <= tiles.size(); ++end) {
        Box box = tiles[end - 1];
        Cut best = {std::numeric_limits<double>::infinity(), 0, {}};
        for (std::size_t begin = end; begin-- > 0;) {
            if (begin + 1 < end && tiles[begin].y1 != tiles[begin + 1].y0) break;
            box = around(box, tiles[begin]);
            const double cost = cuts[begin].cost + double(areaOf(box)) + kDispatchPixels;
            if (cost < best.cost) best = {cost, begin, box};
        }
        cuts.push_back(best);
    }
    std::vector<Box> joined;
    for (std::size_t end = tiles.size(); end > 0; end = cuts[end].begin) joined.push_back(cuts[end].box);
    std::reverse(joined.begin(), joined.end());
    return joined;
}

// Whether no other tile has the same rows.
bool TileRun::isAlone(std::size_t tile) const {
    const int y0 = tiles_[tile].y0;
    return !(tile > 0 && tiles_[tile - 1].y0 == y0) && !(tile + 1 < tiles_.size() && tiles_[tile + 1].y0 == y0);
}

RowByRow TileRun::doneRows() const {
    if (tiles_.empty()) return {};
    const Box& next = tiles_[std::min(next_, tiles_.size() - 1)];
    const int x = done() ? next.x1 : next.x0 + columns_done_;
    return {0, 0, next.y0, next.y1, x};
}

// As many tiles a round as fit the time target, at the rate of the last round, and one run of the tracer takes. The
// last tiles may have been cheap: so at most twice as many as last time, unless that took much less than the target.
// Where one tile is too much, a part of it, by whole workgroups: pixels keep their places in those.
double TileRun::step(FilmTracer& tracer, int sample, std::uint32_t seed, double target) {
    std::vector<Box> round, whole;
    const auto joinWhole = [&] {
        const std::vector<Box> joined = joinTiles(whole);
        round.insert(round.end(), joined.begin(), joined.end());
        whole.clear();
    };
    double most = tracer.pixelSeconds() > 0.0 ? target / tracer.pixelSeconds() : 1.0;
    if (last_seconds_ > 0.0) {
        const double share = target / last_seconds_;
        most = double(last_pixels_) * std::min(share, std::clamp(share / 4.0, 2.0, 16.0));
    }
    std::uint64_t pixels = 0;
    const std::size_t first = next_;
    while (!done()) {
        const Box& tile = tiles_[next_];
        Box box = tile;
        box.x0 += columns_done_;
        std::uint64_t more = areaOf(box);
        // What joining adds is less than a dispatch costs, for each tile.
        const double area = double(pixels + more) + kDispatchPixels * double(next_ - first + 1);
        if (pixels > 0 && (double(pixels) + 0.5 * double(more) > most || area > double(FilmTracer::kMostPixels))) break;
        if (tracer.pixelSeconds() > 0.0 && double(more) > 2.0 * most) {
            const int fitting = int(most / double(box.height())) / tracer.columns() * tracer.columns();
            box.x1 = std::min(box.x1, box.x0 + std::max(fitting, tracer.columns()));
            more = areaOf(box);
        }
        pixels += more;
        // What is joined must leave out no part of a row that another round has.
        if (box == tile && isAlone(next_)) {
            whole.push_back(box);
        } else {
            joinWhole();
            round.push_back(box);
        }
        const bool ends = box.x1 == tile.x1;
        columns_done_ = ends ? 0 : box.x1 - tile.x0;
        if (ends) ++next_;
    }
    joinWhole();
    std::vector<layout::RenderParams> params;
    for (const Box& box : round) params.push_back({box.x0, box.y0, box.x1, box.y1, film_x_, film_y_, sample, seed});
    // Rounds are sized by the host's clock, which counts the heights that are read from files meanwhile.
    const auto started = std::chrono::steady_clock::now();
    const double device_seconds = tracer.run(params);
    last_seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    last_pixels_ = pixels;
    pixels_ += last_pixels_;
    seconds_ += device_seconds;
    if (done() && pixels_ > 0) tracer.pixelSeconds() = seconds_ / double(pixels_);
    return device_seconds;
}

}  // namespace dsphere
