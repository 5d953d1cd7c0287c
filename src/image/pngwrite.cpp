#include <stb/stb_image_write.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/atomicfile.h"
#include "base/error.h"
#include "base/parallel.h"
#include "image/picture.h"

namespace dsphere {
namespace {

constexpr std::uint64_t kMaxBytes = std::uint64_t(1) << 30;  // stb counts bytes in int

/// IEC 61966-2-1, rounded to the nearest of 256 levels; NaN is black.
std::uint8_t toSrgb(double linear) {
    if (!(linear > 0.0)) return 0;
    if (linear >= 1.0) return 255;
    const double encoded = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
    return std::uint8_t(255.0 * encoded + 0.5);
}

void writeTo(void* file, void* data, int size) {
    static_cast<AtomicFile*>(file)->write(data, std::size_t(size));
}

/// The bytes of the picture's pixels: R, G, B, and A if it has one.
std::vector<std::uint8_t> encoded(const Image& image, const Tone& tone) {
    const Channel* alpha = image.find("A");
    const std::size_t channels = alpha ? 4 : 3;
    std::vector<std::uint8_t> bytes(channels * image.pixelCount());
    const double gain = std::exp2(tone.exposure);
    const char* const names[] = {"R", "G", "B"};
    for (std::size_t c = 0; c < 3; ++c) {
        const std::vector<float>& plane = image.at(names[c]).floats();
        const std::size_t width = std::size_t(image.data.width());
        parallelFor(std::size_t(image.data.height()), [&](std::size_t row) {
            for (std::size_t k = row * width; k < (row + 1) * width; ++k) {
                const double cover = alpha ? double(alpha->floats()[k]) : 1.0;
                const double light = cover > 0.0 ? double(plane[k]) / cover : 0.0;
                bytes[channels * k + c] = toSrgb(toneMapped(tone.curve, gain * light));
            }
        });
    }
    for (std::size_t k = 0; alpha && k < image.pixelCount(); ++k)
        bytes[channels * k + 3] = std::uint8_t(255.0 * std::clamp(double(alpha->floats()[k]), 0.0, 1.0) + 0.5);
    return bytes;
}

}  // namespace

void checkPngSize(const std::filesystem::path& path, int width, int height, int channels) {
    if (std::uint64_t(width) * std::uint64_t(height) * std::uint64_t(channels) > kMaxBytes)
        throwFailure(
            "{}: {}x{} pixels of {} channels are more than the library that writes PNGs counts ({} bytes); write an "
            ".exr",
            path.string(), width, height, channels, kMaxBytes);
}

void writePng(const std::filesystem::path& path, const Image& image, const Tone& tone) {
    const int width = image.data.width(), height = image.data.height();
    const int channels = image.find("A") ? 4 : 3;
    checkPngSize(path, width, height, channels);
    AtomicFile file(path);
    const std::vector<std::uint8_t> bytes = encoded(image, tone);
    // stb packs in memory and calls writeTo once.
    if (!stbi_write_png_to_func(writeTo, &file, width, height, channels, bytes.data(), channels * width))
        throwFailure("{}: cannot be written: the PNG of {}x{} pixels does not fit into memory", path.string(), width,
                     height);
    file.commit();
}

}  // namespace dsphere
