#pragma once

// Maps from formulas and a seed: 16-bit heights, the same on every machine with IEEE doubles.

#include <cstdint>
#include <memory>
#include <span>

namespace dsphere {

class Moon;

enum class MapKind {
    Moon,          ///< craters on fractal ground, some plains: see image/moon.h
    Fractal,       ///< ten octaves of value noise on the sphere itself: no seam, no pole, natural slopes
    Terraces,      ///< the fractal in 24 steps: plateaus and cliffs, as an 8-bit map makes them
    Spikes,        ///< low noise with one texel in 97 at a random greater height, up to full scale: needles
    Checkerboard,  ///< texels alternate between 0 and full scale; an odd width has a seam
    Random,        ///< independent texels
};

/// Makes a map row by row. Every row can be made alone, in any order and by several threads at once.
class MapGenerator {
  public:
    /// `width` and `height` are at least 1. The moon lists its craters here: 91,000 for 4096 columns, 9 MB; at most
    /// 1.5 million.
    MapGenerator(MapKind kind, int width, int height, std::uint32_t seed);
    ~MapGenerator();
    MapGenerator(MapGenerator&&) noexcept;

    int width() const { return width_; }
    int height() const { return height_; }

    /// Fills row `j` in [0, height), 0 northmost, with heights of 0 to 65535; `row` has `width` entries. Texel
    /// registration, -180 degrees at the left edge.
    void fillRow(int j, std::span<std::uint16_t> row) const;

  private:
    MapKind kind_;
    int width_, height_;
    std::uint32_t seed_;
    std::unique_ptr<const Moon> moon_;
};

}  // namespace dsphere
