#pragma once

// The keys of a PDS3 label that GDAL 3.6 leaves out or makes up.

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "geo/placement.h"

namespace dsphere::geo {

class Pds3Label {
  public:
    /// Reads up to the label's END, at most 1 MiB of the file.
    explicit Pds3Label(const std::filesystem::path& path);

    /// The value without quotes; of an image's object if it stands there, else of the first that has it. Empty: absent.
    std::string text(const std::string& key) const;
    /// A number, its unit ("<km>") left out. Unset: absent or no number ("N/A").
    std::optional<double> number(const std::string& key) const;
    /// The value for texels without data, under any of its names: the key and the number.
    std::optional<std::pair<std::string, double>> missing() const;

    /// The grid of a simple cylindrical or equirectangular map by its outermost longitudes and latitudes, which are
    /// surer than its offsets: publishers count these from the first texel's edge or from its centre. Unset: another
    /// projection, or keys that contradict the size in texels.
    std::optional<LatLonGrid> grid(int width, int height) const;

  private:
    std::map<std::string, std::string> of_image_, others_;
};

}  // namespace dsphere::geo
