#include <tiffio.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <functional>
#include <limits>
#include <optional>

#include "image/codecs.h"
#include "image/coloursink.h"
#include "image/tiffcheck.h"
#include "image/tiffsource.h"

namespace dsphere {
namespace {

// The most that a codec may unpack a byte to: 1032 for deflate, 2559 for LZW's longest codes, 64 for PackBits. The
// others (ZSTD, LZMA, LERC, WebP ...) shrink equal values as far as they like.
constexpr std::uint64_t kMaxPacking = 4096, kMaxOtherPacking = 65536;

template <typename Sample>
float load(const std::uint8_t* bytes) {
    Sample sample;
    std::memcpy(&sample, bytes, sizeof sample);
    return float(sample);
}

/// The first sample of each colour (grey: all the same one) and of alpha in a run of texels, and the bytes from texel
/// to texel.
struct Row {
    std::array<const std::uint8_t*, 3> colours;
    const std::uint8_t* alpha;  ///< nullptr: none
    std::size_t step;
};

/// One colour of a run of texels.
template <typename Sample>
void toFloats(const std::uint8_t* first, std::size_t step, float* out, std::size_t count) {
    for (; count > 0; --count, first += step, ++out) *out = load<Sample>(first);
}

struct Kind {
    std::uint16_t bits, format;
    double full_scale;
    const char* name;
    void (*toFloats)(const std::uint8_t* first, std::size_t step, float* out, std::size_t count);
};
constexpr std::array kKinds{
    Kind{8, SAMPLEFORMAT_UINT, 255.0, "8-bit TIFF", toFloats<std::uint8_t>},
    Kind{16, SAMPLEFORMAT_UINT, 65535.0, "16-bit TIFF", toFloats<std::uint16_t>},
    Kind{8, SAMPLEFORMAT_INT, 127.0, "signed 8-bit TIFF", toFloats<std::int8_t>},
    Kind{16, SAMPLEFORMAT_INT, 32767.0, "signed 16-bit TIFF", toFloats<std::int16_t>},
    Kind{32, SAMPLEFORMAT_IEEEFP, 1.0, "float32 TIFF", toFloats<float>},
};

/// The page's strips or tiles, here both called blocks: a strip is a block as wide as the map.
struct Layout {
    const Kind* kind = nullptr;
    std::int64_t width = 0, height = 0;
    int samples = 1;                       ///< a texel, with alpha
    bool grey = true;                      ///< else RGB
    bool alpha = false;                    ///< the sample after grey or RGB is alpha
    std::vector<float> palette;            ///< the greys of an 8-bit palette's 256 entries, 0 to 255; empty: none
    bool separate = false, tiled = false;  ///< separate: each sample in blocks of its own
    std::uint64_t packing = 1;             ///< the most that a stored byte unpacks to
    std::int64_t block_width = 0, block_height = 0, across = 0, down = 0;

