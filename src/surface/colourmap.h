#pragma once

#include "base/math.h"
#include "image/rawcolour.h"

#include <filesystem>

namespace dsphere {

/// An image texture in linear light. Texel (i, j) is centred at ((i + 0.5) / width, (j + 0.5) / height), row 0 on top.
class ColourMap {
  public:
    /// Error (InvalidInput), naming `path`, when a value is not finite.
    ColourMap(RawColour raw, const std::string& path);

    int width() const { return raw_.width; }
    int height() const { return raw_.height; }
    const RawColour& raw() const { return raw_; }
    const std::string& path() const { return path_; }

    /// 0 <= i < width, 0 <= j < height.
    dvec3 texel(int i, int j) const;
    /// The mean of the first (last) row: the colour of a displaced sphere's pole.
    const dvec3& north() const { return north_; }
    const dvec3& south() const { return south_; }

  private:
    dvec3 meanOfRow(int j) const;

    RawColour raw_;
    std::string path_;
    dvec3 north_{0.0}, south_{0.0};
};

/// The light of each 8-bit sRGB code.
double linearFromCode(std::uint8_t code);

ColourMap loadColourMap(const std::string& path);

}  // namespace dsphere
