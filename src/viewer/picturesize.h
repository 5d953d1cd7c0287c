#pragma once

#include "gpu/device.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace dsphere::viewer {

/// The picture for a part of the window, width and height in pixels: as large, or where the devices that render and
/// present cannot hold that, the largest of about the same shape that they can.
inline std::array<int, 2> boundedPicture(const std::array<int, 2>& area, const gpu::Limits& renders,
                                         const gpu::Limits& presents) {
    // Codes of four bytes a pixel for the window; a film of at most ten planes of as many.
    const double bytes = double(
        std::min({renders.max_storage_buffer_range, renders.max_allocation_size / 10, presents.max_allocation_size}));
    const double side = double(std::min(renders.max_image_dimension_2d, presents.max_image_dimension_2d));
    const double width = area[0], height = area[1];
    const double scale = std::min({1.0, std::sqrt(bytes / (4.0 * width * height)), side / width, side / height});
    if (scale == 1.0) return area;
    return {std::max(1, int(scale * width)), std::max(1, int(scale * height))};
}

}  // namespace dsphere::viewer
