#include <stb/stb_image_write.h>

#include <cmath>
#include <cstdint>
#include <vector>

#include "base/error.h"
#include "image/atomicfile.h"
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

}  // namespace

void writePng(const std::filesystem::path& path, const Image& image, const Tone& tone) {
    const int width = image.data.width(), height = image.data.height();
    if (3 * std::uint64_t(image.pixelCount()) > kMaxBytes)
        throwFailure("{}: {}x{} pixels are more than a PNG of this program holds; write an EXR", path.string(), width,
                     height);
    AtomicFile file(path);
    std::vector<std::uint8_t> bytes(3 * image.pixelCount());
    const double gain = std::exp2(tone.exposure);
    const char* const names[] = {"R", "G", "B"};
    for (std::size_t c = 0; c < 3; ++c) {
        const std::vector<float>& plane = image.at(names[c]).floats();
        for (std::size_t k = 0; k < plane.size(); ++k)
            bytes[3 * k + c] = toSrgb(toneMapped(tone.curve, gain * double(plane[k])));
    }
    // stb packs in memory and calls writeTo once.
    if (!stbi_write_png_to_func(writeTo, &file, width, height, 3, bytes.data(), 3 * width))
        throwFailure("{}: cannot be written: the PNG of {}x{} pixels does not fit into memory", path.string(), width,
                     height);
    file.commit();
}

}  // namespace dsphere
