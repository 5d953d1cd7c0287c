#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "geo/gdalhead.h"
#include "geo/readmap.h"
#include "image/codecs.h"
#include "image/mapchannels.h"

namespace dsphere::geo {
namespace {

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

/// Reads rows of the bands as they lie in the file.
class RowReader {
  public:
    RowReader(const OpenMap& map, const std::vector<int>& bands) : map_(map) {
        for (const int number : bands) {
            GDALRasterBandH band = gdal().GDALGetRasterBand(map.dataset.get(), number);
            if (gdal().GDALGetRasterColorTable(band))
                throwInvalid("{}: {}: it has a palette, expected values", map.name(), nameOf(map.file.format));
            bands_.push_back({band, sampleTypeOf(map, band), {}});
            bands_.back().unknown = unknownOf(map, band, bands_.back().sample);
        }
        row_.resize(std::size_t(map.width()));
        mask_.resize(row_.size());
    }

    std::size_t rounded() const { return rounded_; }
    double greatestRounding() const { return greatest_rounding_; }
    bool ofColours() const { return bands_.size() == 3; }
    const ColourCensus& colours() const { return census_; }
    void forgetCounts() {
        rounded_ = 0;
        greatest_rounding_ = 0.0;
        census_ = {};
    }

    /// NaN where unknown.
    void read(int row, float* to) {
        if (bands_.size() == 1) return readBand(bands_[0], row, to);
        std::array<std::vector<float>, 3> colours;
        for (std::size_t c = 0; c < 3; ++c) {
            colours[c].resize(row_.size());
            readBand(bands_[c], row, colours[c].data());
        }
        census_.startRow();
        for (std::size_t i = 0; i < row_.size(); ++i) to[i] = census_.grey(colours[0][i], colours[1][i], colours[2][i]);
    }

  private:
    struct Band {
        GDALRasterBandH band;
        SampleType sample;
        Unknown unknown;
    };

    void fetch(GDALRasterBandH band, int row, void* to, GDALDataType type) {
        GdalMessages messages;
        const int width = map_.width();
        if (gdal().GDALRasterIO(band, GF_Read, 0, row, width, 1, to, width, 1, type, 0, 0) != CE_None)
            throwInvalid("{}: {}: row {} cannot be read: {}", map_.name(), nameOf(map_.file.format), row,
                         messages.reason());
    }

    void readBand(const Band& band, int row, float* to) {
        fetch(band.band, row, row_.data(), GDT_Float64);
        if (band.unknown.mask) fetch(band.unknown.mask, row, mask_.data(), GDT_Byte);
        for (std::size_t i = 0; i < row_.size(); ++i) {
            double stored = row_[i];
            if (band.sample.signed_bytes && stored > 127.0) stored -= 256.0;
            const bool unknown = band.unknown.is(stored) || (band.unknown.mask && mask_[i] == 0);
            to[i] = unknown ? kUnknown : float(stored);
            if (band.sample.isExact() || unknown || double(to[i]) == stored) continue;
            ++rounded_;
            greatest_rounding_ = std::max(greatest_rounding_, std::abs(double(to[i]) - stored));
        }
    }

    const OpenMap& map_;
    std::vector<Band> bands_;
    std::vector<double> row_;
    std::vector<std::uint8_t> mask_;
    std::size_t rounded_ = 0;
    double greatest_rounding_ = 0.0;
    ColourCensus census_;
};

/// A file that is cut short is refused before there is memory for all that its header promises.
void checkIsWhole(const OpenMap& map, RowReader& reader) {
    const auto texels = std::uint64_t(map.width()) * std::uint64_t(map.height());
    if (map.file.format == PlacedFile::Format::AsciiGrid) {
        // Not by its last row: GDAL looks for the rows before it again and again where one is missing.
        const InputFile file(map.file.path);
        if (texels > file.size())
            file.invalid("ASCII grid: truncated: {}x{} numbers do not fit into {} bytes", map.width(), map.height(),
                         file.size());
        return;
    }
    std::vector<float> row(std::size_t(map.width()));
    reader.read(map.height() - 1, row.data());
    reader.forgetCounts();
}

void readSamples(RowReader& reader, int file_width, int file_height, const Placement& placed, RawMap& map) {
    std::vector<float> row(std::size_t(file_width), 0.0f);
    map.samples.assign(std::size_t(map.width) * std::size_t(map.height), kUnknown);
    for (int j = 0; j < file_height; ++j) {
        reader.read(j, row.data());
        if (placed.mirrored) std::reverse(row.begin(), row.begin() + placed.columns);
        const int to = placed.rows_above + (placed.flipped ? file_height - 1 - j : j);
        std::copy_n(row.begin(), placed.columns, map.samples.begin() + std::ptrdiff_t(to) * placed.columns);
    }
}

double greatestOf(const std::vector<float>& samples) {
    double greatest = 0.0;
    for (const float stored : samples)
        if (std::isfinite(stored)) greatest = std::max(greatest, std::abs(double(stored)));
    return greatest;
}

void addNotices(const OpenMap& file, const RowReader& reader, RawMap& map) {
    if (reader.rounded() > 0)
        map.notices.push_back(
            {Notice::Kind::Note, fmt::format("{}: {} of its values need more than the 24 bits of a float and are "
                                             "rounded, by at most {:.3g}",
                                             file.name(), reader.rounded(), reader.greatestRounding())});
    if (reader.ofColours()) reader.colours().report(map, file.name());
}

}  // namespace

RawMap readPlacedMap(const FileForGdal& found, std::optional<int> band) try {
    const PlacedFile& file = found.file;
    const OpenMap open = openMap(file);
    checkSize(InputFile(file.path), nameOf(file.format), open.width(), open.height());
    MapHead head = readHead(open, band);
    checkSize(InputFile(file.path), nameOf(file.format), head.placed.columns, head.placed.rows);
    RowReader reader(open, head.bands);
    checkIsWhole(open, reader);
    readSamples(reader, open.width(), open.height(), head.placed, head.map);
    completeHead(head, open, greatestOf(head.map.samples));
    addNotices(open, reader, head.map);
    return std::move(head.map);
} catch (const Error& error) {
    throw withReason(error, found);
}

}  // namespace dsphere::geo
