#pragma once

#include "query/bake.h"

#include <functional>
#include <string>
#include <vector>

namespace dsphere::query {

struct BakeWishes {
    std::vector<std::string> quantities = {};  ///< some of bakeQuantities()
    std::vector<Sun> suns = {};                ///< of "lit", a layer each
    int samples = 64;                          ///< of a sun's disc, of the sky, of lights that have an extent
    int azimuths = 8;                          ///< of "horizon", a layer each
    double horizon_bound = 0.01;               ///< degrees
};

/// A plane of the result, that is yet to be made.
struct Layer {
    std::string name;
    std::string unit = {};             ///< "degree", "m"; empty: none, or unknown
    float low = 0.0f, high = 1.0f;     ///< what 0 and 65535 mean in 16 bits; NaN: the plane's own range
    double scale = 1.0, offset = 0.0;  ///< a value means offset + scale * value, in `unit`
    std::function<std::vector<float>()> make = {};
};

/// What can be baked: lit, normal, slope, aspect, height, colour, sky, horizon.
const std::vector<std::string>& bakeQuantities();

/// The layers of each quantity in turn. The baker must outlive them.
std::vector<Layer> planLayers(Baker& baker, const BakeWishes& wishes);

}  // namespace dsphere::query
