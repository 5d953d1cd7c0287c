#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "geo/gdalband.h"
#include "geo/gdalreference.h"
#include "geo/import.h"
#include "geo/mapwriter.h"

// Each input becomes a part of one VRT in the output's coordinates: as it lies where its texels are the output's, else
// warped by GDAL. One pass then writes that. VRTs are descriptions, so that texels are read and warped as they are
// written, and memory does not depend on the maps' sizes.

namespace dsphere::geo {
namespace {

namespace fs = std::filesystem;

struct Input {
    OpenMap map;
    Reference reference;
    Units units;
    GDALDataType type = GDT_Unknown;
    std::string nodata;  ///< empty: none
    bool masked = false;
};

/// What the output will be.
struct Target {
    std::string crs;  ///< WKT of longitudes and latitudes on the inputs' body
    double radius = 0.0;
    int width = 0, height = 0;
    const char* type = "Float32";
    std::string nodata = "-32768";
    bool keeps_stored = false;  ///< stored values as they are; else heights in metres
    Units units;

    double columnStep() const { return 360.0 / width; }
    double rowStep() const { return 180.0 / height; }
};

Input openInput(const fs::path& path) {
    const Gdal& g = gdal();
    const std::optional<PlacedFile> placed = placedFile(path);
    Input input{
        openMap(placed.value_or(PlacedFile{PlacedFile::Format::Tiff, path, {}})), {}, {}, GDT_Unknown, {}, false};
    input.reference = referenceOf(input.map);
    if (!input.reference.grid && !(input.reference.other_projection && g.GDALGetSpatialRef(input.map.dataset.get())))
        throwInvalid("{}: does not say where it lies; expected coordinates in a known system", path.string());
    GDALRasterBandH band = g.GDALGetRasterBand(input.map.dataset.get(), 1);
    const SampleType sample = sampleTypeOf(input.map, band);
    const Unknown unknown = unknownOf(input.map, band, sample);
    input.type = sample.type;
    if (unknown.value) input.nodata = fmt::format("{:.17g}", *unknown.value);
    input.masked = unknown.mask != nullptr;
    input.units = unitsOf(input.map, band, sample, input.reference.radius.has_value());
    return input;
}

/// The longitudes and latitudes that the first input is in or is projected from; without a word of it, on its sphere.
void setBody(Target& target, const Input& first) {
    const Gdal& g = gdal();
    OGRSpatialReferenceH own = g.GDALGetSpatialRef(first.map.dataset.get());
    const bool placed = own && (g.OSRIsGeographic(own) || g.OSRIsProjected(own));
    OGRSpatialReferenceH crs = placed ? g.OSRCloneGeogCS(own) : newSphere(first.reference.radius);
    target.crs = wktOf(crs);
    target.radius = first.reference.radius.value_or(g.OSRGetSemiMajor(crs, nullptr));
    g.OSRDestroySpatialReference(crs);
}

std::array<double, 6> transformOf(const Input& input) {
    std::array<double, 6> t{};
    gdal().GDALGetGeoTransform(input.map.dataset.get(), t.data());
    return t;
}

/// The lesser side of a texel.
double degreesOf(const Input& input, const Target& target) {
    if (input.reference.grid) return std::min(std::abs(input.reference.grid->dx), std::abs(input.reference.grid->dy));
    const Gdal& g = gdal();
    const auto t = transformOf(input);
    const double metres = g.OSRGetLinearUnits(g.GDALGetSpatialRef(input.map.dataset.get()), nullptr);
    return std::min(std::hypot(t[1], t[4]), std::hypot(t[2], t[5])) * metres / target.radius * 180.0 / std::numbers::pi;
}

void setSize(Target& target, const std::vector<Input>& inputs, const ImportOptions& options) {
    double finest = 90.0;
    for (const Input& input : inputs) finest = std::min(finest, degreesOf(input, target));
    // An even number of columns, so that texels are square; what is beyond a millionth of a texel is no rounding.
    const double columns = finest > 0.0 ? 2.0 * std::ceil(180.0 / finest - 1e-6) : 1e9;
    target.width = options.resolution ? options.resolution->first : int(std::min(columns, 1e9));
    target.height = options.resolution ? options.resolution->second : target.width / 2;
    constexpr int kMost = 1 << 20;
    if (target.width < 2 || target.height < 2 || target.width > kMost || target.height > kMost)
        throwInvalid("{}: the map would have {} columns and {} rows, expected 2 to {} of each; --resolution sets them",
                     options.output.string(), target.width, target.height, kMost);
}

/// Stored values are kept where all inputs are integers of at most 16 bits that mean the same.
void setSamples(Target& target, const std::vector<Input>& inputs) {
    const Input& first = inputs[0];
    const auto all = [&](auto holds) { return std::ranges::all_of(inputs, holds); };
    const bool same = all([&](const Input& i) { return i.units == first.units; });
    const bool fit_signed = all([](const Input& i) { return i.type == GDT_Byte || i.type == GDT_Int16; });
    const bool fit_unsigned =
        all([&](const Input& i) { return i.type == GDT_UInt16 && !i.nodata.empty() && i.nodata == first.nodata; });
    target.keeps_stored = same && (fit_signed || fit_unsigned);
    if (target.keeps_stored) {
        target.type = fit_signed ? "Int16" : "UInt16";
        target.nodata = fit_signed ? "-32768" : first.nodata;
        target.units = first.units;
    } else {
        target.units.unit = first.units.unit;
    }
}

/// A part of the input with its values as the output stores them.
VrtPart partOf(const Input& input, const Target& target) {
    VrtPart part{.source = input.map.opened, .nodata = input.nodata};
    part.columns = input.map.width();
    part.rows = input.map.height();
    if (target.keeps_stored || !input.units.scale) return part;
    part.scale = *input.units.scale;
    part.offset = *input.units.offset;
    // Heights count from the output's sphere.
    constexpr double kLeastRadius = 1e5;
    const bool about_radius = std::abs(part.offset - target.radius) < 0.2 * target.radius;
    if (input.units.unit == "m" && (about_radius || part.offset >= kLeastRadius)) part.offset -= target.radius;
    return part;
}

/// The parts of an input whose texels are the output's: one, or two where it crosses the output's edge. Empty: they are
/// not.
std::vector<VrtPart> alignedParts(const Input& input, const Target& target) {
    if (!input.reference.grid || input.masked) return {};
    const LatLonGrid& grid = *input.reference.grid;
    const double step = target.columnStep(), down = target.rowStep();
    const double column = (grid.west + 180.0) / step, row = (90.0 - grid.north) / down;
    constexpr double kSlack = 1e-3;  // of a texel
    if (std::abs(grid.dx / step - 1.0) * grid.width > kSlack ||
        std::abs(-grid.dy / down - 1.0) * grid.height > kSlack || std::abs(column - std::round(column)) > kSlack ||
        std::abs(row - std::round(row)) > kSlack)
        return {};
    VrtPart part = partOf(input, target);
    const int first = int(std::lround(row));
    part.from_row = std::max(0, -first);
    part.to_row = std::max(0, first);
    part.rows = std::min(part.rows - part.from_row, target.height - part.to_row);
    if (part.rows < 1) return {};
    const int around = target.width, left = int(std::lround(column)) % around;
    part.to_column = left < 0 ? left + around : left;
    const int all = std::min(part.columns, around);
    part.columns = std::min(all, around - part.to_column);
    if (part.columns == all) return {part};
    VrtPart rest = part;
    rest.from_column = part.columns;
    rest.columns = all - part.columns;
    rest.to_column = 0;
    return {part, rest};
}

/// The input in its own coordinates, its values as the output stores them. Where its columns go all around the sphere,
/// the first and the last stand beside each other at both ends, so that the seam is interpolated over.
Vrt restated(const Input& input, const Target& target) {
    const VrtPart part = partOf(input, target);
    Vrt vrt{
        .width = part.columns, .height = part.rows, .crs = target.crs, .type = target.type, .nodata = target.nodata};
    vrt.masked = input.masked;
    vrt.parts = {part};
    if (!input.reference.grid) {
        vrt.crs = wktOf(gdal().GDALGetSpatialRef(input.map.dataset.get()));
        vrt.transform = transformOf(input);
        return vrt;
    }
    const LatLonGrid& grid = *input.reference.grid;
    vrt.transform = {grid.west, grid.dx, 0.0, grid.north, 0.0, grid.dy};
    const int around = int(std::lround(360.0 / std::abs(grid.dx)));
    if (grid.width != around) return vrt;
    VrtPart last = part, first = part;
    last.from_column = part.columns - 1;
    last.columns = first.columns = 1;
    first.to_column = part.columns + 1;
    vrt.parts[0].to_column = 1;
    vrt.parts.insert(vrt.parts.end(), {last, first});
    vrt.width += 2;
    vrt.transform[0] -= grid.dx;
    return vrt;
}

/// A VRT of the output's grid that warps another.
MemoryFile warped(const MemoryFile& source, const Target& target, const std::string& input) {
    const Gdal& g = gdal();
    // clang-format off
    Strings words{"-of", "VRT", "-t_srs", target.crs, "-te", "-180", "-90", "180", "90",
                  "-ts", std::to_string(target.width), std::to_string(target.height), "-r", "bilinear", "-et", "0",
                  "-ot", target.type, "-dstnodata", target.nodata, "-wo", "NUM_THREADS=ALL_CPUS"};
    // clang-format on
    GdalMessages messages;
    const char* formats[] = {"VRT", nullptr};
    const Dataset opened(g.GDALOpenEx(source.name().c_str(), GDAL_OF_RASTER, formats, nullptr, nullptr));
    GDALWarpAppOptions* options = g.GDALWarpAppOptionsNew(words.list(), nullptr);
    GDALDatasetH from = opened.get();
    MemoryFile file;
    const Dataset made(opened ? g.GDALWarp(file.name().c_str(), nullptr, 1, &from, options, nullptr) : nullptr);
    g.GDALWarpAppOptionsFree(options);
    if (!made) throwInvalid("{}: cannot be projected: {}", input, messages.reason());
    return file;
}

/// Adds the input on top. What GDAL reads by name is kept in `files`.
void addInput(Vrt& mosaic, const Input& input, const Target& target, std::vector<MemoryFile>& files) {
    const std::vector<VrtPart> aligned = alignedParts(input, target);
    mosaic.parts.insert(mosaic.parts.end(), aligned.begin(), aligned.end());
    if (!aligned.empty()) return;
    const Vrt source = restated(input, target);
    // Longitudes that lie outside the output's range come into it by a turn.
    for (const double turn : {-360.0, 0.0, 360.0}) {
        Vrt turned = source;
        if (input.reference.grid) {
            turned.transform[0] += turn;
            const double end = turned.transform[0] + turned.transform[1] * turned.width;
            if (std::max(turned.transform[0], end) <= -180.0 || std::min(turned.transform[0], end) >= 180.0) continue;
        } else if (turn != 0.0) {
            continue;
        }
        files.emplace_back(turned.text());
        files.push_back(warped(files.back(), target, input.map.name()));
        mosaic.parts.push_back(
            {.source = files.back().name(), .columns = target.width, .rows = target.height, .nodata = target.nodata});
    }
}

void checkOutput(const ImportOptions& options) {
    const std::string extension = options.output.extension().string();
    if (extension != ".tif" && extension != ".tiff")
        throw Error(ExitCode::Usage,
                    fmt::format("{}: import writes TIFF; expected a name that ends in .tif", options.output.string()));
    std::error_code missing;
    for (const fs::path& input : options.inputs)
        if (fs::equivalent(input, options.output, missing))
            throw Error(ExitCode::Usage,
                        fmt::format("{}: is one of the inputs, which are never overwritten", options.output.string()));
}

}  // namespace

ImportResult importMaps(const ImportOptions& options) {
    checkOutput(options);
    gdal().GDALSetCacheMax64(std::int64_t(256) << 20);
    std::vector<Input> inputs;
    for (const fs::path& path : options.inputs) inputs.push_back(openInput(path));
    Target target;
    setBody(target, inputs.front());
    setSize(target, inputs, options);
    setSamples(target, inputs);
    Vrt mosaic{.width = target.width,
               .height = target.height,
               .crs = target.crs,
               .type = target.type,
               .nodata = target.nodata,
               .unit = target.units.unit};
    mosaic.transform = {-180.0, target.columnStep(), 0.0, 90.0, 0.0, -target.rowStep()};
    mosaic.scale = target.units.scale.value_or(1.0);
    mosaic.offset = target.units.offset.value_or(0.0);
    ImportResult result{target.width, target.height, target.type, {}};
    std::vector<MemoryFile> files;
    for (const Input& input : inputs) {
        addInput(mosaic, input, target, files);
        result.notices.insert(result.notices.end(), input.reference.notices.begin(), input.reference.notices.end());
    }
    writeGeoTiff(mosaic, options.output, options.progress);
    return result;
}

}  // namespace dsphere::geo
