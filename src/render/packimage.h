#pragma once

#include "shaders/layout.h"
#include "surface/colourmap.h"

#include <cstdint>
#include <vector>

namespace dsphere {

/// The centres of an image's texel columns and rows on one object, for the shader: see BINDING_EDGES.
struct PackedCentres {
    std::vector<layout::vec4> columns, rows;
};

/// How its texels lie on the device: IMAGE_CODES or IMAGE_FLOATS.
int imageKind(const ColourMap& image);

/// Fills the object's image fields but for its place in the images. `object.kind` and `inner_squared` must be set;
/// `longitude_origin` is the image's in degrees (displaced spheres), `inner` the disk's inner radius as a share of its
/// radius.
PackedCentres packImage(layout::ObjectData& object, const ColourMap& image, double longitude_origin, double inner);

/// An image's words as they lie on the device: rows of width() words, height() of them, or three times as many for
/// IMAGE_FLOATS.
class ImageWords {
  public:
    explicit ImageWords(const ColourMap& image) : image_(&image) {}

    const std::string& path() const { return image_->path(); }
    int width() const { return image_->width(); }
    int height() const { return codes() ? image_->height() : 3 * image_->height(); }
    /// Appends row j.
    void appendRow(int j, std::vector<std::uint32_t>& words) const;

  private:
    bool codes() const { return imageKind(*image_) == IMAGE_CODES; }

    const ColourMap* image_;
};

/// The light of the 256 sRGB codes, bits of floats: the first row of the images on the device.
std::vector<std::uint32_t> codeWords();

}  // namespace dsphere
