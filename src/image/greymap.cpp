#include "image/greymap.h"

#include <png.h>
#include <tiffio.h>

#include <algorithm>
#include <csetjmp>
#include <memory>
#include <string>
#include <vector>

#include "base/atomicfile.h"
#include "base/error.h"
#include "base/parallel.h"
#include "image/picture.h"

namespace dsphere {
namespace {

enum class Format { Unknown, Png, Pgm, Tiff };

Format formatOf(const std::filesystem::path& path) {
    const std::string extension = extensionOf(path);
    if (extension == ".png") return Format::Png;
    if (extension == ".pgm") return Format::Pgm;
    return extension == ".tif" || extension == ".tiff" ? Format::Tiff : Format::Unknown;
}

using Row = std::span<const std::uint16_t>;

/// The bytes of the row, the high one of each sample first.
void toBigEndian(Row row, std::vector<std::uint8_t>& bytes) {
    bytes.resize(2 * row.size());
    for (std::size_t i = 0; i < row.size(); ++i) {
        bytes[2 * i] = std::uint8_t(row[i] >> 8);
        bytes[2 * i + 1] = std::uint8_t(row[i]);
    }
}

class PgmWriter {
  public:
    PgmWriter(AtomicFile& file, int width, int height) : file_(file) {
        const std::string header = fmt::format("P5\n{} {}\n65535\n", width, height);
        file_.write(header.data(), header.size());
    }
    void write(Row row) {
        toBigEndian(row, bytes_);
        file_.write(bytes_.data(), bytes_.size());
    }
    void finish() {}

  private:
    AtomicFile& file_;
    std::vector<std::uint8_t> bytes_;
};

/// libpng reports errors by longjmp: no function that sets a jump holds objects that need destruction.
class PngWriter {
  public:
    PngWriter(AtomicFile& file, int width, int height) {
        png_ = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, ignoreWarning);
        if (png_) info_ = png_create_info_struct(png_);
        if (!info_ || !begin(file, width, height)) fail();
    }
    ~PngWriter() { png_destroy_write_struct(&png_, &info_); }
    PngWriter(const PngWriter&) = delete;
    PngWriter& operator=(const PngWriter&) = delete;

    void write(Row row) {
        toBigEndian(row, bytes_);
        if (!writeRow(bytes_.data())) fail();
    }
    void finish() {
        if (!end()) fail();
    }

  private:
    static void ignoreWarning(png_structp, png_const_charp) {}
    static void toFile(png_structp png, png_bytep data, std::size_t count) {
        static_cast<AtomicFile*>(png_get_io_ptr(png))->write(data, count);
    }
    static void flush(png_structp) {}
    [[noreturn]] static void fail() { throwFailure("libpng cannot write the map: out of memory"); }

    bool begin(AtomicFile& file, int width, int height) {
        if (setjmp(png_jmpbuf(png_))) return false;
        png_set_write_fn(png_, &file, toFile, flush);
        png_set_user_limits(png_, 1u << 20, 1u << 20);
        png_set_IHDR(png_, info_, png_uint_32(width), png_uint_32(height), 16, PNG_COLOR_TYPE_GRAY, PNG_INTERLACE_NONE,
                     PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
        png_write_info(png_, info_);
        return true;
    }
    bool writeRow(const std::uint8_t* bytes) {
        if (setjmp(png_jmpbuf(png_))) return false;
        png_write_row(png_, bytes);
        return true;
    }
    bool end() {
        if (setjmp(png_jmpbuf(png_))) return false;
        png_write_end(png_, info_);
        return true;
    }

    png_structp png_ = nullptr;
    png_infop info_ = nullptr;
    std::vector<std::uint8_t> bytes_;
};

/// Strips of about 256 KiB, deflated with the horizontal predictor; BigTIFF when the samples fill 2 GiB or more.
class TiffWriter {
  public:
    TiffWriter(AtomicFile& file, int width, int height) : target_{file} {
        const bool big = std::uint64_t(width) * std::uint64_t(height) >= std::uint64_t(1) << 30;
        tiff_.reset(TIFFClientOpen("map", big ? "w8" : "w", &target_, readNothing, toFile, seek, close, size, nullptr,
                                   nullptr));
        if (!tiff_) fail();
        const std::uint32_t rows = std::uint32_t(std::clamp((1 << 17) / width, 1, height));
        set(TIFFTAG_IMAGEWIDTH, std::uint32_t(width));
        set(TIFFTAG_IMAGELENGTH, std::uint32_t(height));
        set(TIFFTAG_BITSPERSAMPLE, 16);
        set(TIFFTAG_SAMPLESPERPIXEL, 1);
        set(TIFFTAG_SAMPLEFORMAT, SAMPLEFORMAT_UINT);
        set(TIFFTAG_PHOTOMETRIC, PHOTOMETRIC_MINISBLACK);
        set(TIFFTAG_PLANARCONFIG, PLANARCONFIG_CONTIG);
        set(TIFFTAG_COMPRESSION, COMPRESSION_ADOBE_DEFLATE);
        set(TIFFTAG_PREDICTOR, PREDICTOR_HORIZONTAL);
        set(TIFFTAG_ROWSPERSTRIP, rows);
    }
    void write(Row row) {
        samples_.assign(row.begin(), row.end());  // the predictor works in place
        if (TIFFWriteScanline(tiff_.get(), samples_.data(), next_++, 0) < 0) fail();
    }
    void finish() {
        if (!TIFFFlush(tiff_.get())) fail();
    }

