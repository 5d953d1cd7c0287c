#include <array>
#include <cmath>
#include <limits>

#include "image/codecs.h"

// GTX, the vertical grid of NOAA's VDatum: 40 big-endian bytes (south latitude, west longitude, latitude step,
// longitude step in degrees as doubles; rows, columns as int32), then float32 rows from the south.

namespace dsphere {
namespace {

constexpr std::size_t kHeaderBytes = 40;
constexpr float kNoData = -88.8888f;
// Steps are stored rounded (1/12 of a degree as 0.0833333); a grid that is off by more is another grid.
constexpr double kTolerance = 0.01;  // of a step

struct Header {
    double south = 0.0, west = 0.0, latitude_step = 0.0, longitude_step = 0.0;  // degrees
    int rows = 0, columns = 0;
};

bool near(double a, double b, double step) {
    return std::abs(a - b) <= kTolerance * step;
}

/// Throws unless the nodes reach from pole to pole and once around.
void checkGlobe(const InputFile& file, const Header& h) {
    const double north = h.south + (h.rows - 1) * h.latitude_step;
    const double round = h.columns * h.longitude_step;
    const bool steps =
        h.latitude_step > 0.0 && h.longitude_step > 0.0 && std::isfinite(h.latitude_step + h.longitude_step);
    const bool poles = near(h.south, -90.0, h.latitude_step) && near(north, 90.0, h.latitude_step);
    const bool around = near(round, 360.0, h.longitude_step) || near(round, 360.0 + h.longitude_step, h.longitude_step);
    if (steps && poles && around && std::isfinite(h.west)) return;
    file.invalid(
        "GTX: the grid of {}x{} nodes covers latitudes {} to {} in steps of {} and longitudes {} to {} in steps of {} "
        "degrees; expected the globe, latitudes -90 to 90 and 360 degrees of longitude",
        h.columns, h.rows, h.south, north, h.latitude_step, h.west, h.west + round - h.longitude_step,
        h.longitude_step);
}

Header readHeader(InputFile& file) {
    if (file.remaining() < kHeaderBytes)
        file.invalid("GTX: truncated: a header of {} bytes expected, {} found", kHeaderBytes, file.remaining());
    std::array<std::uint8_t, kHeaderBytes> bytes;
    file.read(bytes.data(), bytes.size());
    Header header{loadDouble(&bytes[0]),  loadDouble(&bytes[8]),   loadDouble(&bytes[16]),
                  loadDouble(&bytes[24]), int(load32(&bytes[32])), int(load32(&bytes[36]))};
    checkSize(file, "GTX", header.columns, header.rows);
    checkGlobe(file, header);
    const std::uint64_t needed = 4 * std::uint64_t(header.rows) * std::uint64_t(header.columns);
    if (file.remaining() != needed)
        file.invalid("GTX: the grid of {}x{} nodes needs exactly {} bytes after the header, {} found", header.columns,
                     header.rows, needed, file.remaining());
    return header;
}

}  // namespace

RawMap readGtx(InputFile& file) {
    const Header header = readHeader(file);
    // A last column at west + 360 repeats the first.
    const bool repeats = header.columns * header.longitude_step > 360.0 + 0.5 * header.longitude_step;
    RawMap map;
    map.width = repeats ? header.columns - 1 : header.columns;
    map.height = header.rows;
    map.gridline = true;
    map.longitude_origin = header.west - 360.0 * std::floor((header.west + 180.0) / 360.0);
    map.type = "float32 GTX";
    map.facts.unit = std::string("m");  // GCC 12 warns of an overlap when the characters are assigned
    map.facts.sources["unit"] = "format";
    map.samples.resize(std::size_t(map.width) * std::size_t(map.height));
    std::vector<std::uint8_t> row(4 * std::size_t(header.columns));
    for (std::size_t j = std::size_t(map.height); j-- > 0;) {
        file.read(row.data(), row.size());
        for (std::size_t i = 0; i < std::size_t(map.width); ++i) {
            const float value = loadFloat(&row[4 * i]);
            const bool unknown = value == kNoData;
            map.unknown_are_nan = map.unknown_are_nan || unknown;
            map.samples[j * std::size_t(map.width) + i] = unknown ? std::numeric_limits<float>::quiet_NaN() : value;
        }
    }
    return map;
}

}  // namespace dsphere
