// Which reader a file goes to: a format is told by its first bytes.

#include <algorithm>
#include <array>

#include "image/codecs.h"
#include "image/picture.h"

namespace dsphere {
namespace {

using Magic = std::array<std::uint8_t, 4>;

Magic readMagic(InputFile& file) {
    Magic magic{};
    file.rewind();
    file.read(magic.data(), std::min<std::uint64_t>(magic.size(), file.remaining()));
    file.rewind();
    return magic;
}

bool hasGtxExtension(const std::filesystem::path& path) {
    return extensionOf(path) == ".gtx";
}

/// A scene is text: it has no control characters but white space.
bool isBinary(InputFile& file) {
    std::array<char, 512> start;
    const auto count = std::size_t(std::min<std::uint64_t>(start.size(), file.size()));
    file.rewind();
    file.read(start.data(), count);
    return std::any_of(start.begin(), start.begin() + std::ptrdiff_t(count), [](char c) { return c >= 0 && c < 9; });
}

}  // namespace

MapFormat formatOf(InputFile& file) {
    if (file.size() == 0) return MapFormat::Empty;
    constexpr std::uint8_t kClassic = 42, kBig = 43;  // TIFF's version numbers
    const Magic magic = readMagic(file);
    if (magic == Magic{0x89, 'P', 'N', 'G'}) return MapFormat::Png;
    if (magic == Magic{0x76, 0x2f, 0x31, 0x01}) return MapFormat::Exr;
    for (const std::uint8_t version : {kClassic, kBig})
        if (magic == Magic{'I', 'I', version, 0} || magic == Magic{'M', 'M', 0, version}) return MapFormat::Tiff;
    if (magic[0] == 0xff && magic[1] == 0xd8 && magic[2] == 0xff) return MapFormat::Jpeg;
    if (magic[0] != 'P') return MapFormat::Unknown;
    switch (magic[1]) {
        case '2':
        case '3':
        case '5':
        case '6':
            return MapFormat::Pnm;
        case 'f':
        case 'F':
            return MapFormat::Pfm;
        default:
            return MapFormat::Unknown;
    }
}

std::string firstBytes(InputFile& file) {
    const Magic magic = readMagic(file);
    return fmt::format("{:02x} {:02x} {:02x} {:02x}", magic[0], magic[1], magic[2], magic[3]);
}

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
    switch (formatOf(file)) {
        case MapFormat::Png:
            return readPng(file);
        case MapFormat::Pnm:
            return readPnm(file);
        case MapFormat::Pfm:
            return readPfm(file);
        case MapFormat::Tiff:
            return readTiff(file);
        case MapFormat::Exr:
            return readExrMap(file);
        case MapFormat::Jpeg:
            file.invalid("is a JPEG image, which loses heights; expected a PNG, PGM, PPM, TIFF, EXR, PFM or GTX map");
        case MapFormat::Empty:
            file.invalid("is empty, expected a PNG, PGM, PPM, TIFF, EXR, PFM or GTX map");
        case MapFormat::Unknown:
            break;
    }
    if (hasGtxExtension(path)) return readGtx(file);
    file.invalid(
        "unknown format: it begins with the bytes {}, expected a PNG, PGM, PPM (P2 P3 P5 P6), TIFF, EXR or PFM, or a "
        "GTX grid named .gtx",
        firstBytes(file));
}

RawColour readRawColour(const std::filesystem::path& path) {
    InputFile file(path);
    switch (formatOf(file)) {
        case MapFormat::Png:
            return readPngColour(file);
        case MapFormat::Jpeg:
            return readJpegColour(file);
        case MapFormat::Pnm:
            return readPnmColour(file);
        case MapFormat::Pfm:
            return readPfmColour(file);
        case MapFormat::Tiff:
            return readTiffColour(file);
        case MapFormat::Exr:
            return readExrColour(file);
        case MapFormat::Empty:
            file.invalid("is empty, expected a JPEG, PNG, PGM, PPM, PFM, TIFF or EXR image");
        case MapFormat::Unknown:
            break;
    }
    file.invalid(
        "unknown format: it begins with the bytes {}, expected a JPEG, PNG, PGM, PPM (P2 P3 P5 P6), PFM, TIFF or EXR "
        "image",
        firstBytes(file));
}

bool looksLikeMap(const std::filesystem::path& path) try {
    constexpr std::array kExtensions{".png", ".pgm", ".ppm",  ".pnm", ".pbm", ".pam",
                                     ".pfm", ".tif", ".tiff", ".exr", ".gtx"};
    if (std::ranges::find(kExtensions, extensionOf(path)) != kExtensions.end()) return true;
    if (!std::filesystem::is_regular_file(path)) return false;
    InputFile file(path);
    const MapFormat format = formatOf(file);
    if (format == MapFormat::Empty) return false;
    return format != MapFormat::Unknown || (extensionOf(path) != ".pbrt" && isBinary(file));
} catch (const std::exception&) {
    return false;
}

}  // namespace dsphere
