#pragma once

// VRTs that are written here: descriptions of rasters made of others, which GDAL reads like files.

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "geo/gdal.h"

namespace dsphere::geo {

/// A rectangle of a source's texels and where it comes to lie.
struct VrtPart {
    std::string source;  ///< a file's name, or GDAL's of a part of it
    int band = 1;
    int from_column = 0, from_row = 0, columns = 0, rows = 0;
    int to_column = 0, to_row = 0;
    std::string nodata = {};  ///< the stored value that is left out; empty: none
    double scale = 1.0, offset = 0.0;
};

struct Vrt {
    int width = 0, height = 0;
    std::string crs;  ///< WKT
    std::array<double, 6> transform{};
    std::string type;                 ///< "Int16"
    std::string nodata;               ///< where no part lies
    std::vector<VrtPart> parts = {};  ///< later ones lie over earlier ones
    bool masked = false;              ///< the mask is that of the first part's source
    std::string unit = {};
    double scale = 1.0, offset = 0.0;

    std::string text() const;
};

/// A file in GDAL's memory, gone with the object.
class MemoryFile {
  public:
    /// A name alone, for GDAL to write to.
    MemoryFile();
    explicit MemoryFile(std::string text);
    MemoryFile(MemoryFile&& other) noexcept
        : text_(std::move(other.text_)), name_(std::exchange(other.name_, std::string())) {}
    MemoryFile& operator=(MemoryFile&&) = delete;
    ~MemoryFile();

    const std::string& name() const { return name_; }

  private:
    std::unique_ptr<std::string> text_;  ///< GDAL reads it where it is
    std::string name_;
};

}  // namespace dsphere::geo
