#pragma once

// Frames of an animation, by one process.

#include "cli/renderoptions.h"

namespace dsphere::cli {

/// Renders and writes them; returns the exit code. `scene` gets the camera that the options place.
int renderAnimation(const RenderOptions& options, Scene& scene, const MarchMethod& method);

}  // namespace dsphere::cli
