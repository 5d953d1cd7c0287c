#include "geo/mapfile.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>
#include <vector>

#include "image/codecs.h"

namespace dsphere::geo {
namespace {

namespace fs = std::filesystem;
using Format = PlacedFile::Format;

std::string lowerCase(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return text;
}

std::string extensionOf(const fs::path& path) {
    return lowerCase(path.extension().string());
}

/// The first bytes: 4096, or as many as there are.
std::string startOf(const fs::path& path) {
    InputFile file(path);
    std::string start(std::size_t(std::min<std::uint64_t>(4096, file.size())), '\0');
    file.read(start.data(), start.size());
    return start;
}

bool contains(std::string_view text, std::string_view part) {
    return text.find(part) != std::string_view::npos;
}

/// Whether a line of the text begins with the word, after spaces.
bool hasLine(std::string_view text, std::string_view word) {
    for (std::size_t at = text.find(word); at != std::string_view::npos; at = text.find(word, at + 1)) {
        const std::size_t before = text.find_last_not_of(" \t", at == 0 ? 0 : at - 1);
        if (at == 0 || before == std::string_view::npos || text[before] == '\n' || text[before] == '\r') return true;
    }
    return false;
}

/// An Arc/Info grid: its first word is a name of its header, the second a number.
bool isAsciiGrid(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos) return false;
    const std::size_t end = text.find_first_of(" \t", begin);
    if (end == std::string_view::npos) return false;
    const std::string word = lowerCase(std::string(text.substr(begin, end - begin)));
    const std::size_t number = text.find_first_not_of(" \t", end);
    return (word == "ncols" || word == "nrows" || word == "xllcorner" || word == "xllcenter") &&
           number != std::string_view::npos &&
           (std::isdigit(static_cast<unsigned char>(text[number])) || text[number] == '-');
}

std::optional<Format> formatOfContent(std::string_view start) {
    using namespace std::string_view_literals;
    if (start.starts_with("CDF\x01"sv) || start.starts_with("CDF\x02"sv) || start.starts_with("CDF\x05"sv) ||
        start.starts_with("\x89HDF\r\n\x1a\n"sv))
        return Format::NetCdf;
    if (start.starts_with("\0\0\0\x0cjP  "sv) || start.starts_with("\xff\x4f\xff\x51"sv)) return Format::Jpeg2000;
    if (start.starts_with("SIMPLE  =")) return Format::Fits;
    if (start.starts_with("LBLSIZE=")) return Format::Vicar;
    if (hasLine(start, "PDS_VERSION_ID")) return Format::Pds3;
    if (hasLine(start, "Object = IsisCube") || (start.starts_with("CCSD") && contains(start, "SFDU_LABEL")))
        return Format::Isis;
    if (contains(start.substr(0, 1024), "<VRTDataset")) return Format::Vrt;
    if (contains(start, "<Product_Observational")) return Format::Pds4;
    if (isAsciiGrid(start)) return Format::AsciiGrid;
    return {};
}

/// Squares of 16-bit heights, one degree wide, that say nothing but by their name and length.
bool isHgt(const fs::path& path) {
    if (extensionOf(path) != ".hgt") return false;
    const auto bytes = fs::file_size(path);
    return bytes == 2ull * 1201 * 1201 || bytes == 2ull * 3601 * 3601 || bytes == 2ull * 1801 * 3601;
}

/// The files of that stem beside `path` whose extensions are among those given, in any case.
std::vector<fs::path> besides(const fs::path& path, std::initializer_list<std::string_view> extensions) {
    std::vector<fs::path> found;
    const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
    std::error_code ignored;
    for (const auto& entry : fs::directory_iterator(folder, ignored)) {
        const fs::path name = entry.path().filename();
        const bool same_stem = name.stem() == path.stem() || name.stem() == path.filename();
        if (same_stem && name != path.filename() && std::ranges::count(extensions, extensionOf(name)) > 0 &&
            entry.is_regular_file(ignored))
            found.push_back(path.has_parent_path() ? entry.path() : name);
    }
    return found;
}

/// Samples without a header, described by a label beside them that names them.
std::optional<PlacedFile> describedByLabel(const fs::path& path) {
    for (const fs::path& label : besides(path, {".lbl", ".xml", ".hdr"})) {
        const std::string start = startOf(label);
        if (start.starts_with("ENVI")) return PlacedFile{Format::Envi, path, {}};
        const std::optional<Format> format = formatOfContent(start);
        if (format != Format::Pds3 && format != Format::Pds4) continue;
        const bool named = contains(lowerCase(start), lowerCase(path.filename().string()));
        if (format == Format::Pds3 && named) return PlacedFile{Format::Pds3, label, label};
        if (format == Format::Pds4) return PlacedFile{Format::Pds4, label, {}};
    }
    return {};
}

/// The samples that an ENVI header stands beside.
PlacedFile ofEnviHeader(const fs::path& header) {
    fs::path samples = header;
    samples.replace_extension();
    if (fs::is_regular_file(samples)) return {Format::Envi, samples, {}};
    for (const char* extension : {".img", ".dat", ".raw", ".bin", ".bsq", ".bil", ".bip"}) {
        samples.replace_extension(extension);
        if (fs::is_regular_file(samples)) return {Format::Envi, samples, {}};
    }
    throwInvalid(
        "{}: an ENVI header without its samples: expected {} beside it, or the same with the ending .img or .dat",
        header.string(), fs::path(header).replace_extension().filename().string());
}

}  // namespace

const char* nameOf(PlacedFile::Format format) {
    constexpr std::array kNames{"PDS3", "PDS4", "ISIS cube",  "VICAR", "netCDF",    "ENVI",
                                "FITS", "HGT",  "ASCII grid", "VRT",   "JPEG 2000", "TIFF"};
    return kNames[std::size_t(format)];
}

const char* driverOf(PlacedFile::Format format) {
    constexpr std::array kDrivers{"PDS",  "PDS4",    "ISIS3",   "VICAR", "netCDF",      "ENVI",
                                  "FITS", "SRTMHGT", "AAIGrid", "VRT",   "JP2OpenJPEG", "GTiff"};
    return kDrivers[std::size_t(format)];
}

std::optional<PlacedFile> placedFile(const fs::path& path) {
    const std::string start = startOf(path);
    if (start.starts_with("ENVI\n") || start.starts_with("ENVI\r\n")) return ofEnviHeader(path);
    if (const std::optional<Format> format = formatOfContent(start))
        return PlacedFile{*format, path, *format == Format::Pds3 ? path : fs::path()};
    if (isHgt(path)) return PlacedFile{Format::Hgt, path, {}};
    InputFile file(path);
    if (formatOf(file) != MapFormat::Unknown || extensionOf(path) == ".pbrt") return {};
    return describedByLabel(path);
}

bool looksLikeMap(const fs::path& path) try {
    constexpr std::array kExtensions{".lbl",  ".img", ".cub", ".nc",  ".grd", ".asc",
                                     ".fits", ".fit", ".hgt", ".hdr", ".vrt", ".jp2"};
    if (dsphere::looksLikeMap(path)) return true;
    if (extensionOf(path) == ".pbrt") return false;
    if (std::ranges::find(kExtensions, extensionOf(path)) != kExtensions.end()) return true;
    return fs::is_regular_file(path) && fs::file_size(path) > 0 && placedFile(path).has_value();
} catch (const std::exception&) {
    return false;
}

}  // namespace dsphere::geo
