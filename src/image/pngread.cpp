#include <limits>

#include "image/codecs.h"
#include "image/pngrows.h"

namespace dsphere {
namespace {

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

/// Turns the rows of a PNG into heights. What has fewer than 8 bits is spread over 0 to 255, as the PNG specification
/// has it; a palette's colours must be grey.
class Heights {
  public:
    Heights(const InputFile& file, const PngRows& png, RawMap& map)
        : file_(file), png_(png), map_(map), channels_(std::size_t(png.channels())) {
        const bool palette = png.colour() == PngRows::Colour::Palette;
        const int bits = palette || png.depth() < 8 ? 8 : png.depth();
        map.full_scale = bits == 16 ? 65535.0 : 255.0;
        spread_ = palette || png.depth() > 8 ? 1.0f : 255.0f / float((1 << png.depth()) - 1);
        alpha_ = AlphaCensus(map.full_scale);
    }

    /// The next row, which is row `j`.
    void add(int j, std::span<const std::uint16_t> row) {
        colours_.startRow();
        for (std::size_t at = 0; at < row.size(); at += channels_) map_.samples.push_back(height(row, at, j));
    }

    void report() {
        colours_.report(map_, file_.name());
        alpha_.report(map_, file_.name());
    }

  private:
    float height(std::span<const std::uint16_t> row, std::size_t at, int j) {
        switch (png_.colour()) {
            case PngRows::Colour::Grey:
                return isKey(&row[at]) ? unknown() : spread_ * float(row[at]);
            case PngRows::Colour::Rgb:
                return isKey(&row[at]) ? unknown() : grey(&row[at]);
            case PngRows::Colour::GreyAlpha:
                return alpha_.isKnown(row[at + 1]) ? float(row[at]) : kUnknown;
            case PngRows::Colour::Rgba:
                return alpha_.isKnown(row[at + 3]) ? grey(&row[at]) : kUnknown;
            case PngRows::Colour::Palette:
                return entry(row[at], at, j);  // one channel: `at` is the column
        }
        return kUnknown;
    }

    bool isKey(const std::uint16_t* texel) const {
        const auto& key = png_.transparent();
        return key.size() == channels_ && std::equal(key.begin(), key.end(), texel);
    }
    float unknown() {
        alpha_.isKnown(0.0f);
        return kUnknown;
    }
    float grey(const std::uint16_t* rgb) { return colours_.grey(rgb[0], rgb[1], rgb[2]); }

    float entry(std::size_t index, std::size_t column, int j) {
        if (index >= png_.palette().size())
            file_.invalid("PNG: the texel at column {}, row {} has entry {} of a palette of {}", column, j, index,
                          png_.palette().size());
        const PngRows::Entry& entry = png_.palette()[index];
        if (!alpha_.isKnown(entry.alpha)) return kUnknown;
        if (entry.red != entry.green || entry.green != entry.blue)
            file_.invalid(
                "PNG: its palette holds colours, not heights: the texel at column {}, row {} is R {}, G {}, B {}; "
                "expected a grey or RGB map, or a palette of greys",
                column, j, entry.red, entry.green, entry.blue);
        return entry.red;
    }

    const InputFile& file_;
    const PngRows& png_;
    RawMap& map_;
    std::size_t channels_;
    float spread_ = 1.0f;
    ColourCensus colours_;
    AlphaCensus alpha_{255.0};
};

/// "16-bit colour PNG with alpha".
std::string typeOf(const PngRows& png) {
    using Colour = PngRows::Colour;
    const Colour colour = png.colour();
    const bool alpha = colour == Colour::GreyAlpha || colour == Colour::Rgba;
    std::string type = fmt::format("{}-bit ", png.depth());
    if (colour == Colour::Rgb || colour == Colour::Rgba) type += "colour ";
    if (colour == Colour::Palette) type += "palette ";
    type += "PNG";
    if (alpha) type += " with alpha";
    if (!png.transparent().empty()) type += " with a transparent colour";
    return type;
}

}  // namespace

RawMap readPng(InputFile& file) {
    PngRows png(file);
    RawMap map;
    map.width = png.width();
    map.height = png.height();
    map.type = typeOf(png);
    map.samples.reserve(std::size_t(map.width) * std::size_t(map.height));  // used up only as far as there are rows
    Heights heights(file, png, map);
    png.read([&](int j, std::span<const std::uint16_t> row) { heights.add(j, row); });
    heights.report();
    return map;
}

}  // namespace dsphere
