#pragma once

#include <cstdint>
#include <vector>

namespace dsphere::bench {

/// Rays of a packet: 4x4 pixels.
inline constexpr int kPacketSize = 16;

/// Indices of a picture's pixels, 4x4 blocks one after another; blocks at the right and lower edge are smaller.
inline std::vector<std::uint32_t> packetOrder(int width, int height) {
    constexpr int kSide = 4;
    std::vector<std::uint32_t> order;
    order.reserve(std::size_t(width) * std::size_t(height));
    for (int y0 = 0; y0 < height; y0 += kSide)
        for (int x0 = 0; x0 < width; x0 += kSide)
            for (int y = y0; y < y0 + kSide && y < height; ++y)
                for (int x = x0; x < x0 + kSide && x < width; ++x) order.push_back(std::uint32_t(y * width + x));
    return order;
}

}  // namespace dsphere::bench