  private:
    struct Target {
        AtomicFile& file;
        std::uint64_t size = 0;
    };
    struct Close {
        void operator()(TIFF* tiff) const { TIFFClose(tiff); }
    };

    static tmsize_t readNothing(thandle_t, void*, tmsize_t) { return 0; }
    static tmsize_t toFile(thandle_t handle, void* data, tmsize_t count) {
        Target& target = *static_cast<Target*>(handle);
        target.file.write(data, std::size_t(count));
        target.size = std::max(target.size, target.file.tell());
        return count;
    }
    static toff_t seek(thandle_t handle, toff_t offset, int whence) {
        Target& target = *static_cast<Target*>(handle);
        const std::uint64_t from = whence == SEEK_SET ? 0 : whence == SEEK_CUR ? target.file.tell() : target.size;
        target.file.seek(from + offset);
        return target.file.tell();
    }
    static int close(thandle_t) { return 0; }
    static toff_t size(thandle_t handle) { return static_cast<Target*>(handle)->size; }
    [[noreturn]] static void fail() { throwFailure("libtiff cannot write the map: out of memory"); }

    template <typename T>
    void set(std::uint32_t tag, T value) {
        if (!TIFFSetField(tiff_.get(), tag, value)) fail();
    }

    Target target_;
    std::unique_ptr<TIFF, Close> tiff_;
    std::vector<std::uint16_t> samples_;
    std::uint32_t next_ = 0;
};

/// Blocks of rows are made by all cores, then packed by this thread.
template <typename Writer>
void writeRows(AtomicFile& file, int width, int height, const RowSource& source,
               const std::function<bool(double)>& progress) {
    constexpr int kBlockRows = 32;
    Writer writer(file, width, height);
    const std::size_t row_samples = std::size_t(width);
    std::vector<std::uint16_t> block(row_samples * std::size_t(std::min(kBlockRows, height)));
    const auto rowOf = [&](std::size_t k) { return std::span(block).subspan(k * row_samples, row_samples); };
    for (int top = 0; top < height; top += kBlockRows) {
        const std::size_t rows = std::size_t(std::min(kBlockRows, height - top));
        parallelFor(rows, [&](std::size_t k) { source(top + int(k), rowOf(k)); });
        for (std::size_t k = 0; k < rows; ++k) writer.write(rowOf(k));
        if (!progress(double(top + int(rows)) / height)) throw Error(ExitCode::Interrupted, "interrupted");
    }
    writer.finish();
}

}  // namespace

void checkGreyMapName(const std::filesystem::path& path) {
    if (formatOf(path) == Format::Unknown)
        throw Error(ExitCode::Usage, fmt::format("{}: the extension is '{}', expected .png, .pgm, .tif or .tiff",
                                                 path.string(), path.extension().string()));
}

void writeGreyMap(const std::filesystem::path& path, int width, int height, const RowSource& source,
                  const std::function<bool(double)>& progress) {
    checkGreyMapName(path);
    AtomicFile file(path);
    switch (formatOf(path)) {
        case Format::Png:
            writeRows<PngWriter>(file, width, height, source, progress);
            break;
        case Format::Tiff:
            writeRows<TiffWriter>(file, width, height, source, progress);
            break;
        default:
            writeRows<PgmWriter>(file, width, height, source, progress);
    }
    file.commit();
}

}  // namespace dsphere
