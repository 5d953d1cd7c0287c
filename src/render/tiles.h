#pragma once

#include "render/filmtracer.h"
#include "render/spans.h"

#include <vector>

namespace dsphere {

/// Boxes that hold all spans (one a row) within the columns [x0, x1); none holds more pixels than FilmTracer::run()
/// takes. They begin at x0 or at multiples of `columns`, which are those of a workgroup: so the pixels that share one
/// do not depend on where within a crop's first workgroup an object begins.
std::vector<Box> makeTiles(const std::vector<Span>& spans, int x0, int x1, int columns);

/// The same boxes, from the top down and none beside another, of which runs that touch are joined to the box around
/// them where its further pixels, which miss, cost less than another dispatch does.
std::vector<Box> joinTiles(const std::vector<Box>& tiles);

/// The pixels left of x0, and those within [x0, x1) that come before (x, y0), where [y0, y1) are rows of tiles, done
/// from the left.
struct RowByRow {
    int x0 = 0, x1 = 0, y0 = 0, y1 = 0, x = 0;
};

/// The tiles of one sample of a picture, handed to the device in rounds of bounded time.
class TileRun {
  public:
    /// The tiles are in film pixels; the film's first pixel is raster position (film_x, film_y).
    TileRun(std::vector<Box> tiles, int film_x, int film_y)
        : tiles_(std::move(tiles)), film_x_(film_x), film_y_(film_y) {}

    const std::vector<Box>& tiles() const { return tiles_; }
    bool begun() const { return next_ > 0 || columns_done_ > 0; }
    bool done() const { return next_ >= tiles_.size(); }
    /// Of what is done, all but the columns that the tiles are of.
    RowByRow doneRows() const;
    double share() const { return tiles_.empty() ? 1.0 : double(next_) / double(tiles_.size()); }
    /// Back to the first tile, for the next sample.
    void rewind() { *this = TileRun(std::move(tiles_), film_x_, film_y_); }

    /// Submits the next tiles, or a part of one, as much as takes about `target` seconds by FilmTracer::pixelSeconds(),
    /// and waits; returns the device's seconds. While those are unknown, one tile.
    double step(FilmTracer& tracer, int sample, std::uint32_t seed, double target);

  private:
    bool isAlone(std::size_t tile) const;

    std::vector<Box> tiles_;
    int film_x_ = 0, film_y_ = 0;
    std::size_t next_ = 0;
    int columns_done_ = 0;                        ///< of the next tile
    std::uint64_t last_pixels_ = 0, pixels_ = 0;  ///< of the last round, and of all since rewind()
    double last_seconds_ = 0.0, seconds_ = 0.0;
};

}  // namespace dsphere
