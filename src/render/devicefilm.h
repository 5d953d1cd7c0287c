#pragma once

#include "base/image.h"
#include "gpu/image.h"

#include <cstdint>

namespace dsphere {

/// The planes of one mask on the device, a layer each in the order of planeInfos().
class DeviceFilm {
  public:
    /// Zeroed.
    DeviceFilm(gpu::Device& device, int width, int height, std::uint32_t mask);

    const gpu::StorageImage& image() const { return image_; }
    std::uint32_t mask() const { return mask_; }
    void clear() { image_.clear(); }
    /// A channel of zeros for each plane.
    Image blank(const Box& data, const Box& display) const;
    /// Fills the film from its first pixel on with these rows of an image, which has channels for the planes, all
    /// float.
    void write(const Image& image, const Box& rows);
    /// Fills these rows of an image that has channels for the planes.
    void read(Image& image, const Box& rows) const;
    /// blank() filled from the film's first pixel on.
    Image read(const Box& data, const Box& display) const;

  private:
    gpu::StorageImage image_;
    std::uint32_t mask_;
};

/// Turns sums over `samples` into means.
void takeMean(Image& sums, int samples);

}  // namespace dsphere
