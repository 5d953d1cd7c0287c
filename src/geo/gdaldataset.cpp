#include "geo/gdaldataset.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "base/error.h"
#include "geo/netcdfcheck.h"
#include "image/inputfile.h"

namespace dsphere::geo {
namespace {

Dataset openWith(PlacedFile::Format format, const std::string& name, bool all_cores) {
    const char* older = format == PlacedFile::Format::Isis ? "ISIS2" : nullptr;
    const char* drivers[] = {driverOf(format), older, nullptr};
    Strings threads{"NUM_THREADS=ALL_CPUS"};
    char** options = all_cores && format == PlacedFile::Format::Tiff ? threads.list() : nullptr;
    return Dataset(gdal().GDALOpenEx(name.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, drivers, options, nullptr));
}

/// GDAL reads what a VRT names, by any of its formats' own names of files; those have no word for a network but these.
void refuseNetwork(const PlacedFile& file) {
    InputFile in(file.path);
    constexpr std::uint64_t kMost = 64 << 20;
    if (in.size() > kMost) in.invalid("VRT: has {} bytes, expected at most {}", in.size(), kMost);
    std::string text(std::size_t(in.size()), '\0');
    in.read(text.data(), text.size());
    for (const char* word : {"://", "/vsi"})
        if (const std::size_t at = text.find(word); at != std::string::npos)
            in.invalid("VRT: line {} names a source with \"{}\"; expected files of this machine alone",
                       1 + std::count(text.begin(), text.begin() + std::ptrdiff_t(at), '\n'), word);
}

/// The variable after the last ':' of "NETCDF:\"file.nc\":z".
std::string variableOf(const std::string& name) {
    return name.substr(name.rfind(':') + 1);
}

/// Of a file with several grids the one that holds heights.
std::string chooseGrid(const OpenMap& map) {
    const Gdal& g = gdal();
    char** list = g.GDALGetMetadata(map.dataset.get(), "SUBDATASETS");
    std::vector<std::string> names;
    for (; list && *list; ++list) {
        const std::string item = *list;
        if (const std::size_t at = item.find("_NAME="); at != std::string::npos) names.push_back(item.substr(at + 6));
    }
    if (names.size() == 1) return names[0];
    for (const char* heights : {"z", "elevation", "height", "topo", "topography", "dem", "dtm", "altitude", "Band1"})
        for (const std::string& name : names)
            if (variableOf(name) == heights) return name;
    std::string all;
    for (const std::string& name : names) all += (all.empty() ? "" : ", ") + variableOf(name);
    throwInvalid("{}: {}: {}; expected one grid, or one named z, elevation, height, topo or dem", map.name(),
                 nameOf(map.file.format), names.empty() ? "holds no grid" : "holds the grids " + all);
}

/// Of the dataset's files together; the greatest number if that cannot be told.
std::uint64_t bytesOfFiles(const OpenMap& map) {
    const std::vector<std::filesystem::path> files = map.files();
    std::uint64_t bytes = files.empty() ? UINT64_MAX : 0;
    for (const std::filesystem::path& file : files) {
        std::error_code failed;
        const std::uintmax_t size = std::filesystem::file_size(file, failed);
        if (failed) return UINT64_MAX;
        bytes += size;
    }
    return bytes;
}

bool isInterleaved(const OpenMap& map) {
    const char* order = gdal().GDALGetMetadataItem(map.dataset.get(), "INTERLEAVE", "IMAGE_STRUCTURE");
    return order && std::string_view(order) == "PIXEL";
}

// GDAL makes room for a whole block, of all bands where these are interleaved, before it reads one, whatever the file's
// length.
void checkBlocks(const OpenMap& map) {
    constexpr std::uint64_t kMostBytes = std::uint64_t(1) << 31;
    constexpr std::uint64_t kUnasked = std::uint64_t(1) << 26;  // a block of so many bytes need not be borne out
    constexpr std::uint64_t kMostPacking = 65536;               // of a block, by any method
    const std::uint64_t together = isInterleaved(map) ? std::uint64_t(map.bands()) : 1;
    for (int k = 1; k <= map.bands(); ++k) {
        const GDALRasterBandH band = gdal().GDALGetRasterBand(map.dataset.get(), k);
        int width = 0, height = 0;
        gdal().GDALGetBlockSize(band, &width, &height);
        const int bits = std::max(1, gdal().GDALGetDataTypeSizeBits(gdal().GDALGetRasterDataType(band)));
        if (width < 1 || height < 1 ||
            std::uint64_t(width) * std::uint64_t(height) > kMostBytes * 8 / std::uint64_t(bits))
            throwInvalid("{}: {}: is stored in blocks of {}x{} texels of {} bits, expected at most {} bytes a block",
                         map.name(), nameOf(map.file.format), width, height, bits, kMostBytes);
        const std::uint64_t bytes = std::uint64_t(width) * std::uint64_t(height) * std::uint64_t(bits) / 8 * together;
        if (bytes > kUnasked && bytes / kMostPacking > bytesOfFiles(map))
            throwInvalid(
                "{}: {}: is stored in blocks of {}x{} texels of {} bits and {} bands, more than its files can hold",
                map.name(), nameOf(map.file.format), width, height, bits, together);
    }
}

}  // namespace

std::vector<std::filesystem::path> OpenMap::files() const {
    char** const list = gdal().GDALGetFileList(dataset.get());
    std::vector<std::filesystem::path> files;
    for (char** file = list; file && *file; ++file) files.emplace_back(*file);
    gdal().CSLDestroy(list);
    return files;
}

const char* OpenMap::source() const {
    using Format = PlacedFile::Format;
    const Format f = file.format;
    return f == Format::Tiff || f == Format::Jpeg2000 || f == Format::Vrt ? "tag" : "label";
}

OpenMap openMap(const PlacedFile& file, bool all_cores) {
    GdalMessages messages;
    if (file.format == PlacedFile::Format::Vrt) refuseNetwork(file);
    if (file.format == PlacedFile::Format::NetCdf) checkClassicNetCdf(file.path);
    OpenMap map{file, openWith(file.format, file.path.string(), all_cores), {}, file.path.string()};
    const auto refuse = [&] {
        throwInvalid("{}: {}: cannot be read: {}", map.name(), nameOf(file.format), messages.reason());
    };
    if (!map.dataset) refuse();
    if (map.bands() == 0) {
        map.opened = chooseGrid(map);
        map.dataset = openWith(file.format, map.opened, all_cores);
    }
    if (!map.dataset || map.bands() == 0) refuse();
    checkBlocks(map);
    if (file.format == PlacedFile::Format::Pds3) map.label.emplace(file.label);
    return map;
}

}  // namespace dsphere::geo
