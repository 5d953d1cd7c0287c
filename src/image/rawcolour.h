#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace dsphere {

/// A colour image: R, G, B of each texel, row-major, first row on top. One of the two vectors is filled. Alpha is left
/// out; a grey image has three equal channels.
struct RawColour {
    int width = 0, height = 0;
    std::vector<std::uint8_t> srgb;  ///< 8-bit images: sRGB codes, as stored
    std::vector<float> linear;       ///< all others: light; 16-bit codes are decoded from sRGB, floats are as stored
    std::string type;                ///< "8-bit JPEG": for messages and reports
};

/// Reads JPEG, PNG 8/16, PGM/PPM (8/16 bit), TIFF (8/16 bit, float32), EXR (R G B, or Y) or PFM; the content decides.
/// Throws Error (InvalidInput) naming the file and what is wrong, as readRawMap does. Non-finite values are NOT refused
/// here: see ColourMap.
RawColour readRawColour(const std::filesystem::path& path);

}  // namespace dsphere
