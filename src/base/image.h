#pragma once

// A picture of named planar channels: what a Film ends as, what codecs write, what verify compares.

#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace dsphere {

/// A rectangle of pixels, half open: x0 <= x < x1, rows downward.
struct Box {
    int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

    int width() const { return x1 - x0; }
    int height() const { return y1 - y0; }
    bool operator==(const Box&) const = default;
};

/// One plane, row-major, first row on top; float or 32-bit unsigned.
struct Channel {
    std::string name;  ///< as in OpenEXR: "R", "P.X", "id"
    std::variant<std::vector<float>, std::vector<std::uint32_t>> pixels;

    std::vector<float>& floats() { return std::get<0>(pixels); }
    const std::vector<float>& floats() const { return std::get<0>(pixels); }
    std::vector<std::uint32_t>& uints() { return std::get<1>(pixels); }
    const std::vector<std::uint32_t>& uints() const { return std::get<1>(pixels); }
    bool isFloat() const { return pixels.index() == 0; }
};

struct Image {
    Box data;     ///< the pixels that the channels hold
    Box display;  ///< the whole picture; equals `data` unless cropped
    std::vector<Channel> channels;

    std::size_t pixelCount() const { return std::size_t(data.width()) * std::size_t(data.height()); }
    /// The channel of that name, or nullptr.
    const Channel* find(const std::string& name) const;
    /// The channel of that name; a missing one is a broken invariant.
    const Channel& at(const std::string& name) const;
    /// Appends a zeroed float (or uint) channel of pixelCount() pixels.
    Channel& addFloat(const std::string& name);
    Channel& addUint(const std::string& name);
};

}  // namespace dsphere
