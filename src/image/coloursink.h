#pragma once

#include "image/rawcolour.h"

#include <cstddef>

namespace dsphere {

/// What the stored numbers of a colour image mean.
struct ColourCode {
    double full_scale = 255.0;  ///< the stored value that is white
    bool srgb = true;           ///< else linear light as stored
};

/// Where a reader puts the stored values of a colour image, in any order.
class ColourSink {
  public:
    /// Makes room for the whole image: the size must have been checked.
    ColourSink(int width, int height, ColourCode code, std::string type);

    /// Stores `count` texels from index `first` on; `values` holds `channels` numbers a texel, 1 (grey) or 3.
    void put(std::size_t first, std::size_t count, const float* values, int channels);
    RawColour take() { return std::move(image_); }

  private:
    RawColour image_;
    ColourCode code_;
};

}  // namespace dsphere
