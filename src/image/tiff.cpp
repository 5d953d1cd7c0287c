#include <tiffio.h>

#include <algorithm>
#include <array>
#include <cstdarg>
#include <cstring>
#include <memory>

#include "image/codecs.h"
#include "image/tiffcheck.h"

// Everything here hangs on one TIFF handle: its input, its messages and its memory limit. libtiff's global handlers are
// left alone, so that any number of maps may be read at once.

namespace dsphere {
namespace {

/// What libtiff calls back with. Nothing may be thrown through it.
struct Source {
    InputFile& file;
    std::uint64_t position = 0;      ///< may lie beyond the end
    std::array<char, 256> reason{};  ///< the first error told
};

tmsize_t readBytes(thandle_t handle, void* to, tmsize_t count) try {
    Source& source = *static_cast<Source*>(handle);
    if (source.position >= source.file.size()) return 0;
    source.file.seek(source.position);
    const auto wanted = std::size_t(std::min<std::uint64_t>(std::uint64_t(count), source.file.remaining()));
    source.file.read(to, wanted);
    source.position += wanted;
    return tmsize_t(wanted);
} catch (const std::exception&) {
    return -1;
}

tmsize_t writeNothing(thandle_t, void*, tmsize_t) {
    return 0;
}

toff_t seekTo(thandle_t handle, toff_t offset, int whence) {
    Source& source = *static_cast<Source*>(handle);
    const std::uint64_t from = whence == SEEK_CUR ? source.position : whence == SEEK_END ? source.file.size() : 0;
    return source.position = from + offset;
}

int keepOpen(thandle_t) {
    return 0;
}

toff_t sizeOf(thandle_t handle) {
    return static_cast<Source*>(handle)->file.size();
}

int keepError(TIFF*, void* user, const char*, const char* format, va_list arguments) {
    auto& reason = static_cast<Source*>(user)->reason;
    if (reason[0] == '\0') std::vsnprintf(reason.data(), reason.size(), format, arguments);
    return 1;  // handled: nothing is printed
}

/// Warnings are of tags unknown to libtiff, GeoTIFF's for one.
int dropWarning(TIFF*, void*, const char*, const char*, va_list) {
    return 1;
}

struct Close {
    void operator()(TIFF* tiff) const { TIFFClose(tiff); }
    void operator()(TIFFOpenOptions* options) const { TIFFOpenOptionsFree(options); }
};
using Handle = std::unique_ptr<TIFF, Close>;

[[noreturn]] void fail(const Source& source, std::string_view what) {
    source.file.invalid("TIFF: {}: {}", what, source.reason[0] ? source.reason.data() : "unknown reason");
}

// The most that a codec may unpack a byte to: 1032 for deflate, 2559 for LZW's longest codes, 64 for PackBits. The
// others (ZSTD, LZMA, LERC, WebP ...) shrink equal values as far as they like.
constexpr std::uint64_t kMaxPacking = 4096, kMaxOtherPacking = 65536;

Handle open(Source& source) {
    const std::unique_ptr<TIFFOpenOptions, Close> options(TIFFOpenOptionsAlloc());
    if (!options) throw std::bad_alloc();
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), keepError, &source);
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), dropWarning, nullptr);
    const std::uint64_t limit = std::uint64_t(kMaxTexels) * 4 * 4;
    TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(),
                                        tmsize_t(std::min(limit, source.file.size() * kMaxOtherPacking)));
    // m: do not map the file into memory.
    Handle tiff(TIFFClientOpenExt(source.file.name().c_str(), "rm", &source, readBytes, writeNothing, seekTo, keepOpen,
                                  sizeOf, nullptr, nullptr, options.get()));
    if (!tiff) fail(source, "cannot be read");
    return tiff;
}

template <typename Sample>
float load(const std::uint8_t* bytes) {
    Sample sample;
    std::memcpy(&sample, bytes, sizeof sample);
    return float(sample);
}

/// The first colour of a row in each plane (grey: all the same one), and the bytes from texel to texel.
struct Row {
    std::array<const std::uint8_t*, 3> colours;
    std::size_t step;
};

template <typename Sample>
void toFloats(Row row, bool grey, float* out, std::size_t count) {
    for (std::size_t at = 0; count > 0; --count, at += row.step, ++out) {
        const float first = load<Sample>(row.colours[0] + at);
        *out = grey ? first : meanOf(first, load<Sample>(row.colours[1] + at), load<Sample>(row.colours[2] + at));
    }
}

struct Kind {
    std::uint16_t bits, format;
    double full_scale;
    const char* name;
    void (*toFloats)(Row, bool grey, float*, std::size_t);
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
    bool separate = false, tiled = false;  ///< separate: each sample in blocks of its own
    std::uint64_t packing = 1;             ///< the most that a stored byte unpacks to
    std::int64_t block_width = 0, block_height = 0, across = 0, down = 0;

