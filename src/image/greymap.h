#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <span>

namespace dsphere {

/// Fills row `j`, 0 on top; called by several threads at once.
using RowSource = std::function<void(int j, std::span<std::uint16_t> row)>;

/// Throws Error (Usage) unless writeGreyMap knows the extension.
void checkGreyMapName(const std::filesystem::path& path);

/// Writes a 16-bit greyscale map by blocks of rows that all cores fill, whatever its size: .png, .pgm, .tif or .tiff.
/// Sides are 1 to 2^20. `progress` gets the share that is done; when it returns false the file is left out and Error
/// (Interrupted) thrown. Written under a temporary name, then renamed; Error (Failure) when it cannot be.
void writeGreyMap(const std::filesystem::path& path, int width, int height, const RowSource& source,
                  const std::function<bool(double)>& progress);

}  // namespace dsphere
