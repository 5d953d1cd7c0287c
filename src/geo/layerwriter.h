#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace dsphere::geo {

/// Texels of a planet in longitude and latitude: degrees of the edges, row 0 in the north.
struct LayerPlace {
    int width = 0, height = 0;
    double west = 0.0, east = 0.0, south = 0.0, north = 0.0;
    std::optional<double> radius = {};  ///< of the planet, metres; unset: unknown, and the file says the Earth's
};

struct LayerInfo {
    std::string name, unit;            ///< unit: "degree", "m"; empty: none
    double scale = 1.0, offset = 0.0;  ///< a value means offset + scale * value, in `unit`
};

/// Writes layers of float32 as the bands of one GeoTIFF (tiled, compressed), one layer after another, so that memory
/// holds one at a time. NaN is its value for unknown. The file comes into being whole, by commit(), or not at all.
class LayerWriter {
  public:
    /// Error (InvalidInput) where GDAL is missing, (Failure) when the file cannot be made.
    LayerWriter(const std::filesystem::path& output, const LayerPlace& place, const std::vector<LayerInfo>& layers);
    ~LayerWriter();

    /// The next layer: width * height values. Error (Failure) when it cannot be written.
    void write(std::span<const float> values);
    /// All layers have been written. Error (Failure) when the file cannot be completed.
    void commit();

  private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};

}  // namespace dsphere::geo
