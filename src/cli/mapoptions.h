#pragma once

#include "scene/scene.h"

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace dsphere::cli {

/// What a scene file says of a displaced sphere and its map, for a map that stands in for a scene. Named and bounded as
/// the parameters of Shape "displacedsphere" are.
struct MapOptions {
    std::optional<double> nodata, longitude_origin, height_scale, radius, max_displacement, midlevel, blur, height_min,
        height_max;
    std::optional<Registration> registration;
    std::optional<Filter> filter;
    std::optional<int> band;

    bool operator==(const MapOptions&) const = default;
};

void addMapOptions(CLI::App& command, MapOptions& options);

/// Error (Usage) if any is given: `scene` says these things itself.
void requireNone(const MapOptions& options, const std::string& scene);

/// Overrides what is given. Error (Usage) where two exclude each other.
void applyTo(DisplacedSphere& sphere, const MapOptions& options);

/// applyTo() for the whole scene that shows a map: with another radius the camera moves out as the planet grows.
void applyTo(Scene& scene, const MapOptions& options);

}  // namespace dsphere::cli
