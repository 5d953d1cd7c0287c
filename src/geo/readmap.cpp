#include "geo/readmap.h"

#include <string>
#include <vector>

#include "image/codecs.h"
#include "image/tiffcheck.h"

namespace dsphere::geo {
namespace {

/// Why a TIFF is read with GDAL; empty: it is not.
std::string whyPlaced(InputFile& file, const std::filesystem::path& path, bool band) {
    std::string reason = whatPlainTiffLacks(file);
    const std::string world = worldFileOf(path), noted = path.string() + ".aux.xml";
    if (reason.empty() && !world.empty()) reason = world + " beside it says where it lies";
    if (reason.empty() && std::filesystem::exists(noted)) reason = "the .aux.xml beside it describes it";
    if (reason.empty() && band) reason = "a band of it is asked for";
    return reason;
}

}  // namespace

std::string worldFileOf(const std::filesystem::path& path) {
    const std::string own = path.extension().string();
    std::vector<std::string> extensions{own + "w", ".wld"};
    if (own.size() > 3) extensions.push_back({'.', own[1], own.back(), 'w'});
    for (const std::string& extension : extensions) {
        std::filesystem::path beside = path;
        if (std::filesystem::exists(beside.replace_extension(extension))) return beside.filename().string();
    }
    return "";
}

std::optional<FileForGdal> fileForGdal(const std::filesystem::path& path, std::optional<int> band) {
    if (const std::optional<PlacedFile> placed = placedFile(path))
        return FileForGdal{*placed, fmt::format("it is in the format {}", nameOf(placed->format))};
    InputFile file(path);
    if (formatOf(file) != MapFormat::Tiff) return {};
    const std::string reason = whyPlaced(file, path, band.has_value());
    if (reason.empty()) return {};
    return FileForGdal{{PlacedFile::Format::Tiff, path, {}}, reason};
}

RawMap readMap(const std::filesystem::path& path, std::optional<int> band) {
    if (const std::optional<FileForGdal> found = fileForGdal(path, band)) return readPlacedMap(*found, band);
    if (band.value_or(1) != 1)
        InputFile(path).invalid("band {} is asked for, which files of this format do not have", *band);
    RawMap map = readRawMap(path);
    const std::string world = worldFileOf(path);
    if (!world.empty())
        map.notices.push_back(
            {Notice::Kind::Warning, fmt::format("{}: {} beside it says where it lies, which is read for TIFF alone; "
                                                "`lonorigin` and `registration` of a scene can say it",
                                                path.string(), world)});
    return map;
}

}  // namespace dsphere::geo
