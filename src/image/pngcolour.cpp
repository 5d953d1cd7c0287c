#include <array>
#include <cstring>
#include <limits>
#include <memory>

#include "image/codecs.h"
#include "image/coloursink.h"
#include "image/stb.h"

// stb inflates and unfilters. It checks neither the checksums nor that the data can fill the picture, so the chunks are
// walked first (PNG specification, second edition, sections 5 and 11.2.2).

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

/// The table of section D ("Sample CRC implementation"), one entry a byte.
constexpr std::array<std::uint32_t, 256> makeCrcTable() {
    std::array<std::uint32_t, 256> table{};
    for (std::uint32_t n = 0; n < 256; ++n) {
        std::uint32_t c = n;
        for (int k = 0; k < 8; ++k) c = c & 1 ? 0xedb88320u ^ (c >> 1) : c >> 1;
        table[n] = c;
    }
    return table;
}

constexpr std::array<std::uint32_t, 256> kCrcTable = makeCrcTable();

std::uint32_t crcOf(const std::uint8_t* data, std::size_t count) {
    std::uint32_t crc = 0xffffffffu;
    for (std::size_t k = 0; k < count; ++k) crc = kCrcTable[(crc ^ data[k]) & 0xff] ^ (crc >> 8);
    return ~crc;
}

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
        if (crcOf(chunk + 4, length + 4) != load32(chunk + 8 + length))
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

struct Free {
    void operator()(void* pixels) const { stbi_image_free(pixels); }
};

/// Texels of 8 or (wide) 16 bits a channel: 1 grey, 2 grey and alpha, 3 RGB, 4 RGBA.
struct Pixels {
    std::unique_ptr<void, Free> data;
    int width = 0, height = 0, channels = 0;
    bool wide = false;

    double fullScale() const { return wide ? 65535.0 : 255.0; }
    const char* type() const { return wide ? "16-bit PNG" : "8-bit PNG"; }
};

Pixels decode(InputFile& file) {
    if (file.remaining() > std::uint64_t(std::numeric_limits<int>::max()))
        file.invalid("PNG: the file has {} bytes, expected less than 2 GiB", file.remaining());
    std::vector<std::uint8_t> bytes(file.remaining());
    file.read(bytes.data(), bytes.size());
    const Header header = checkChunks(file, bytes);
    Pixels pixels;
    pixels.wide = header.depth == 16;
    forgetStbFailure();
    const auto load = [&](auto loader) {
        pixels.data.reset(loader(bytes.data(), int(bytes.size()), &pixels.width, &pixels.height, &pixels.channels, 0));
    };
    pixels.wide ? load(stbi_load_16_from_memory) : load(stbi_load_from_memory);
    if (!pixels.data) {
        const char* reason = stbi_failure_reason();
        file.invalid("PNG: cannot be decoded: {}", reason ? reason : "its compressed data are damaged");
    }
    return pixels;
}

template <typename Sample>
void putRows(ColourSink& sink, const Sample* data, const Pixels& pixels) {
    const int channels = pixels.channels < 3 ? 1 : 3;
    std::vector<float> row(std::size_t(pixels.width) * std::size_t(channels));
    for (int j = 0; j < pixels.height; ++j) {
        for (auto out = row.begin(); out != row.end(); data += pixels.channels)
            for (int c = 0; c < channels; ++c) *out++ = float(data[c]);
        sink.put(std::size_t(j) * std::size_t(pixels.width), std::size_t(pixels.width), row.data(), channels);
    }
}

}  // namespace

RawColour readPngColour(InputFile& file) {
    const Pixels pixels = decode(file);
    ColourSink sink(pixels.width, pixels.height, {pixels.fullScale()}, pixels.type());
    if (pixels.wide)
        putRows(sink, static_cast<const stbi_us*>(pixels.data.get()), pixels);
    else
        putRows(sink, static_cast<const stbi_uc*>(pixels.data.get()), pixels);
    return sink.take();
}

}  // namespace dsphere
