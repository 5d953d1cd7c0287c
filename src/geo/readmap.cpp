#include "geo/readmap.h"

#include "image/codecs.h"
#include "image/tiffcheck.h"

namespace dsphere::geo {
namespace {

/// Files beside a TIFF that place it: its world file, and what GDAL knows of it.
std::string whatStandsBeside(const std::filesystem::path& path) {
    for (const char* extension : {".tfw", ".tifw", ".tiffw", ".wld"}) {
        std::filesystem::path beside = path;
        if (std::filesystem::exists(beside.replace_extension(extension)))
            return fmt::format("{} beside it says where it lies", beside.filename().string());
    }
    const std::filesystem::path known = path.string() + ".aux.xml";
    return std::filesystem::exists(known) ? fmt::format("{} beside it describes it", known.filename().string()) : "";
}

}  // namespace

RawMap readMap(const std::filesystem::path& path, std::optional<int> band) {
    if (const std::optional<PlacedFile> placed = placedFile(path))
        return readPlacedMap(*placed, band, fmt::format("it is in the format {}", nameOf(placed->format)));
    InputFile file(path);
    if (formatOf(file) == MapFormat::Tiff) {
        std::string reason = whatPlainTiffLacks(file);
        if (reason.empty()) reason = whatStandsBeside(path);
        if (reason.empty() && band) reason = "a band of it is asked for";
        if (!reason.empty()) return readPlacedMap({PlacedFile::Format::Tiff, path, {}}, band, reason);
    }
    if (band.value_or(1) != 1) file.invalid("band {} is asked for, which files of this format do not have", *band);
    return readRawMap(path);
}

}  // namespace dsphere::geo
