#pragma once

#include <filesystem>
#include <optional>

#include "geo/mapfile.h"
#include "image/rawmap.h"

namespace dsphere::geo {

/// Reads a heightmap of any format: a map that says where it lies or what its values mean, or whose samples only GDAL
/// reads, with GDAL; every other with readRawMap. Rows run from the north, columns eastward, each longitude has one
/// column; rows that the file does not cover are unknown. `band` counts from 1; unset: the first, or of a picture in R,
/// G and B their mean. Throws Error (InvalidInput) as readRawMap does, also for a piece of the sphere or another
/// projection (the message names `dsphere import`), and without GDAL for every map that needs it.
RawMap readMap(const std::filesystem::path& path, std::optional<int> band = {});

/// A file that is read with GDAL, and why: "its tag 33922 says where it lies on the planet".
struct FileForGdal {
    PlacedFile file;
    std::string reason;
};

/// Unset: readRawMap reads it. Throws Error (InvalidInput) when the file cannot be read.
std::optional<FileForGdal> fileForGdal(const std::filesystem::path& path, std::optional<int> band);

/// The name of a world file beside a map, .tfw or .tifw or .wld of a .tif; empty: there is none.
std::string worldFileOf(const std::filesystem::path& path);

/// readMap's part that needs GDAL.
RawMap readPlacedMap(const FileForGdal& found, std::optional<int> band);

}  // namespace dsphere::geo