    int colours() const { return grey ? 1 : 3; }
    int planes() const { return separate ? colours() + int(alpha) : 1; }  ///< that are read
    std::size_t texelBytes() const { return std::size_t(kind->bits / 8 * (separate ? 1 : samples)); }
    std::size_t rowBytes() const { return std::size_t(block_width) * texelBytes(); }
    std::int64_t rowsOf(std::int64_t by) const { return std::min(block_height, height - by * block_height); }
    /// Of a block in that row of blocks as it is stored: tiles are whole, the last strip may be cut.
    std::uint64_t blockBytes(std::int64_t by) const {
        return rowBytes() * std::uint64_t(tiled ? block_height : rowsOf(by));
    }
    /// `apart` is the bytes from sample to sample of a texel.
    Row rowAt(const std::uint8_t* first, std::size_t apart) const {
        const std::size_t next = grey ? 0 : apart;
        const std::uint8_t* last = alpha ? first + std::size_t(colours()) * apart : nullptr;
        return {{first, first + next, first + 2 * next}, last, texelBytes()};
    }
    std::uint32_t index(int plane, std::int64_t bx, std::int64_t by) const {
        return std::uint32_t((plane * down + by) * across + bx);
    }
};

template <typename Number>
Number fieldOf(TIFF* tiff, std::uint32_t tag, Number otherwise) {
    Number value{};
    return TIFFGetFieldDefaulted(tiff, tag, &value) ? value : otherwise;
}

/// TIFF 6.0, section 5: 16-bit colours; some writers store 8-bit ones.
std::vector<float> greyPalette(const InputFile& file, TIFF* tiff, const Layout& layout) {
    std::uint16_t *red = nullptr, *green = nullptr, *blue = nullptr;
    if (layout.kind->bits != 8 || layout.kind->format != SAMPLEFORMAT_UINT || layout.samples != 1 ||
        !TIFFGetField(tiff, TIFFTAG_COLORMAP, &red, &green, &blue))
        file.invalid("TIFF: it has a palette of {} samples of {} bits a texel; expected one sample of 8 bits",
                     layout.samples, layout.kind->bits);
    std::vector<float> greys;
    const float scale = *std::max_element(red, red + 256) > 255 ? 257.0f : 1.0f;
    for (int k = 0; k < 256; ++k) {
        if (red[k] != green[k] || red[k] != blue[k])
            file.invalid(
                "TIFF: its palette holds colours, not heights: entry {} is R {}, G {}, B {}; expected grey or RGB "
                "values, or a palette of greys",
                k, red[k], green[k], blue[k]);
        greys.push_back(float(red[k]) / scale);
    }
    return greys;
}

void setColours(const InputFile& file, TIFF* tiff, Layout& layout) {
    layout.samples = fieldOf<std::uint16_t>(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
    layout.grey = layout.samples < 3;
    const int guess = layout.grey ? PHOTOMETRIC_MINISBLACK : PHOTOMETRIC_RGB;
    const int photometric = fieldOf<std::uint16_t>(tiff, TIFFTAG_PHOTOMETRIC, std::uint16_t(guess));
    if (photometric == PHOTOMETRIC_PALETTE) layout.palette = greyPalette(file, tiff, layout);
    const bool grey =
        !layout.palette.empty() || photometric == PHOTOMETRIC_MINISBLACK || photometric == PHOTOMETRIC_MINISWHITE;
    if ((!grey && photometric != PHOTOMETRIC_RGB) || grey != layout.grey || layout.samples < 1 || layout.samples > 4)
        file.invalid(
            "TIFF: {} samples a texel of photometric interpretation {}; expected grey (0 or 1) of 1 or 2 samples or "
            "RGB (2) of 3 or 4",
            layout.samples, photometric);
    std::uint16_t extra = 0;
    const std::uint16_t* meaning = nullptr;
    layout.alpha = TIFFGetField(tiff, TIFFTAG_EXTRASAMPLES, &extra, &meaning) && extra == 1 &&
                   layout.samples == layout.colours() + 1 && meaning[0] != EXTRASAMPLE_UNSPECIFIED;
}

void setBlocks(const InputFile& file, TIFF* tiff, Layout& layout) {
    layout.separate = fieldOf<std::uint16_t>(tiff, TIFFTAG_PLANARCONFIG, 1) == PLANARCONFIG_SEPARATE;
    layout.tiled = TIFFIsTiled(tiff) != 0;
    layout.block_width = layout.tiled ? fieldOf<std::uint32_t>(tiff, TIFFTAG_TILEWIDTH, 0) : layout.width;
    layout.block_height = layout.tiled ? fieldOf<std::uint32_t>(tiff, TIFFTAG_TILELENGTH, 0)
                                       : fieldOf<std::uint32_t>(tiff, TIFFTAG_ROWSPERSTRIP, 0);
    if (!layout.tiled) layout.block_height = std::min(layout.block_height, layout.height);
    if (layout.block_width < 1 || layout.block_height < 1 || layout.block_width > kMaxSide ||
        layout.block_height > kMaxSide)
        file.invalid("TIFF: strips or tiles of {}x{} texels, expected sides of 1 to {}", layout.block_width,
                     layout.block_height, kMaxSide);
    layout.across = (layout.width + layout.block_width - 1) / layout.block_width;
    layout.down = (layout.height + layout.block_height - 1) / layout.block_height;
    const std::int64_t planes = layout.separate ? layout.samples : 1;
    const std::int64_t blocks = layout.tiled ? TIFFNumberOfTiles(tiff) : TIFFNumberOfStrips(tiff);
    if (blocks != planes * layout.across * layout.down)
        file.invalid("TIFF: {} strips or tiles, expected {}", blocks, planes * layout.across * layout.down);
}

Layout readLayout(const InputFile& file, TIFF* tiff) {
    Layout layout;
    layout.width = fieldOf<std::uint32_t>(tiff, TIFFTAG_IMAGEWIDTH, 0);
    layout.height = fieldOf<std::uint32_t>(tiff, TIFFTAG_IMAGELENGTH, 0);
    checkSize(file, "TIFF", layout.width, layout.height);
    const int bits = fieldOf<std::uint16_t>(tiff, TIFFTAG_BITSPERSAMPLE, 1);
    const int format = fieldOf<std::uint16_t>(tiff, TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
    const auto* kind = std::ranges::find_if(kKinds, [&](auto& k) { return k.bits == bits && k.format == format; });
    if (kind == kKinds.end())
        file.invalid(
            "TIFF: samples of {} bits in format {}; expected 8 or 16 bits, unsigned (1) or signed (2), or 32 bits of "
            "float (3)",
            bits, format);
    layout.kind = kind;
    setColours(file, tiff, layout);
    if (fieldOf<std::uint16_t>(tiff, TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT) != ORIENTATION_TOPLEFT)
        file.invalid("TIFF: it is turned or mirrored by its orientation tag, expected the first row on top");
    const int compression = fieldOf<std::uint16_t>(tiff, TIFFTAG_COMPRESSION, COMPRESSION_NONE);
    if (!TIFFIsCODECConfigured(std::uint16_t(compression)))
        file.invalid("TIFF: compression {} is unknown to this libtiff", compression);
    const bool counted = compression == COMPRESSION_LZW || compression == COMPRESSION_ADOBE_DEFLATE ||
                         compression == COMPRESSION_DEFLATE || compression == COMPRESSION_PACKBITS;
    layout.packing = compression == COMPRESSION_NONE ? 1 : counted ? kMaxPacking : kMaxOtherPacking;
    setBlocks(file, tiff, layout);
    return layout;
}

/// Throws unless every block lies in the file and is long enough for what it shall unpack to.
void checkBlocks(const TiffSource& source, TIFF* tiff, const Layout& layout) {
    const std::uint64_t bytes = source.file.size();
    const std::uint64_t total = std::uint64_t(layout.width * layout.height) * layout.texelBytes();
    if (total / layout.packing > bytes)
        source.file.invalid("TIFF: {}x{} texels are {} bytes, which a file of {} bytes cannot hold", layout.width,
                            layout.height, total, bytes);
    for (int plane = 0; plane < layout.planes(); ++plane)
        for (std::int64_t k = 0; k < layout.across * layout.down; ++k) {
            const std::int64_t by = k / layout.across, bx = k % layout.across;
            int failed = 0;
            const std::uint32_t index = layout.index(plane, bx, by);
            const std::uint64_t offset = TIFFGetStrileOffsetWithErr(tiff, index, &failed);
            const std::uint64_t count = failed ? 0 : TIFFGetStrileByteCountWithErr(tiff, index, &failed);
            if (failed) source.fail("the table of strips or tiles cannot be read");
            const std::uint64_t needed = layout.blockBytes(by);
            if (offset > bytes || count > bytes - offset || count < 1 || needed / layout.packing > count)
                source.file.invalid(
                    "TIFF: truncated or damaged: {} {} has {} bytes at byte {}, for {} bytes of texels; the file has "
                    "{} bytes",
                    layout.tiled ? "tile" : "strip", index, count, offset, needed, bytes);
        }
}

/// Takes a run of texels of one row from the column and row given.
using Use = std::function<void(std::int64_t column, std::int64_t row, Row texels, std::size_t count)>;

void readBlock(TiffSource& source, TIFF* tiff, const Layout& layout, std::uint32_t index, std::uint8_t* to,
               std::uint64_t count) {
    const auto size = tmsize_t(count);
    const tmsize_t got =
        layout.tiled ? TIFFReadEncodedTile(tiff, index, to, size) : TIFFReadEncodedStrip(tiff, index, to, size);
    if (got != size) source.fail(fmt::format("{} {} cannot be decoded", layout.tiled ? "tile" : "strip", index));
}

void readBlocks(TiffSource& source, TIFF* tiff, const Layout& layout, const Use& use) {
    const std::size_t bytes = layout.blockBytes(0);
    std::vector<std::uint8_t> blocks(bytes * std::size_t(layout.planes()));
    const std::size_t apart = layout.separate ? bytes : std::size_t(layout.kind->bits / 8);
    for (std::int64_t by = 0; by < layout.down; ++by) {
        source.forget();
        for (std::int64_t bx = 0; bx < layout.across; ++bx) {
            for (int plane = 0; plane < layout.planes(); ++plane)
                readBlock(source, tiff, layout, layout.index(plane, bx, by), &blocks[std::size_t(plane) * bytes],
                          layout.blockBytes(by));
            const std::int64_t left = bx * layout.block_width, top = by * layout.block_height;
            const std::int64_t columns = std::min(layout.block_width, layout.width - left);
            for (std::int64_t j = 0; j < layout.rowsOf(by); ++j) {
                const std::uint8_t* row = &blocks[std::size_t(j) * layout.rowBytes()];
                use(left, top + j, layout.rowAt(row, apart), std::size_t(columns));
            }
        }
    }
}

/// Strips row by row: one that holds a whole map is never decoded as a whole.
void readRows(TiffSource& source, TIFF* tiff, const Layout& layout, const Use& use) {
    constexpr std::size_t kForgetBytes = std::size_t(16) << 20;
    std::vector<std::uint8_t> row(layout.rowBytes());
    const Row texels = layout.rowAt(row.data(), std::size_t(layout.kind->bits / 8));
    std::size_t decoded = 0;
    if (TIFFScanlineSize64(tiff) != row.size())
        source.file.invalid("TIFF: rows of {} bytes, expected {}", TIFFScanlineSize64(tiff), row.size());
    for (std::int64_t j = 0; j < layout.height; ++j) {
        if (TIFFReadScanline(tiff, row.data(), std::uint32_t(j), 0) < 0)
            source.fail(fmt::format("row {} cannot be decoded", j));
        use(0, j, texels, std::size_t(layout.width));
        decoded += row.size();
        if (decoded < kForgetBytes) continue;
        source.forget();
        decoded = 0;
    }
}

/// "16-bit colour TIFF with alpha"
std::string typeOf(const Layout& layout) {
    std::string type = layout.kind->name;
    if (!layout.grey) type.insert(type.rfind(' '), " colour");
    if (!layout.palette.empty()) type += " with a palette";
    return layout.alpha ? type + " with alpha" : type;
}

/// Calls `start(layout)` when the header and the blocks' places have been checked, then the Use that it returns.
template <typename Start>
void readPage(InputFile& file, Start start) {
    checkTiffDirectory(file);
    TiffSource source{file};
    const std::uint64_t limit = std::uint64_t(kMaxTexels) * 4 * 4;
    const TiffHandle tiff = openTiff(source, std::min(limit, file.size() * kMaxOtherPacking));
    const Layout layout = readLayout(file, tiff.get());
    checkBlocks(source, tiff.get(), layout);
    const Use use = start(layout);
    const bool by_rows = !layout.tiled && layout.planes() == 1;
    by_rows ? readRows(source, tiff.get(), layout, use) : readBlocks(source, tiff.get(), layout, use);
    source.checkIsWhole();
}

/// Turns runs of texels into heights: grey ones as they are, colours and those with alpha by way of the censuses.
class Heights {
  public:
    Heights(const Layout& layout, RawMap& map)
        : kind_(*layout.kind),
          plain_(layout.grey && !layout.alpha),
          palette_(layout.palette),
          map_(map),
          alpha_(layout.kind->full_scale) {
        for (auto& plane : planes_) plane.resize(plain_ ? 0 : std::size_t(layout.block_width));
    }

    void put(std::int64_t column, std::int64_t row, Row texels, std::size_t count) {
        float* out = &map_.samples[std::size_t(row * map_.width + column)];
        if (plain_) {
            kind_.toFloats(texels.colours[0], texels.step, out, count);
            if (!palette_.empty())
                std::transform(out, out + count, out, [&](float entry) { return palette_[std::size_t(entry)]; });
            return;
        }
        for (std::size_t c = 0; c < 3; ++c) kind_.toFloats(texels.colours[c], texels.step, planes_[c].data(), count);
        if (texels.alpha) kind_.toFloats(texels.alpha, texels.step, planes_[3].data(), count);
        colours_.startRow();
        for (std::size_t k = 0; k < count; ++k)
            out[k] = texels.alpha && !alpha_.isKnown(planes_[3][k])
                         ? std::numeric_limits<float>::quiet_NaN()
                         : colours_.grey(planes_[0][k], planes_[1][k], planes_[2][k]);
    }

    void report(const std::string& path) const {
        colours_.report(map_, path);
        alpha_.report(map_, path);
    }

  private:
    const Kind& kind_;
    bool plain_;
    std::vector<float> palette_;
    RawMap& map_;
    std::array<std::vector<float>, 4> planes_;  ///< of a run: red, green, blue, alpha
    ColourCensus colours_;
    AlphaCensus alpha_;
};

}  // namespace

RawMap readTiff(InputFile& file) {
    RawMap map;
    std::optional<Heights> heights;
    readPage(file, [&](const Layout& layout) -> Use {
        map.width = int(layout.width);
        map.height = int(layout.height);
        map.full_scale = layout.kind->full_scale;
        map.type = typeOf(layout);
        map.samples.resize(std::size_t(layout.width) * std::size_t(layout.height));
        heights.emplace(layout, map);
        return [&](std::int64_t column, std::int64_t row, Row texels, std::size_t count) {
            heights->put(column, row, texels, count);
        };
    });
    heights->report(file.name());
    return map;
}

RawColour readTiffColour(InputFile& file) {
    std::optional<ColourSink> sink;
    std::vector<float> plane, values;
    readPage(file, [&](const Layout& layout) -> Use {
        const Kind& kind = *layout.kind;
        if (!layout.palette.empty()) file.invalid("TIFF: it has a palette, expected grey or RGB values");
        if (kind.format == SAMPLEFORMAT_INT)
            file.invalid("{}: expected an image of unsigned integers or floats", kind.name);
        sink.emplace(int(layout.width), int(layout.height),
                     ColourCode{kind.full_scale, kind.format == SAMPLEFORMAT_UINT}, kind.name);
        plane.resize(std::size_t(layout.block_width));
        values.resize(3 * plane.size());
        return [&, width = layout.width](std::int64_t column, std::int64_t row, Row texels, std::size_t count) {
            for (std::size_t c = 0; c < 3; ++c) {
                kind.toFloats(texels.colours[c], texels.step, plane.data(), count);
                for (std::size_t k = 0; k < count; ++k) values[3 * k + c] = plane[k];
            }
            sink->put(std::size_t(row * width + column), count, values.data(), 3);
        };
    });
    return sink->take();
}

}  // namespace dsphere
