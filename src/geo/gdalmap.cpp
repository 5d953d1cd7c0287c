#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "geo/gdalband.h"
#include "geo/gdalreference.h"
#include "geo/placement.h"
#include "geo/readmap.h"
#include "image/codecs.h"
#include "image/mapchannels.h"

namespace dsphere::geo {
namespace {

constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();

/// The bands whose mean is read: one, or R, G and B.
std::vector<int> bandsOf(const OpenMap& map, std::optional<int> wanted, Notices& notices) {
    const Gdal& g = gdal();
    const int count = map.bands();
    if (wanted && (*wanted < 1 || *wanted > count))
        throwInvalid("{}: band {} is asked for, but it has {}", map.name(), *wanted, count);
    if (wanted) return {*wanted};
    const auto colour = [&](int band) {
        return g.GDALGetRasterColorInterpretation(g.GDALGetRasterBand(map.dataset.get(), band));
    };
    if (count >= 3 && colour(1) == GCI_RedBand && colour(2) == GCI_GreenBand && colour(3) == GCI_BlueBand)
        return {1, 2, 3};
    const bool alpha = count == 2 && colour(2) == GCI_AlphaBand;
    if (count > 1 && !alpha)
        notices.push_back({Notice::Kind::Note, fmt::format("{}: has {} bands, of which the first is read; \"integer "
                                                           "band\" chooses another",
                                                           map.name(), count)});
    return {1};
}

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

    GDALRasterBandH band() const { return bands_[0].band; }
    const SampleType& sample() const { return bands_[0].sample; }
    const Unknown& unknown() const { return bands_[0].unknown; }
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

/// The whole sphere in the file's own rows, for a file that does not say where it lies.
Placement unplaced(const OpenMap& map) {
    Placement placed;
    placed.columns = map.width();
    placed.rows = map.height();
    return placed;
}

Placement placementOf(const OpenMap& map, const Reference& reference, MapFacts& facts) {
    if (reference.other_projection)
        throwInvalid(
            "{}: its projection is {}, expected longitudes and latitudes; `dsphere import` makes such a map of "
            "it",
            map.name(), reference.projection);
    facts.projection = reference.projection;
    if (!reference.projection.empty()) facts.sources["projection"] = map.source();
    if (!reference.grid) return unplaced(map);
    const Placement placed = placeOnSphere(map.name(), *reference.grid);
    facts.extent = placed.extent;
    for (const char* property : {"extent", "longitude_origin", "registration"}) facts.sources[property] = map.source();
    return placed;
}

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
    map.width = placed.columns;
    map.height = placed.rows;
    map.samples.assign(std::size_t(map.width) * std::size_t(map.height), kUnknown);
    for (int j = 0; j < file_height; ++j) {
        reader.read(j, row.data());
        if (placed.mirrored) std::reverse(row.begin(), row.begin() + placed.columns);
        const int to = placed.rows_above + (placed.flipped ? file_height - 1 - j : j);
        std::copy_n(row.begin(), placed.columns, map.samples.begin() + std::ptrdiff_t(to) * placed.columns);
    }
}

void takeUnits(const OpenMap& map, const Units& units, MapFacts& facts) {
    facts.unit = units.unit;
    facts.value_scale = units.scale;
    facts.value_offset = units.offset;
    if (!units.unit.empty()) facts.sources["unit"] = units.unit_source;
    if (units.scale) facts.sources["scale"] = facts.sources["offset"] = map.source();
}

/// An offset that is far greater than all heights, or about the radius of the datum, is the radius that heights count
/// from.
void takeOffsetForRadius(RawMap& map) {
    MapFacts& facts = map.facts;
    constexpr double kLeastRadius = 1e5;
    if (facts.unit != "m" || facts.value_offset.value_or(0.0) <= 0.0) return;
    const double offset = *facts.value_offset;
    double greatest = 0.0;
    for (const float stored : map.samples)
        if (std::isfinite(stored)) greatest = std::max(greatest, std::abs(*facts.value_scale * double(stored)));
    const bool about_datum = facts.radius && std::abs(offset - *facts.radius) < 0.2 * *facts.radius;
    if (!about_datum && !(offset >= kLeastRadius && offset > 5.0 * greatest)) return;
    facts.offset_is_radius = true;
    facts.radius = offset;
    facts.sources["radius"] = facts.sources["offset"];
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

RawMap readPlacedMap(const PlacedFile& file, std::optional<int> band, const std::string& reason) try {
    gdal();
    const OpenMap open = openMap(file);
    checkSize(InputFile(file.path), nameOf(file.format), open.width(), open.height());
    const Reference reference = referenceOf(open);
    RawMap map;
    const Placement placed = placementOf(open, reference, map.facts);
    checkSize(InputFile(file.path), nameOf(file.format), placed.columns, placed.rows);
    map.notices = placed.notices;
    RowReader reader(open, bandsOf(open, band, map.notices));
    checkIsWhole(open, reader);
    readSamples(reader, open.width(), open.height(), placed, map);
    map.gridline = placed.gridline;
    if (map.unknown_are_nan) map.facts.sources["nodata"] = open.source();
    if (reference.grid) map.longitude_origin = placed.longitude_origin;
    map.full_scale = reader.sample().fullScale();
    map.type = fmt::format("{} {}", reader.sample().name(), nameOf(file.format));
    map.unknown_are_nan = reader.unknown().any() || placed.rows > open.height();
    map.facts.radius = reference.radius;
    if (reference.radius) map.facts.sources["radius"] = reference.radius_source;
    takeUnits(open, unitsOf(open, reader.band(), reader.sample(), reference.radius.has_value()), map.facts);
    takeOffsetForRadius(map);
    if (!map.facts.offset_is_radius)
        map.notices.insert(map.notices.end(), reference.notices.begin(), reference.notices.end());
    if (!reference.grid && file.format != PlacedFile::Format::Tiff)
        map.notices.push_back({Notice::Kind::Warning,
                               open.name() + ": does not say where it lies: taken for a whole sphere from 180 degrees "
                                             "west, its first row in the north"});
    addNotices(open, reader, map);
    return map;
} catch (const Error& error) {
    if (std::string(error.what()).find(file.path.string()) != std::string::npos) throw;
    throw Error(error.code(), fmt::format("{}: {}: {}", file.path.string(), reason, error.what()));
}

}  // namespace dsphere::geo
