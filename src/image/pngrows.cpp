#include "image/pngrows.h"

#include <array>
#include <cstring>
#include <string>
#include <string_view>

#include "base/error.h"
#include "image/codecs.h"
#include "image/pngerrors.h"

namespace dsphere {
namespace {

constexpr std::size_t kSignatureBytes = 8, kHeaderBytes = 25;  // IHDR with its length, name and checksum
// Deflate packs at most 258 bytes in 2 bits.
constexpr std::uint64_t kMaxDeflateRatio = 1032;

/// Throws unless the file begins with a signature and an IHDR whose size is sane and which the file can hold. libpng
/// would say so too, but without the figures.
void checkStart(InputFile& file) {
    std::array<std::uint8_t, kSignatureBytes + kHeaderBytes> bytes;
    if (file.size() < bytes.size()) file.invalid("PNG: truncated: the file has {} bytes", file.size());
    file.rewind();
    file.read(bytes.data(), bytes.size());
    file.rewind();
    if (png_sig_cmp(bytes.data(), 0, kSignatureBytes) != 0) file.invalid("PNG: the signature is damaged");
    const std::uint8_t* header = &bytes[kSignatureBytes];
    if (load32(header) != 13 || std::memcmp(header + 4, "IHDR", 4) != 0)
        file.invalid("PNG: the first chunk is {:?} of {} bytes, expected IHDR of 13",
                     std::string(reinterpret_cast<const char*>(header + 4), 4), load32(header));
    const std::uint64_t width = load32(header + 8), height = load32(header + 12), depth = header[16];
    checkSize(file, "PNG", std::int64_t(width), std::int64_t(height));
    const std::uint64_t least = width * height * depth / 8;  // of one channel
    if (least / kMaxDeflateRatio > file.size())
        file.invalid("PNG: {}x{} texels of {} bits are {} bytes, which a file of {} bytes cannot hold", width, height,
                     depth, least, file.size());
}

}  // namespace

/// Each step returns false on failure, and then `message` says why.
struct PngRows::Decoder : PngErrors {
    InputFile& file;
    png_structp png = nullptr;
    png_infop info = nullptr;
    int depth = 8;  ///< as stored: libpng unpacks samples of fewer than 8 bits
    int passes = 1;
    std::vector<Entry> palette;
    std::vector<std::uint16_t> transparent;

    explicit Decoder(InputFile& input) : file(input) {
        png = png_create_read_struct(PNG_LIBPNG_VER_STRING, static_cast<PngErrors*>(this), onError, onWarning);
        if (png) info = png_create_info_struct(png);
    }
    ~Decoder() { png_destroy_read_struct(&png, &info, nullptr); }
    Decoder(const Decoder&) = delete;
    Decoder& operator=(const Decoder&) = delete;

    /// Nothing that only warns changes a texel, but for a damaged chunk of transparency, which libpng would skip.
    static void onWarning(png_structp png, png_const_charp text) {
        if (std::string_view(text).starts_with("tRNS:")) onError(png, text);
    }
    static void onRead(png_structp png, png_bytep to, std::size_t count) {
        auto& decoder = *static_cast<Decoder*>(png_get_io_ptr(png));
        if (decoder.file.remaining() < count) png_error(png, "truncated: the file ends before the chunk IEND");
        if (!decoder.readBytes(to, count)) png_longjmp(png, 1);
    }
    /// No exception may pass through libpng.
    bool readBytes(png_bytep to, std::size_t count) {
        try {
            file.read(to, count);
            return true;
        } catch (const std::exception& error) {
            keep(error.what());
            return false;
        }
    }

