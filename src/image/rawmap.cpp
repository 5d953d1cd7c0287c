#include "image/rawmap.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "image/codecs.h"

namespace dsphere {
namespace {

using Reader = RawMap (*)(InputFile&);

/// The reader for the file's magic, or nullptr. GTX has none.
Reader readerOf(const std::array<std::uint8_t, 4>& magic) {
    constexpr std::uint8_t kClassic = 42, kBig = 43;  // TIFF's version numbers
    if (magic == std::array<std::uint8_t, 4>{0x89, 'P', 'N', 'G'}) return readPng;
    if (magic == std::array<std::uint8_t, 4>{0x76, 0x2f, 0x31, 0x01}) return readExrMap;
    for (const std::uint8_t version : {kClassic, kBig}) {
        if (magic == std::array<std::uint8_t, 4>{'I', 'I', version, 0}) return readTiff;
        if (magic == std::array<std::uint8_t, 4>{'M', 'M', 0, version}) return readTiff;
    }
    if (magic[0] != 'P') return nullptr;
    switch (magic[1]) {
        case '2':
        case '3':
        case '5':
        case '6':
            return readPnm;
        case 'f':
        case 'F':
            return readPfm;
        default:
            return nullptr;
    }
}

bool hasGtxExtension(const std::filesystem::path& path) {
    std::string extension = path.extension().string();
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return extension == ".gtx";
}

}  // namespace

void checkSize(const InputFile& file, std::string_view format, std::int64_t width, std::int64_t height) {
    if (width < 1 || height < 1) file.invalid("{}: the size is {}x{}, expected at least 1x1", format, width, height);
    if (width > kMaxSide || height > kMaxSide || width * height > kMaxTexels)
        file.invalid("{}: the size is {}x{}, expected sides of at most {} and at most {} texels", format, width, height,
                     kMaxSide, kMaxTexels);
}

void checkLength(const InputFile& file, std::string_view what, std::uint64_t needed) {
    if (file.remaining() < needed)
        file.invalid("{}: truncated: at least {} bytes expected after the header, {} found", what, needed,
                     file.remaining());
}

RawMap readRawMap(const std::filesystem::path& path) {
    InputFile file(path);
    if (file.remaining() == 0) file.invalid("is empty, expected a PNG, PGM, PPM, TIFF, EXR, PFM or GTX map");
    std::array<std::uint8_t, 4> magic{};
    file.read(magic.data(), std::min<std::uint64_t>(magic.size(), file.remaining()));
    file.rewind();
    if (const Reader read = readerOf(magic)) return read(file);
    if (hasGtxExtension(path)) return readGtx(file);
    file.invalid(
        "unknown format: it begins with the bytes {:02x} {:02x} {:02x} {:02x}, expected a PNG, PGM, PPM (P2 P3 P5 P6), "
        "TIFF, EXR or PFM, or a GTX grid named .gtx",
        magic[0], magic[1], magic[2], magic[3]);
}

}  // namespace dsphere
