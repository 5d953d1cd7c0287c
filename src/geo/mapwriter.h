#pragma once

#include <filesystem>
#include <functional>

#include "geo/vrt.h"

namespace dsphere::geo {

/// Writes a raster as a tiled, compressed GeoTIFF with overviews, whole or not at all. `tell` takes the share that is
/// done and returns false to stop: Error (Interrupted). Error (Failure) when it cannot be written, and (InvalidInput)
/// when a source cannot be read.
void writeGeoTiff(const Vrt& raster, const std::filesystem::path& output, const std::function<bool(double)>& tell);

}  // namespace dsphere::geo
