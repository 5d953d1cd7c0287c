#pragma once

#include "base/image.h"
#include "base/notice.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace dsphere {

/// A heightmap file as stored: one value a texel, first row northmost. Integers of 8 and 16 bits are exact in float.
/// Several colour channels are averaged in float (equal ones keep the value exactly). No gamma is ever applied.
struct RawMap {
    int width = 0, height = 0;
    std::vector<float> samples;  ///< row-major, width * height, as stored
    double full_scale = 1.0;     ///< the stored value that means h = 1: 255, 65535, a PGM's maxval, 32767 for signed 16
                                 ///< bits; 1 for floats and EXR
    bool gridline = false;       ///< the format's own default registration (GTX)
    std::optional<double> longitude_origin;           ///< degrees at the left edge, where the format says it (GTX)
    std::optional<double> value_scale, value_offset;  ///< height in `unit` = value_offset + value_scale * stored
    std::string unit;                                 ///< of heights, where the file says it: "m"
    std::string type;                                 ///< "16-bit PNG", "float32 GTX": for messages and reports
    /// The file itself says which texels are unknown (a nodata value, alpha, a mask): their samples are NaN, and they
    /// are filled like those of the scene's `nodata`.
    bool unknown_are_nan = false;
    Notices notices;  ///< what the reader has to say of the file
};

/// Reads PNG 8/16, PGM/PPM (P2 P3 P5 P6, 8/16 bit), TIFF (8/16 bit, signed or not, float32), EXR, PFM or GTX; the
/// content decides, except GTX, which has no magic and goes by its extension. Throws Error (InvalidInput) naming the
/// file and what is wrong: unknown format, truncated, absurd size (a side over 2^20 or more than 2^31 texels).
/// Non-finite samples are NOT refused here: see Heightmap. Nothing is allocated on an unchecked header: the file's
/// length must cover what the header promises.
RawMap readRawMap(const std::filesystem::path& path);

/// Whether a file is for readRawMap rather than a scene: the content decides, where it says nothing (it is empty,
/// missing or text) the extension. Never throws.
bool looksLikeMap(const std::filesystem::path& path);

}  // namespace dsphere
