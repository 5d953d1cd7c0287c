#pragma once

#include "cli/mapoptions.h"
#include "render/renderer.h"
#include "scene/scene.h"

#include <CLI/CLI.hpp>

#include <cstdint>
#include <optional>
#include <vector>

namespace dsphere::cli {

/// Options that choose a scene, or override what it says.
struct SceneOptions {
    std::string scene;
    std::vector<int> resolution;
    std::vector<double> crop;
    std::optional<int> samples, seed;
    std::vector<double> latlon;            ///< --lookat-latlon: degrees, degrees, radii above the ground
    std::optional<double> heading, pitch;  ///< degrees; with latlon
    double exaggeration = 1.0;
    bool quick = false;
    std::uint64_t memory_limit = 0;  ///< bytes for heights, see loadSceneMaps; 0: unlimited
    MapOptions map;
    Marcher marcher = Marcher::Exact;
};

void addSceneOptions(CLI::App& command, SceneOptions& options);

/// Whether a file named in place of a scene is a heightmap.
bool isHeightmap(const std::string& name);

/// Parses the scene, or makes the one that shows a heightmap, and applies the overrides. Error (Usage) for values out
/// of range, (InvalidInput) for the scene.
Scene loadScene(const SceneOptions& options);

}  // namespace dsphere::cli
