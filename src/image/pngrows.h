#pragma once

#include "image/inputfile.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace dsphere {

/// A PNG file read by libpng, one row at a time (interlaced ones as a whole).
class PngRows {
  public:
    enum class Colour { Grey, Rgb, Palette, GreyAlpha, Rgba };
    struct Entry {
        std::uint8_t red, green, blue, alpha;
    };
    using Use = std::function<void(int j, std::span<const std::uint16_t> samples)>;

    /// Reads up to the first row. Throws Error (InvalidInput) when the file is damaged, or when its data cannot hold
    /// the texels that its header promises.
    explicit PngRows(InputFile& file);
    ~PngRows();

    int width() const;
    int height() const;
    int depth() const;  ///< bits of a sample, 1 to 16
    Colour colour() const;
    int channels() const;                                   ///< samples of a texel; a palette's index is one
    const std::vector<Entry>& palette() const;              ///< empty unless the colour is Palette
    const std::vector<std::uint16_t>& transparent() const;  ///< the one colour that is transparent, or empty

    /// Calls `use` with the samples of every row from the top, as stored, below 2^depth, a texel's together. Then
    /// reads the rest of the file. May be called once.
    void read(const Use& use);

  private:
    struct Decoder;
    InputFile& file_;
    std::unique_ptr<Decoder> decoder_;
};

}  // namespace dsphere
