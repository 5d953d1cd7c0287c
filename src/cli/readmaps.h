#pragma once

#include "cli/commands.h"
#include "cli/sceneoptions.h"
#include "surface/scenemaps.h"

namespace dsphere::cli {

/// loadSceneMaps with the options' memory limit. Progress is shown while a large map is read for the first time; Ctrl-C
/// then ends it with an Error (Interrupted).
SceneMaps readMaps(const Scene& scene, const SceneOptions& options, const CommonOptions& common);

}  // namespace dsphere::cli
