#include <algorithm>
#include <optional>

#include "image/codecs.h"
#include "image/coloursink.h"
#include "image/geoidcomments.h"
#include "image/netpbm.h"

// PGM and PPM as netpbm's own pages describe them: sizes and maxval in text, then rows from the top, plain numbers
// (P2 P3) or bytes (P5 P6), two of them, the high one first, when maxval is over 255.

namespace dsphere {
namespace {

struct Header {
    std::string type;      ///< "16-bit PGM"
    std::string comments;  ///< those of the header, a line each
    bool plain = false;
    int channels = 1, sample_bytes = 1;
    int width = 0, height = 0, maxval = 0;

    std::size_t rowSamples() const { return std::size_t(width) * std::size_t(channels); }
    std::uint64_t samples() const { return std::uint64_t(rowSamples()) * std::uint64_t(height); }
};

Header readHeader(InputFile& file) {
    Header header;
    const std::string magic = readWord(file, "P2, P3, P5 or P6", &header.comments);
    if (magic != "P2" && magic != "P3" && magic != "P5" && magic != "P6")
        file.invalid("found {:?}, expected P2, P3, P5 or P6", magic);
    header.plain = magic < "P5";
    header.channels = magic == "P3" || magic == "P6" ? 3 : 1;
    const std::string format = header.channels == 3 ? "PPM" : "PGM";
    const std::int64_t width = readNumber(file, "the width of a " + format, &header.comments);
    const std::int64_t height = readNumber(file, "the height of a " + format, &header.comments);
    checkSize(file, format, width, height);
    const std::int64_t maxval = readNumber(file, "the maxval of a " + format, &header.comments);
    if (maxval < 1 || maxval > 65535) file.invalid("{}: maxval is {}, expected 1 to 65535", format, maxval);
    header.width = int(width);
    header.height = int(height);
    header.maxval = int(maxval);
    header.sample_bytes = maxval > 255 ? 2 : 1;
    header.type = fmt::format("{}-bit {}", 8 * header.sample_bytes, format);
    return header;
}

/// One row of plain or binary samples, not yet averaged; `bytes` is working space.
void readRow(InputFile& file, const Header& header, std::vector<std::uint8_t>& bytes, std::vector<int>& row) {
    if (header.plain) {
        for (int& sample : row) {
            const std::int64_t number = readNumber(file, "a sample");
            sample = int(std::min<std::int64_t>(number, header.maxval + 1));
        }
        return;
    }
    file.read(bytes.data(), bytes.size());
    for (std::size_t k = 0; k < row.size(); ++k) row[k] = header.sample_bytes == 2 ? load16(&bytes[2 * k]) : bytes[k];
}

/// Calls `use(j, row)` for every row of samples, the channels of a texel together.
template <typename Use>
void readRows(InputFile& file, const Header& header, Use use) {
    // A plain sample takes a digit, and white space between it and the next.
    const std::uint64_t needed =
        header.plain ? 2 * header.samples() - 1 : header.samples() * std::uint64_t(header.sample_bytes);
    checkLength(file, fmt::format("{} of {}x{} texels", header.type, header.width, header.height), needed);
    std::vector<int> row(header.rowSamples());
    std::vector<std::uint8_t> bytes(header.plain ? 0 : row.size() * std::size_t(header.sample_bytes));
    for (int j = 0; j < header.height; ++j) {
        readRow(file, header, bytes, row);
        const auto over = std::ranges::find_if(row, [&](int sample) { return sample > header.maxval; });
        if (over != row.end())
            file.invalid("{}: the sample at column {}, row {} is over the maxval of {}", header.type,
                         (over - row.begin()) / header.channels, j, header.maxval);
        use(j, row);
    }
}

}  // namespace

RawMap readPnm(InputFile& file) {
    const Header header = readHeader(file);
    RawMap map;
    map.width = header.width;
    map.height = header.height;
    map.full_scale = header.maxval;
    map.type = header.type;
    ColourCensus colours;
    readRows(file, header, [&](int j, const std::vector<int>& row) {
        if (j == 0) map.samples.reserve(std::size_t(header.width) * std::size_t(header.height));
        if (header.channels == 1) {
            map.samples.insert(map.samples.end(), row.begin(), row.end());
            return;
        }
        colours.startRow();
        for (std::size_t k = 0; k < row.size(); k += 3)
            map.samples.push_back(colours.grey(float(row[k]), float(row[k + 1]), float(row[k + 2])));
    });
    colours.report(map, file.name());
    applyGeoidComments(header.comments, map, file.name());
    return map;
}

RawColour readPnmColour(InputFile& file) {
    const Header header = readHeader(file);
    std::optional<ColourSink> sink;  // made when the file's length has been checked
    std::vector<float> values(header.rowSamples());
    readRows(file, header, [&](int j, const std::vector<int>& row) {
        if (!sink) sink.emplace(header.width, header.height, ColourCode{double(header.maxval)}, header.type);
        std::ranges::copy(row, values.begin());
        sink->put(std::size_t(j) * std::size_t(header.width), std::size_t(header.width), values.data(),
                  header.channels);
    });
    return sink->take();
}

}  // namespace dsphere