    int planes() const { return !separate || grey ? 1 : 3; }  ///< that are read
    std::size_t texelBytes() const { return std::size_t(kind->bits / 8 * (separate ? 1 : samples)); }
    std::size_t rowBytes() const { return std::size_t(block_width) * texelBytes(); }
    std::int64_t rowsOf(std::int64_t by) const { return std::min(block_height, height - by * block_height); }
    /// Of a block in that row of blocks as it is stored: tiles are whole, the last strip may be cut.
    std::uint64_t blockBytes(std::int64_t by) const {
        return rowBytes() * std::uint64_t(tiled ? block_height : rowsOf(by));
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

void setColours(const InputFile& file, TIFF* tiff, Layout& layout) {
    layout.samples = fieldOf<std::uint16_t>(tiff, TIFFTAG_SAMPLESPERPIXEL, 1);
    layout.grey = layout.samples < 3;
    const int guess = layout.grey ? PHOTOMETRIC_MINISBLACK : PHOTOMETRIC_RGB;
    const int photometric = fieldOf<std::uint16_t>(tiff, TIFFTAG_PHOTOMETRIC, std::uint16_t(guess));
    if (photometric == PHOTOMETRIC_PALETTE) file.invalid("TIFF: it has a palette, expected grey or RGB values");
    const bool grey = photometric == PHOTOMETRIC_MINISBLACK || photometric == PHOTOMETRIC_MINISWHITE;
    if ((!grey && photometric != PHOTOMETRIC_RGB) || grey != layout.grey || layout.samples < 1 || layout.samples > 4)
        file.invalid(
            "TIFF: {} samples a texel of photometric interpretation {}; expected grey (0 or 1) of 1 or 2 samples or "
            "RGB (2) of 3 or 4",
            layout.samples, photometric);
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
void checkBlocks(const Source& source, TIFF* tiff, const Layout& layout) {
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
            if (failed) fail(source, "the table of strips or tiles cannot be read");
            const std::uint64_t needed = layout.blockBytes(by);
            if (offset > bytes || count > bytes - offset || count < 1 || needed / layout.packing > count)
                source.file.invalid(
                    "TIFF: truncated or damaged: {} {} has {} bytes at byte {}, for {} bytes of texels; the file has "
                    "{} bytes",
                    layout.tiled ? "tile" : "strip", index, count, offset, needed, bytes);
        }
}

void readBlock(Source& source, TIFF* tiff, const Layout& layout, std::uint32_t index, std::uint8_t* to,
               std::uint64_t count) {
    const auto size = tmsize_t(count);
    const tmsize_t got =
        layout.tiled ? TIFFReadEncodedTile(tiff, index, to, size) : TIFFReadEncodedStrip(tiff, index, to, size);
    if (got != size) fail(source, fmt::format("{} {} cannot be decoded", layout.tiled ? "tile" : "strip", index));
}

void readBlocks(Source& source, TIFF* tiff, const Layout& layout, std::vector<float>& samples) {
    const std::size_t bytes = layout.blockBytes(0);
    std::vector<std::uint8_t> blocks(bytes * std::size_t(layout.planes()));
    // From colour to colour of a texel.
    const std::size_t apart = layout.grey ? 0 : layout.separate ? bytes : std::size_t(layout.kind->bits / 8);
    for (std::int64_t by = 0; by < layout.down; ++by)
        for (std::int64_t bx = 0; bx < layout.across; ++bx) {
            for (int plane = 0; plane < layout.planes(); ++plane)
                readBlock(source, tiff, layout, layout.index(plane, bx, by), &blocks[std::size_t(plane) * bytes],
                          layout.blockBytes(by));
            const std::int64_t left = bx * layout.block_width, top = by * layout.block_height;
            const std::int64_t columns = std::min(layout.block_width, layout.width - left);
            for (std::int64_t j = 0; j < layout.rowsOf(by); ++j) {
                const std::uint8_t* row = &blocks[std::size_t(j) * layout.rowBytes()];
                layout.kind->toFloats({{row, row + apart, row + 2 * apart}, layout.texelBytes()}, layout.grey,
                                      &samples[std::size_t((top + j) * layout.width + left)], std::size_t(columns));
            }
        }
}

}  // namespace

RawMap readTiff(InputFile& file) {
    checkTiffDirectory(file);
    Source source{file};
    const Handle tiff = open(source);
    const Layout layout = readLayout(file, tiff.get());
    checkBlocks(source, tiff.get(), layout);

    RawMap map;
    map.width = int(layout.width);
    map.height = int(layout.height);
    map.full_scale = layout.kind->full_scale;
    map.type = layout.kind->name;
    map.samples.resize(std::size_t(layout.width) * std::size_t(layout.height));
    readBlocks(source, tiff.get(), layout, map.samples);
    return map;
}

}  // namespace dsphere
