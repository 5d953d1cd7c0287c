#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "geo/gdal.h"
#include "geo/label.h"
#include "geo/mapfile.h"

namespace dsphere::geo {

/// A map opened with GDAL.
struct OpenMap {
    PlacedFile file;
    Dataset dataset;
    std::optional<Pds3Label> label;
    std::string opened;  ///< GDAL's name of what is open: the file's, or that of a grid in it

    std::string name() const { return file.path.string(); }
    int width() const { return gdal().GDALGetRasterXSize(dataset.get()); }
    int height() const { return gdal().GDALGetRasterYSize(dataset.get()); }
    int bands() const { return gdal().GDALGetRasterCount(dataset.get()); }
    /// "tag" or "label": the word for what such a file says of itself.
    const char* source() const;
    /// As GDAL lists them: the file, those beside it and those that it names. Some may not be files of the system.
    std::vector<std::filesystem::path> files() const;
};

/// Opens it for reading with the driver of its format alone; of a netCDF file with several variables the one that is
/// named like heights, or the only grid. `all_cores`: large windows of TIFFs are decoded by several threads. Throws
/// Error (InvalidInput) with GDAL's reason.
OpenMap openMap(const PlacedFile& file, bool all_cores = false);

}  // namespace dsphere::geo
