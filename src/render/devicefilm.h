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
    /// Takes the first data.width() x data.height() pixels of the mask's float planes from channels of their names.
    void write(const Image& image);
    /// The planes as channels: of the film's first data.width() x data.height() pixels, which become those of `data`.
    Image read(const Box& data, const Box& display) const;

  private:
    gpu::StorageImage image_;
    std::uint32_t mask_;
};

/// Turns sums over `samples` into means.
void takeMean(Image& sums, int samples);

}  // namespace dsphere
