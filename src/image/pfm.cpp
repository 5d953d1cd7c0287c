#include <charconv>
#include <cmath>

#include "image/codecs.h"
#include "image/coloursink.h"
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

struct Header {
    int width = 0, height = 0, channels = 1;
    std::endian order = std::endian::big;

    const char* type() const { return channels == 3 ? "float32 colour PFM" : "float32 PFM"; }
};

Header readHeader(InputFile& file) {
    const std::string magic = readWord(file, "Pf or PF");
    if (magic != "Pf" && magic != "PF") file.invalid("found {:?}, expected Pf or PF", magic);
    const std::int64_t width = readNumber(file, "the width of a PFM");
    const std::int64_t height = readNumber(file, "the height of a PFM");
    checkSize(file, "PFM", width, height);
    const Header header{int(width), int(height), magic == "PF" ? 3 : 1, readByteOrder(file)};
    checkLength(file, fmt::format("{} of {}x{} texels", header.type(), width, height),
                std::uint64_t(width) * std::uint64_t(height) * std::uint64_t(header.channels) * 4);
    return header;
}

/// Calls `use(first, values)` for every row: its first texel's index, and its values, a texel's channels together.
template <typename Use>
void readRows(InputFile& file, const Header& header, Use use) {
    std::vector<float> values(std::size_t(header.width) * std::size_t(header.channels));
    std::vector<std::uint8_t> bytes(4 * values.size());
    for (std::size_t j = std::size_t(header.height); j-- > 0;) {
        file.read(bytes.data(), bytes.size());
        for (std::size_t k = 0; k < values.size(); ++k) values[k] = loadFloat(&bytes[4 * k], header.order);
        use(j * std::size_t(header.width), values);
    }
}

}  // namespace

RawMap readPfm(InputFile& file) {
    const Header header = readHeader(file);
    RawMap map;
    map.width = header.width;
    map.height = header.height;
    map.type = header.type();
    map.samples.resize(std::size_t(map.width) * std::size_t(map.height));
    ColourCensus colours;
    readRows(file, header, [&](std::size_t first, const std::vector<float>& values) {
        colours.startRow();
        float* out = &map.samples[first];
        for (std::size_t k = 0; k < values.size(); k += std::size_t(header.channels), ++out)
            *out = header.channels == 1 ? values[k] : colours.grey(values[k], values[k + 1], values[k + 2]);
    });
    colours.report(map, file.name());
    return map;
}

RawColour readPfmColour(InputFile& file) {
    const Header header = readHeader(file);
    ColourSink sink(header.width, header.height, {1.0, false}, header.type());
    readRows(file, header, [&](std::size_t first, const std::vector<float>& values) {
        sink.put(first, std::size_t(header.width), values.data(), header.channels);
    });
    return sink.take();
}

}  // namespace dsphere
