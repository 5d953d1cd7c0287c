#include "render/tiles.h"

#include <algorithm>
#include <chrono>

namespace dsphere {

namespace {

// Tiles follow the objects' silhouettes; a dispatch costs 14 us on lavapipe. Multiples of the group size.
constexpr int kTileRows = 16, kTileColumns = 2048;

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
    std::vector<layout::RenderParams> round;
    double most = tracer.pixelSeconds() > 0.0 ? target / tracer.pixelSeconds() : 1.0;
    if (last_seconds_ > 0.0) {
        const double share = target / last_seconds_;
        most = double(last_pixels_) * std::min(share, std::clamp(share / 4.0, 2.0, 16.0));
    }
    std::uint64_t pixels = 0;
    while (!done()) {
        Box box = tiles_[next_];
        box.x0 += columns_done_;
        std::uint64_t more = std::uint64_t(box.width()) * std::uint64_t(box.height());
        if (!round.empty() && (double(pixels) + 0.5 * double(more) > most || pixels + more > FilmTracer::kMostPixels))
            break;
        if (tracer.pixelSeconds() > 0.0 && double(more) > 2.0 * most) {
            const int fitting = int(most / double(box.height())) / tracer.columns() * tracer.columns();
            box.x1 = std::min(box.x1, box.x0 + std::max(fitting, tracer.columns()));
            more = std::uint64_t(box.width()) * std::uint64_t(box.height());
        }
        round.push_back({box.x0, box.y0, box.x1, box.y1, film_x_, film_y_, sample, seed});
        pixels += more;
        const bool whole = box.x1 == tiles_[next_].x1;
        columns_done_ = whole ? 0 : box.x1 - tiles_[next_].x0;
        if (whole) ++next_;
    }
    // Rounds are sized by the host's clock, which counts the heights that are read from files meanwhile.
    const auto started = std::chrono::steady_clock::now();
    const double device_seconds = tracer.run(round);
    last_seconds_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
    last_pixels_ = pixels;
    pixels_ += last_pixels_;
    seconds_ += device_seconds;
    if (done() && pixels_ > 0) tracer.pixelSeconds() = seconds_ / double(pixels_);
    return device_seconds;
}

}  // namespace dsphere
