#pragma once

#include "base/image.h"
#include "base/notice.h"

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace dsphere {

/// The part of a planet that a file covers, in degrees, east positive.
struct MapExtent {
    double west = -180.0, east = 180.0, south = -90.0, north = 90.0;
};

/// What a file says of its values and its place besides the samples.
struct MapFacts {
    /// A stored value means value_offset + value_scale * stored, in `unit`; unset where the file does not say.
    std::optional<double> value_scale, value_offset;
    std::string unit;  ///< "m" for all lengths, which are converted; else as the file has it; empty: unknown
    std::optional<double> radius;   ///< metres from the centre that heights count from: the datum's, or value_offset
    bool offset_is_radius = false;  ///< values count from the centre, and value_offset is the radius
    std::optional<MapExtent> extent;
    std::string projection;  ///< "geographic", "equirectangular"; empty: unknown
    /// Where each of these properties came from, by its name in `dsphere info`: "radius" -> "label".
    std::map<std::string, std::string> sources;

    /// The height in `unit` above `radius` that a stored value means.
    double heightOf(double stored) const {
        return value_scale.value_or(1.0) * stored + (offset_is_radius ? 0.0 : value_offset.value_or(0.0));
    }
};

/// A heightmap file as stored: one value a texel, first row northmost. Integers of 8 and 16 bits are exact in float.
/// Several colour channels are averaged in float (equal ones keep the value exactly). No gamma is ever applied.
struct RawMap {
    int width = 0, height = 0;
    std::vector<float> samples;  ///< row-major, width * height, as stored
    double full_scale = 1.0;     ///< the stored value that means h = 1: 255, 65535, a PGM's maxval, 32767 for signed 16
                                 ///< bits; 1 for floats and EXR
    bool gridline = false;       ///< the format's own default registration (GTX)
    std::optional<double> longitude_origin;  ///< degrees at the left edge, where the file says it
    std::string type;                        ///< "16-bit PNG", "float32 GTX": for messages and reports
    /// The file itself says which texels are unknown (a nodata value, alpha, a mask): their samples are NaN, and they
    /// are filled like those of the scene's `nodata`.
    bool unknown_are_nan = false;
    MapFacts facts;
    Notices notices;  ///< what the reader has to say of the file
};

/// Reads PNG 8/16, PGM/PPM (P2 P3 P5 P6, 8/16 bit), TIFF (8/16 bit, signed or not, float32), EXR, PFM or GTX; the
/// content decides, except GTX, which has no magic and goes by its extension. Throws Error (InvalidInput) naming the
/// file and what is wrong: unknown format, truncated, absurd size (a side over 2^20 or more than 2^31 texels).
/// Non-finite samples are NOT refused here: see Heightmap. TIFF's tags of place and meaning are NOT read here: see
/// geo/readmap.h, which everything but the tests of this reader goes through. Nothing is allocated on an unchecked
/// header: the file's length must cover what the header promises.
RawMap readRawMap(const std::filesystem::path& path);

/// Whether a file is for readRawMap rather than a scene: the content decides, where it says nothing (it is empty,
/// missing or text) the extension. Never throws.
bool looksLikeMap(const std::filesystem::path& path);

}  // namespace dsphere
