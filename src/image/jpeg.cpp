#include <csetjmp>
#include <cstdio>

#include "image/codecs.h"

#include <jpeglib.h>  // after cstdio, whose types it uses

// libjpeg reports errors by longjmp: no function that sets a jump holds objects that need destruction. Its warnings are
// of damaged and truncated data, which it would paint over; here they are errors.

namespace dsphere {
namespace {

// A block of 8x8 texels takes at least a bit in every Huffman-coded scan.
constexpr std::uint64_t kTexelsPerByte = 512;

struct Errors {
    jpeg_error_mgr base;
    std::jmp_buf jump;
    char message[JMSG_LENGTH_MAX] = "unknown reason";
};

[[noreturn]] void leave(j_common_ptr jpeg) {
    Errors& errors = *reinterpret_cast<Errors*>(jpeg->err);
    errors.base.format_message(jpeg, errors.message);
    std::longjmp(errors.jump, 1);
}

void onMessage(j_common_ptr jpeg, int level) {
    if (level < 0) leave(jpeg);  // a warning; others are traces
}

/// Each step returns false on failure, and then says why.
class Decoder {
  public:
    Decoder() {
        jpeg_.err = jpeg_std_error(&errors_.base);
        errors_.base.error_exit = leave;
        errors_.base.emit_message = onMessage;
    }
    ~Decoder() { jpeg_destroy_decompress(&jpeg_); }
    Decoder(const Decoder&) = delete;
    Decoder& operator=(const Decoder&) = delete;

    bool readHeader(const std::uint8_t* bytes, std::size_t count) {
        if (setjmp(errors_.jump)) return false;
        jpeg_create_decompress(&jpeg_);
        jpeg_mem_src(&jpeg_, bytes, count);
        jpeg_read_header(&jpeg_, TRUE);
        return true;
    }
    bool start() {
        if (setjmp(errors_.jump)) return false;
        jpeg_.out_color_space = JCS_RGB;
        jpeg_start_decompress(&jpeg_);
        return true;
    }
    bool readRow(std::uint8_t* row) {
        if (setjmp(errors_.jump)) return false;
        jpeg_read_scanlines(&jpeg_, &row, 1);
        return true;
    }
    /// Reads on to the end-of-image marker, which a truncated file lacks.
    bool finish() {
        if (setjmp(errors_.jump)) return false;
        jpeg_finish_decompress(&jpeg_);
        return true;
    }

    int width() const { return int(jpeg_.image_width); }
    int height() const { return int(jpeg_.image_height); }
    bool hasColours() const { return jpeg_.jpeg_color_space != JCS_CMYK && jpeg_.jpeg_color_space != JCS_YCCK; }
    bool arithmetic() const { return jpeg_.arith_code != 0; }
    const char* message() const { return errors_.message; }

  private:
    jpeg_decompress_struct jpeg_{};
    Errors errors_{};
};

void checkHeader(const InputFile& file, const Decoder& decoder) {
    checkSize(file, "JPEG", decoder.width(), decoder.height());
    if (!decoder.hasColours()) file.invalid("JPEG: its colours are CMYK, expected grey or RGB");
    if (decoder.arithmetic()) file.invalid("JPEG: its coding is arithmetic, expected Huffman's");
    const std::uint64_t texels = std::uint64_t(decoder.width()) * std::uint64_t(decoder.height());
    if (texels / kTexelsPerByte > file.size())
        file.invalid("JPEG: {}x{} texels cannot lie in a file of {} bytes", decoder.width(), decoder.height(),
                     file.size());
}

}  // namespace

RawColour readJpegColour(InputFile& file) {
    std::vector<std::uint8_t> bytes(file.remaining());
    file.read(bytes.data(), bytes.size());
    Decoder decoder;
    const auto require = [&](bool done) {
        if (!done) file.invalid("JPEG: truncated or damaged: {}", decoder.message());
    };
    require(decoder.readHeader(bytes.data(), bytes.size()));
    checkHeader(file, decoder);
    RawColour image;
    image.width = decoder.width();
    image.height = decoder.height();
    image.type = "8-bit JPEG";
    const std::size_t row = 3 * std::size_t(image.width);
    image.srgb.resize(row * std::size_t(image.height));
    require(decoder.start());
    for (int j = 0; j < image.height; ++j) require(decoder.readRow(&image.srgb[std::size_t(j) * row]));
    require(decoder.finish());
    return image;
}

}  // namespace dsphere
