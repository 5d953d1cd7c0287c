#include <png.h>

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "base/srgb.h"
#include "image/codecs.h"
#include "image/picture.h"
#include "image/stb.h"

// libpng's simplified interface: whatever the file holds comes as 8-bit sRGB.

namespace dsphere {
namespace {

// Deflate packs at most 258 bytes in 2 bits.
constexpr std::uint64_t kMaxDeflateRatio = 1032;

/// A png_image that frees what libpng hangs on it.
struct PngImage {
    png_image png{};

    PngImage() { png.version = PNG_IMAGE_VERSION; }
    ~PngImage() { png_image_free(&png); }
    PngImage(const PngImage&) = delete;
    PngImage& operator=(const PngImage&) = delete;
};

float fromSrgb(double encoded) {
    return float(linearFromSrgb(encoded));
}

/// `linear(k, c)` is channel c of pixel k.
template <typename Linear>
Image makePicture(const png_image& png, Linear linear) {
    Image image;
    image.data = image.display = {0, 0, int(png.width), int(png.height)};
    const char* const names[] = {"R", "G", "B"};
    for (std::size_t c = 0; c < 3; ++c) {
        std::vector<float>& plane = image.addFloat(names[c]).floats();
        for (std::size_t k = 0; k < plane.size(); ++k) plane[k] = linear(k, c);
    }
    return image;
}

struct Free {
    void operator()(void* pixels) const { stbi_image_free(pixels); }
};

/// 16 bits a sample, which libpng would decode by a power of 2.2; it has checked the file already.
Image decodeWide(const InputFile& file, const png_image& png, const std::vector<std::uint8_t>& bytes) {
    int width = 0, height = 0, channels = 0;
    const std::unique_ptr<stbi_us, Free> pixels(
        stbi_load_16_from_memory(bytes.data(), int(bytes.size()), &width, &height, &channels, 4));
    if (!pixels) file.invalid("PNG: cannot be decoded: {}", stbi_failure_reason());
    return makePicture(png, [&](std::size_t k, std::size_t c) {
        const stbi_us* pixel = pixels.get() + 4 * k;
        return fromSrgb(pixel[c] / 65535.0) * float(pixel[3] / 65535.0);
    });
}

}  // namespace

Image readPngPicture(const std::filesystem::path& path) {
    InputFile file(path);
    if (file.remaining() > std::uint64_t(std::numeric_limits<int>::max()))
        file.invalid("PNG: the file has {} bytes, expected less than 2 GiB", file.remaining());
    std::vector<std::uint8_t> bytes(file.remaining());
    file.read(bytes.data(), bytes.size());
    PngImage image;
    png_image& png = image.png;
    if (!png_image_begin_read_from_memory(&png, bytes.data(), bytes.size()))
        file.invalid("PNG: cannot be decoded: {}", png.message);
    checkSize(file, "PNG", png.width, png.height);
    if (std::uint64_t(png.width) * png.height / 8 > bytes.size() * kMaxDeflateRatio)
        file.invalid("PNG: {}x{} pixels cannot lie in a file of {} bytes", png.width, png.height, bytes.size());
    const bool wide = png.format & PNG_FORMAT_FLAG_LINEAR;
    png.format = PNG_FORMAT_RGB;
    const png_color black{0, 0, 0};  // behind what is transparent
    std::vector<std::uint8_t> pixels(3 * std::size_t(png.width) * std::size_t(png.height));
    if (!png_image_finish_read(&png, &black, pixels.data(), 0, nullptr))
        file.invalid("PNG: cannot be decoded: {}", png.message);
    if (wide) return decodeWide(file, png, bytes);
    return makePicture(png, [&](std::size_t k, std::size_t c) { return fromSrgb(pixels[3 * k + c] / 255.0); });
}

}  // namespace dsphere
