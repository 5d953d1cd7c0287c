#include <charconv>
#include <cmath>

#include "image/codecs.h"
#include "image/netpbm.h"

// PFM: "Pf" (grey) or "PF" (colour), width, height and a scale in text, then float32 rows from the bottom. The scale's
// sign tells the byte order, negative for little endian; its size is a unit that readers leave alone.

namespace dsphere {
namespace {

std::endian readByteOrder(InputFile& file) {
    const std::string word = readWord(file, "the scale of a PFM");
    const char* begin = word.data() + (word[0] == '+' ? 1 : 0);
    const char* end = word.data() + word.size();
    double scale = 0.0;
    const auto [stop, error] = std::from_chars(begin, end, scale);
    if (error != std::errc() || stop != end || !std::isfinite(scale) || scale == 0.0)
        file.invalid("PFM: the scale is {:?}, expected a number other than 0, negative for little-endian data", word);
    return scale < 0.0 ? std::endian::little : std::endian::big;
}

}  // namespace

RawMap readPfm(InputFile& file) {
    const std::string magic = readWord(file, "Pf or PF");
    if (magic != "Pf" && magic != "PF") file.invalid("found {:?}, expected Pf or PF", magic);
    const std::size_t channels = magic == "PF" ? 3 : 1;
    const std::int64_t width = readNumber(file, "the width of a PFM");
    const std::int64_t height = readNumber(file, "the height of a PFM");
    checkSize(file, "PFM", width, height);
    const std::endian order = readByteOrder(file);

    RawMap map;
    map.width = int(width);
    map.height = int(height);
    map.type = channels == 3 ? "float32 colour PFM" : "float32 PFM";
    const std::size_t row_bytes = std::size_t(width) * channels * 4;
    checkLength(file, fmt::format("{} of {}x{} texels", map.type, width, height),
                std::uint64_t(row_bytes) * std::uint64_t(height));

    map.samples.resize(std::size_t(width) * std::size_t(height));
    std::vector<std::uint8_t> row(row_bytes);
    for (std::size_t j = std::size_t(height); j-- > 0;) {
        file.read(row.data(), row.size());
        float* out = &map.samples[j * std::size_t(width)];
        for (std::size_t k = 0; k < row_bytes; k += 4 * channels, ++out) {
            const float first = loadFloat(&row[k], order);
            *out = channels == 1 ? first : meanOf(first, loadFloat(&row[k + 4], order), loadFloat(&row[k + 8], order));
        }
    }
    return map;
}

}  // namespace dsphere
