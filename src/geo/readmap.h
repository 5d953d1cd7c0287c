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

/// readMap's part that needs GDAL. `reason` is why: "its tag 33922 says where it lies on the planet".
RawMap readPlacedMap(const PlacedFile& file, std::optional<int> band, const std::string& reason);

}  // namespace dsphere::geo