    bool start() {
        if (setjmp(png_jmpbuf(png))) return false;
        png_set_read_fn(png, this, onRead);
        png_set_crc_action(png, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
        png_set_user_limits(png, png_uint_32(kMaxSide), png_uint_32(kMaxSide));
        // Maps are data: colour spaces, gamma and texts are skipped.
        png_set_keep_unknown_chunks(png, PNG_HANDLE_CHUNK_NEVER, nullptr, -1);
        png_read_info(png, info);
        depth = png_get_bit_depth(png, info);
        png_set_packing(png);
        passes = png_set_interlace_handling(png);
        png_read_update_info(png, info);
        return true;
    }
    bool readRow(png_bytep row) {
        if (setjmp(png_jmpbuf(png))) return false;
        png_read_row(png, row, nullptr);
        return true;
    }
    bool finish() {
        if (setjmp(png_jmpbuf(png))) return false;
        png_read_end(png, nullptr);
        return true;
    }

    /// Only valid after start, like everything that follows.
    void takePalette() {
        png_colorp colours = nullptr;
        int count = 0, alphas = 0;
        png_bytep alpha = nullptr;
        if (!png_get_PLTE(png, info, &colours, &count)) return;
        png_get_tRNS(png, info, &alpha, &alphas, nullptr);
        for (int k = 0; k < count; ++k)
            palette.push_back({colours[k].red, colours[k].green, colours[k].blue,
                               alpha && k < alphas ? alpha[k] : std::uint8_t(255)});
    }
    void takeTransparent() {
        png_color_16p key = nullptr;
        if (!png_get_tRNS(png, info, nullptr, nullptr, &key) || !key) return;
        const auto mask = std::uint16_t((1u << depth) - 1u);  // other bits mean nothing
        if (png_get_color_type(png, info) == PNG_COLOR_TYPE_GRAY)
            transparent = {key->gray};
        else
            transparent = {key->red, key->green, key->blue};
        for (std::uint16_t& sample : transparent) sample &= mask;
    }
};

PngRows::PngRows(InputFile& file) : file_(file) {
    checkStart(file);
    decoder_ = std::make_unique<Decoder>(file);
    if (!decoder_->info) throwFailure("{}: libpng cannot be started", file.name());
    if (!decoder_->start()) file.invalid("PNG: cannot be decoded: {}", decoder_->message.data());
    if (colour() == Colour::Palette)
        decoder_->takePalette();
    else
        decoder_->takeTransparent();
}

PngRows::~PngRows() = default;

int PngRows::width() const {
    return int(png_get_image_width(decoder_->png, decoder_->info));
}

int PngRows::height() const {
    return int(png_get_image_height(decoder_->png, decoder_->info));
}

int PngRows::depth() const {
    return decoder_->depth;
}

PngRows::Colour PngRows::colour() const {
    switch (png_get_color_type(decoder_->png, decoder_->info)) {
        case PNG_COLOR_TYPE_RGB:
            return Colour::Rgb;
        case PNG_COLOR_TYPE_PALETTE:
            return Colour::Palette;
        case PNG_COLOR_TYPE_GRAY_ALPHA:
            return Colour::GreyAlpha;
        case PNG_COLOR_TYPE_RGB_ALPHA:
            return Colour::Rgba;
        default:
            return Colour::Grey;
    }
}

int PngRows::channels() const {
    return png_get_channels(decoder_->png, decoder_->info);
}

const std::vector<PngRows::Entry>& PngRows::palette() const {
    return decoder_->palette;
}

const std::vector<std::uint16_t>& PngRows::transparent() const {
    return decoder_->transparent;
}

void PngRows::read(const Use& use) {
    const auto require = [&](bool done, const std::string& what) {
        if (!done) file_.invalid("PNG: {} cannot be decoded: {}", what, decoder_->message.data());
    };
    const bool interlaced = decoder_->passes > 1;
    const std::size_t row_bytes = png_get_rowbytes(decoder_->png, decoder_->info);
    std::vector<std::uint8_t> rows(row_bytes * (interlaced ? std::size_t(height()) : 1));
    const auto rowAt = [&](int j) { return &rows[interlaced ? row_bytes * std::size_t(j) : 0]; };
    for (int pass = 1; pass < decoder_->passes; ++pass)
        for (int j = 0; j < height(); ++j)
            require(decoder_->readRow(rowAt(j)), fmt::format("pass {} of row {}", pass, j));
    std::vector<std::uint16_t> samples(std::size_t(width()) * std::size_t(channels()));
    for (int j = 0; j < height(); ++j) {
        const std::uint8_t* row = rowAt(j);
        require(decoder_->readRow(rowAt(j)), fmt::format("row {}", j));
        for (std::size_t k = 0; k < samples.size(); ++k) samples[k] = depth() == 16 ? load16(row + 2 * k) : row[k];
        use(j, samples);
    }
    require(decoder_->finish(), "what follows the last row");
}

}  // namespace dsphere
