#include "image/pngpixels.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <limits>

#include "image/codecs.h"
#include "image/coloursink.h"
#include "image/pngrows.h"
#include "image/stb.h"

// Samples of up to 8 bits are decoded by stb_image, which resolves palettes and transparent colours. It checks neither
// the checksums nor that the data can fill the picture, so the chunks are walked first (PNG specification, second
// edition, sections 5 and 11.2.2). Samples of 16 bits are decoded by libpng, as those of height maps are.

namespace dsphere {
namespace {

constexpr std::array<std::uint8_t, 8> kSignature{0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};
constexpr std::size_t kHeaderBytes = 13;  // IHDR
// Deflate packs at most 258 bytes in 2 bits.
constexpr std::uint64_t kMaxDeflateRatio = 1032;

struct Header {
    std::int64_t width = 0, height = 0;
    int depth = 0, channels = 0;  ///< as stored; a palette's index is one channel

    std::uint64_t dataBytes() const {
        return std::uint64_t(width) * std::uint64_t(height) * std::uint64_t(depth * channels) / 8;
    }
};

Header parseHeader(const InputFile& file, const std::uint8_t* data) {
    const Header header{load32(data), load32(data + 4), data[8],
                        data[9] == 2   ? 3
                        : data[9] == 4 ? 2
                        : data[9] == 6 ? 4
                                       : 1};
    checkSize(file, "PNG", header.width, header.height);
    return header;
}

/// Checks every chunk up to IEND, and that the size promised agrees with the data there is.
Header checkChunks(const InputFile& file, const std::vector<std::uint8_t>& bytes) {
    if (bytes.size() < kSignature.size() || std::memcmp(bytes.data(), kSignature.data(), kSignature.size()) != 0)
        file.invalid("PNG: the signature is damaged or truncated");
    Header header;
    std::uint64_t packed = 0;
    for (std::size_t at = kSignature.size();;) {
        const std::size_t left = bytes.size() - at;
        const std::uint8_t* chunk = bytes.data() + at;
        if (left < 12 || load32(chunk) > left - 12)
            file.invalid("PNG: truncated: the file ends inside the chunk at byte {}, before IEND", at);
        const std::size_t length = load32(chunk);
        const std::string name(reinterpret_cast<const char*>(chunk + 4), 4);
        if (crc32(0, chunk + 4, uInt(length + 4)) != load32(chunk + 8 + length))
            file.invalid("PNG: the checksum of the chunk {:?} at byte {} is wrong: the file is damaged", name, at);
        if (at == kSignature.size()) {
            if (name != "IHDR" || length != kHeaderBytes)
                file.invalid("PNG: the first chunk is {:?} of {} bytes, expected IHDR of {}", name, length,
                             kHeaderBytes);
            header = parseHeader(file, chunk + 8);
        }
        if (name == "IDAT") packed += length;
        if (name == "IEND") break;
        at += length + 12;
    }
    const std::uint64_t unpacked = header.dataBytes();
    if (packed == 0 || unpacked / kMaxDeflateRatio > packed)
        file.invalid("PNG: {}x{} texels are {} bytes, which {} bytes of data cannot hold", header.width, header.height,
                     unpacked, packed);
    // The other way round, data that inflates to far more than the texels would fill the memory.
    if (packed > 2 * unpacked + 65536)
        file.invalid("PNG: {} bytes of data for {}x{} texels of {} bytes in all", packed, header.width, header.height,
                     unpacked);
    return header;
}

std::vector<std::uint8_t> readAll(InputFile& file) {
    if (file.remaining() > std::uint64_t(std::numeric_limits<int>::max()))
        file.invalid("PNG: the file has {} bytes, expected less than 2 GiB", file.remaining());
    std::vector<std::uint8_t> bytes(file.remaining());
    file.read(bytes.data(), bytes.size());
    return bytes;
}

void decodeNarrow(const InputFile& file, const std::vector<std::uint8_t>& bytes, PngPixels& pixels) {
    forgetStbFailure();
    pixels.bytes.reset(
        stbi_load_from_memory(bytes.data(), int(bytes.size()), &pixels.width, &pixels.height, &pixels.channels, 0));
    if (pixels.bytes) return;
    const char* reason = stbi_failure_reason();
    file.invalid("PNG: cannot be decoded: {}", reason ? reason : "its compressed data are damaged");
}

/// A colour that counts as transparent becomes an alpha channel.
void decodeWide(InputFile& file, PngPixels& pixels) {
    PngRows png(file);
    const std::vector<std::uint16_t>& key = png.transparent();
    const std::size_t stored = std::size_t(png.channels());
    pixels.width = png.width();
    pixels.height = png.height();
    pixels.channels = png.channels() + (key.empty() ? 0 : 1);
    pixels.words.reserve(std::size_t(pixels.width) * std::size_t(pixels.height) * std::size_t(pixels.channels));
    png.read([&](int, std::span<const std::uint16_t> row) {
        for (std::size_t at = 0; at < row.size(); at += stored) {
            const auto texel = row.subspan(at, stored);
            pixels.words.insert(pixels.words.end(), texel.begin(), texel.end());
            if (!key.empty()) pixels.words.push_back(std::ranges::equal(texel, key) ? 0 : 65535);
        }
    });
}

}  // namespace

void PngPixels::Free::operator()(std::uint8_t* pixels) const {
    stbi_image_free(pixels);
}

PngPixels readPngPixels(InputFile& file) {
    PngPixels pixels;
    {
        const std::vector<std::uint8_t> bytes = readAll(file);
        if (checkChunks(file, bytes).depth < 16) {
            decodeNarrow(file, bytes, pixels);
            return pixels;
        }
    }
    decodeWide(file, pixels);
    return pixels;
}

RawColour readPngColour(InputFile& file) {
    const PngPixels pixels = readPngPixels(file);
    ColourSink sink(pixels.width, pixels.height, {pixels.fullScale()}, pixels.isWide() ? "16-bit PNG" : "8-bit PNG");
    const std::size_t colours = pixels.colours(), width = std::size_t(pixels.width);
    std::vector<float> row(width * colours);
    for (std::size_t j = 0; j < std::size_t(pixels.height); ++j) {
        for (std::size_t i = 0; i < width; ++i)
            for (std::size_t c = 0; c < colours; ++c) row[i * colours + c] = float(pixels.code(j * width + i, c));
        sink.put(j * width, width, row.data(), int(colours));
    }
    return sink.take();
}

}  // namespace dsphere
