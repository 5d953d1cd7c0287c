#pragma once

#include "image/picture.h"
#include "render/samplesums.h"

#include <filesystem>

namespace dsphere::cli {

/// What two runs must have in common for their samples to make one picture, bit for bit.
struct Origin {
    int seed = 0;
    std::string fingerprint;  ///< of the scene, its maps and the options that decide the light
    std::string device, driver, software;
    Box data, display;
};

/// An earlier render of the same.
struct Earlier {
    SampleSums sums;
    double device_seconds = 0.0;
};

/// Reads what `render` wrote. Error (InvalidInput) that says what differs when it is of another origin, or no picture
/// that can go on; Error (Usage) unless it lacks some of the samples `first` to `last` - 1.
Earlier readEarlier(const std::filesystem::path& path, const Origin& origin, int first, int last);

}  // namespace dsphere::cli
