#include "query/bakelayers.h"

#include <fmt/format.h>

#include <limits>
#include <memory>

namespace dsphere::query {

namespace {

constexpr float kOwnRange = std::numeric_limits<float>::quiet_NaN();
constexpr const char* kDegrees = "degree";

// "lit", or "lit.3" of several.
std::string layerName(const std::string& quantity, std::size_t k, std::size_t count) {
    return count == 1 ? quantity : fmt::format("{}.{:0{}}", quantity, k, fmt::formatted_size("{}", count - 1));
}

Layer heightLayer(Baker& baker) {
    Layer layer{.name = "height", .low = kOwnRange, .high = kOwnRange, .make = [&baker] { return baker.height(); }};
    const MapFacts& facts = baker.facts();
    layer.unit = facts.unit;
    if (!facts.unit.empty()) {
        layer.offset = facts.heightOf(0.0);
        layer.scale = facts.heightOf(1.0) - layer.offset;
    }
    return layer;
}

void addColour(std::vector<Layer>& layers, Baker& baker, int samples) {
    using Planes = std::array<std::vector<float>, 3>;
    const auto planes = std::make_shared<Planes>();  // made by the first layer that asks, given away one by one
    for (std::size_t c = 0; c < 3; ++c)
        layers.push_back(
            {.name = std::string(1, "RGB"[c]), .low = kOwnRange, .high = kOwnRange, .make = [&, planes, samples, c] {
                 if ((*planes)[c].empty()) *planes = baker.colour(samples);
                 return std::move((*planes)[c]);
             }});
}

void addLit(std::vector<Layer>& layers, Baker& baker, const BakeWishes& wishes) {
    for (std::size_t k = 0; k < wishes.suns.size(); ++k) {
        const Sun& sun = wishes.suns[k];
        layers.push_back({.name = sun.name.empty() ? layerName("lit", k, wishes.suns.size()) : "lit." + sun.name,
                          .make = [&baker, sun, samples = wishes.samples] { return baker.lit(sun, samples); }});
    }
}

void addHorizon(std::vector<Layer>& layers, Baker& baker, const BakeWishes& wishes) {
    for (int k = 0; k < wishes.azimuths; ++k)
        layers.push_back({.name = layerName("horizon", std::size_t(k), std::size_t(wishes.azimuths)),
                          .unit = kDegrees,
                          .low = -90.0f,
                          .high = 90.0f,
                          .make = [&baker, azimuth = 360.0 * k / wishes.azimuths, bound = wishes.horizon_bound] {
                              return baker.horizon(azimuth, bound);
                          }});
}

}  // namespace

const std::vector<std::string>& bakeQuantities() {
    static const std::vector<std::string> quantities{"lit",    "normal", "slope", "aspect",
                                                     "height", "colour", "sky",   "horizon"};
    return quantities;
}

std::vector<Layer> planLayers(Baker& baker, const BakeWishes& wishes) {
    std::vector<Layer> layers;
    for (const std::string& quantity : wishes.quantities) {
        if (quantity == "height") layers.push_back(heightLayer(baker));
        if (quantity == "slope")
            layers.push_back({.name = "slope", .unit = kDegrees, .high = 90.0f, .make = [&] { return baker.slope(); }});
        if (quantity == "aspect")
            layers.push_back(
                {.name = "aspect", .unit = kDegrees, .high = 360.0f, .make = [&] { return baker.aspect(); }});
        if (quantity == "sky")
            layers.push_back({.name = "sky", .make = [&, n = wishes.samples] { return baker.sky(n); }});
        for (int axis = 0; quantity == "normal" && axis < 3; ++axis)
            layers.push_back({.name = fmt::format("normal.{}", "XYZ"[axis]), .low = -1.0f, .make = [&baker, axis] {
                                  return baker.normal(axis);
                              }});
        if (quantity == "colour") addColour(layers, baker, wishes.samples);
        if (quantity == "lit") addLit(layers, baker, wishes);
        if (quantity == "horizon") addHorizon(layers, baker, wishes);
    }
    return layers;
}

}  // namespace dsphere::query
