#pragma once

// A PNG encoder of a few lines for tests: stored (uncompressed) deflate blocks, no row filters, every depth and colour
// type of the specification. It shares no code with the readers under test.

#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

namespace dsphere::test {

enum class PngColour : char { Grey = 0, Rgb = 2, Palette = 3, GreyAlpha = 4, Rgba = 6 };

inline std::string big32(std::uint32_t n) {
    return {char(n >> 24), char(n >> 16), char(n >> 8), char(n)};
}

inline std::uint32_t pngCrc(const std::string& bytes) {
    std::uint32_t crc = 0xffffffffu;
    for (const char byte : bytes) {
        crc ^= std::uint8_t(byte);
        for (int k = 0; k < 8; ++k) crc = crc & 1 ? 0xedb88320u ^ (crc >> 1) : crc >> 1;
    }
    return ~crc;
}

/// Length, name, data, checksum.
inline std::string pngChunk(const std::string& name, const std::string& data) {
    return big32(std::uint32_t(data.size())) + name + data + big32(pngCrc(name + data));
}

/// A zlib stream of stored blocks.
inline std::string zlibStored(const std::string& raw) {
    constexpr std::size_t kBlock = 65535;
    std::string out = "\x78\x01";
    for (std::size_t at = 0; at == 0 || at < raw.size(); at += kBlock) {
        const std::size_t length = std::min(kBlock, raw.size() - at);
        out += char(at + length == raw.size() ? 1 : 0);
        out += {char(length), char(length >> 8), char(~length), char(~length >> 8)};
        out += raw.substr(at, length);
    }
    std::uint32_t a = 1, b = 0;  // Adler-32
    for (const char byte : raw) {
        a = (a + std::uint8_t(byte)) % 65521;
        b = (b + a) % 65521;
    }
    return out + big32(b << 16 | a);
}

/// `samples` row-major, the channels of a texel together, each below 2^depth; `extra` (whole chunks: PLTE, tRNS) goes
/// between IHDR and IDAT.
inline std::string pngFile(int width, int height, int depth, PngColour colour, const std::vector<unsigned>& samples,
                           const std::string& extra = "") {
    std::string raw;
    const std::size_t row_samples = samples.size() / std::size_t(height);
    for (std::size_t j = 0; j < std::size_t(height); ++j) {
        raw += '\0';  // no filter
        unsigned bits = 0;
        int held = 0;
        for (std::size_t k = 0; k < row_samples; ++k) {
            bits = bits << depth | samples[j * row_samples + k];
            for (held += depth; held >= 8; held -= 8) raw += char(bits >> (held - 8));
        }
        if (held > 0) raw += char(bits << (8 - held));
    }
    const std::string header =
        big32(std::uint32_t(width)) + big32(std::uint32_t(height)) + char(depth) + char(colour) + std::string(3, '\0');
    return "\x89PNG\r\n\x1a\n" + pngChunk("IHDR", header) + extra + pngChunk("IDAT", zlibStored(raw)) +
           pngChunk("IEND", "");
}

}  // namespace dsphere::test
