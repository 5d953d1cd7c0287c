#pragma once

#include "render/pass.h"
#include "render/spans.h"

#include <vector>

namespace dsphere {

/// Boxes that hold all spans (one a row) within the columns [x0, x1); none holds more pixels than Pass::run() takes.
std::vector<Box> makeTiles(const std::vector<Span>& spans, int x0, int x1);

/// The tiles of one sample of a picture, handed to the device in rounds of bounded time.
class TileRun {
  public:
    /// The tiles are in film pixels; the film's first pixel is raster position (film_x, film_y). `pixel_seconds`: of a
    /// run like this one, 0 if none is known: then the first rounds are short.
    TileRun(std::vector<Box> tiles, int film_x, int film_y, double pixel_seconds = 0.0)
        : tiles_(std::move(tiles)), film_x_(film_x), film_y_(film_y), pixel_seconds_(pixel_seconds) {}

    const std::vector<Box>& tiles() const { return tiles_; }
    bool done() const { return next_ >= tiles_.size(); }
    double share() const { return tiles_.empty() ? 1.0 : double(next_) / double(tiles_.size()); }
    /// Back to the first tile, for the next sample.
    void rewind() { next_ = 0; }
    /// What a pixel of the last round took; 0 before the first.
    double pixelSeconds() const { return pixel_seconds_; }

    /// Submits the next tiles, as many as take about `target` seconds, and waits; returns the device's seconds.
    double step(Pass& pass, int sample, std::uint32_t seed, double target);

  private:
    std::vector<Box> tiles_;
    int film_x_ = 0, film_y_ = 0;
    std::size_t next_ = 0;
    double pixel_seconds_;
    std::uint64_t last_pixels_ = 0;  ///< of the last round
};

}  // namespace dsphere
