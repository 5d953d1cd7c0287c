#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/atomicfile.h"
#include "base/error.h"
#include "base/parallel.h"
#include "base/srgb.h"
#include "image/picture.h"
#include "image/pngerrors.h"

namespace dsphere {
namespace {

constexpr std::uint64_t kMaxBytes = std::uint64_t(1) << 30;  // they are held in memory

// As small as stronger packing of rendered pictures, or smaller, in a third of the time: docs/notebook.md.
constexpr int kFilters = PNG_FAST_FILTERS, kDeflateLevel = 2;
constexpr std::size_t kChunkBytes = 1 << 18;

/// srgbFromLinear(), rounded to the nearest of 256 levels.
int srgbLevel(double linear) {
    return int(255.0 * srgbFromLinear(linear) + 0.5);
}

/// srgbLevel() without a power for each value: by where each level begins.
class SrgbLevels {
  public:
    SrgbLevels() {
        for (int level = 1; level < 256; ++level) begins_[std::size_t(level)] = beginOf(level);
        for (std::uint32_t step = 0; step <= kSteps; ++step)
            levels_[step] = std::uint8_t(srgbLevel(std::bit_cast<float>(kLeastBits + (step << kShift))));
    }

    /// NaN is black.
    std::uint8_t of(double linear) const {
        if (!(linear > 0.0)) return 0;
        if (linear >= 1.0) return 255;
        const std::uint32_t bits = std::max(std::bit_cast<std::uint32_t>(float(linear)), kLeastBits);
        int level = levels_[(bits - kLeastBits) >> kShift];
        while (level > 0 && linear < begins_[std::size_t(level)]) --level;  // the float may be rounded up
        while (level < 255 && linear >= begins_[std::size_t(level) + 1]) ++level;
        return std::uint8_t(level);
    }

  private:
    // Steps of a 64th of a power of two, in each of which two levels begin at most. They start below level 1.
    static constexpr std::uint32_t kLeastBits = 0x39000000, kShift = 17, kSteps = (0x3f800000 - kLeastBits) >> kShift;

    /// The least value of a level, by halving between two doubles until they are neighbours.
    static double beginOf(int level) {
        std::uint64_t below = 0, from = std::bit_cast<std::uint64_t>(1.0);
        while (from - below > 1) {
            const std::uint64_t middle = below + (from - below) / 2;
            (srgbLevel(std::bit_cast<double>(middle)) >= level ? from : below) = middle;
        }
        return std::bit_cast<double>(from);
    }

    std::array<double, 256> begins_ = {};
    std::array<std::uint8_t, kSteps + 1> levels_;
};

/// Writes PNGs of 8 bits.
class PngWriter : PngErrors {
  public:
    explicit PngWriter(AtomicFile& file) : file_(file) {
        keep("libpng cannot be started");
        png_ = png_create_write_struct(PNG_LIBPNG_VER_STRING, static_cast<PngErrors*>(this), onError, onWarning);
        if (png_) info_ = png_create_info_struct(png_);
    }
    ~PngWriter() { png_destroy_write_struct(&png_, &info_); }
    PngWriter(const PngWriter&) = delete;
    PngWriter& operator=(const PngWriter&) = delete;

    /// `channels`: 3, or 4 with alpha. False, and then whyNot() tells, where libpng cannot.
    bool write(int width, int height, int channels, const std::uint8_t* bytes) {
        if (!info_) return false;
        if (setjmp(png_jmpbuf(png_))) return false;
        png_set_write_fn(png_, &file_, onWrite, onFlush);
        png_set_user_limits(png_, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
        png_set_IHDR(png_, info_, png_uint_32(width), png_uint_32(height), 8,
                     channels == 4 ? PNG_COLOR_TYPE_RGB_ALPHA : PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                     PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        png_set_filter(png_, PNG_FILTER_TYPE_BASE, kFilters);
        png_set_compression_level(png_, kDeflateLevel);
        png_set_compression_buffer_size(png_, kChunkBytes);
        png_write_info(png_, info_);
        for (int y = 0; y < height; ++y) png_write_row(png_, bytes + std::size_t(y) * std::size_t(width * channels));
        png_write_end(png_, info_);
        return true;
    }
    const char* whyNot() const { return message.data(); }

  private:
    static void onWarning(png_structp, png_const_charp) {}
    /// The file keeps its own failures for commit() to tell.
    static void onWrite(png_structp png, png_bytep bytes, std::size_t count) {
        static_cast<AtomicFile*>(png_get_io_ptr(png))->write(bytes, count);
    }
    static void onFlush(png_structp) {}

    AtomicFile& file_;
    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
};

/// The bytes of the picture's pixels: R, G, B, and A if it has one.
std::vector<std::uint8_t> encoded(const Image& image, const Tone& tone) {
    const Channel* alpha = image.find("A");
    const std::size_t channels = alpha ? 4 : 3;
    std::vector<std::uint8_t> bytes(channels * image.pixelCount());
    const double gain = std::exp2(tone.exposure);
    static const SrgbLevels levels;
    const char* const names[] = {"R", "G", "B"};
    for (std::size_t c = 0; c < 3; ++c) {
        const std::vector<float>& plane = image.at(names[c]).floats();
        const std::size_t width = std::size_t(image.data.width());
        parallelFor(std::size_t(image.data.height()), [&](std::size_t row) {
            for (std::size_t k = row * width; k < (row + 1) * width; ++k) {
                const double cover = alpha ? double(alpha->floats()[k]) : 1.0;
                const double light = cover > 0.0 ? double(plane[k]) / cover : 0.0;
                bytes[channels * k + c] = levels.of(toneMapped(tone.curve, gain * light));
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
            "{}: {}x{} pixels of {} channels are more than a PNG is packed from in memory ({} bytes); write an .exr",
            path.string(), width, height, channels, kMaxBytes);
}

void writePng(const std::filesystem::path& path, const Image& image, const Tone& tone) {
    const int width = image.data.width(), height = image.data.height();
    const int channels = image.find("A") ? 4 : 3;
    checkPngSize(path, width, height, channels);
    AtomicFile file(path);
    const std::vector<std::uint8_t> bytes = encoded(image, tone);
    PngWriter writer(file);
    if (!writer.write(width, height, channels, bytes.data()))
        throwFailure("{}: cannot be written: {}", path.string(), writer.whyNot());
    file.commit();
}

}  // namespace dsphere
