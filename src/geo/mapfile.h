#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace dsphere::geo {

/// A file in one of the formats in which maps with a place on a planet are published.
struct PlacedFile {
    enum class Format { Pds3, Pds4, Isis, Vicar, NetCdf, Envi, Fits, Hgt, AsciiGrid, Vrt, Jpeg2000, Tiff };

    Format format;
    std::filesystem::path
        path;  ///< what GDAL opens: of ENVI the samples, of PDS the label where it is a file of its own
    std::filesystem::path label;  ///< PDS3: where the keys stand; else empty
};

const char* nameOf(PlacedFile::Format format);    ///< "PDS3", for messages and reports
const char* driverOf(PlacedFile::Format format);  ///< GDAL's name of it

/// Which of these formats a file has: by its content, or that of the label beside it that names it. All but TIFF, whose
/// tags decide (see readMap). Throws Error (InvalidInput) when the file cannot be read.
std::optional<PlacedFile> placedFile(const std::filesystem::path& path);

/// Whether a file is a map rather than a scene: the content decides, where it says nothing (it is empty, missing or
/// text) the extension. Never throws.
bool looksLikeMap(const std::filesystem::path& path);

}  // namespace dsphere::geo
