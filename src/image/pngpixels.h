#pragma once

#include "image/inputfile.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace dsphere {

/// A PNG's pixels as colours: palettes and transparent colours are resolved.
struct PngPixels {
    struct Free {
        void operator()(std::uint8_t* pixels) const;
    };
    int width = 0, height = 0;
    int channels = 0;                           ///< 1: grey, 2: grey and alpha, 3: RGB, 4: RGBA
    std::unique_ptr<std::uint8_t, Free> bytes;  ///< of samples of up to 8 bits; empty for those of 16
    std::vector<std::uint16_t> words;           ///< of samples of 16 bits

    bool isWide() const { return !bytes; }
    double fullScale() const { return isWide() ? 65535.0 : 255.0; }
    /// Channels without alpha: 1 or 3.
    std::size_t colours() const { return channels < 3 ? 1 : 3; }
    bool hasAlpha() const { return channels % 2 == 0; }
    /// What is stored of a pixel, row by row from the top; at most fullScale().
    int code(std::size_t pixel, std::size_t channel) const {
        const std::size_t place = pixel * std::size_t(channels) + channel;
        return isWide() ? words[place] : bytes.get()[place];
    }
};

/// Reads a PNG of any kind. Throws Error (InvalidInput) with the reason when it cannot, as readRawMap does.
PngPixels readPngPixels(InputFile& file);

}  // namespace dsphere
