#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/notice.h"

namespace dsphere::geo {

struct ImportOptions {
    std::vector<std::filesystem::path> inputs;  ///< later ones lie over earlier ones
    std::filesystem::path output;
    std::optional<std::pair<int, int>> resolution = {};  ///< columns and rows; unset: those of the finest input
    std::function<bool(double share)> progress = {};     ///< false: stop
};

struct ImportResult {
    int width = 0, height = 0;
    std::string type;  ///< "Int16", "Float32"
    Notices notices;
};

/// Makes one map of the whole sphere of pieces in any projection that GDAL knows: a tiled, compressed GeoTIFF in
/// longitudes -180 to 180 with overviews, unknown where no input covers. It keeps the inputs' stored values where all
/// are integers of at most 16 bits with the same scale and offset; else it holds metres as float32. The file comes into
/// being whole or not at all. Throws Error: (InvalidInput) for an input that cannot be read or placed, (Failure) when
/// the output cannot be written, (Interrupted) when `progress` said so, (Usage) when the output is one of the inputs.
ImportResult importMaps(const ImportOptions& options);

}  // namespace dsphere::geo
