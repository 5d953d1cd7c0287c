#pragma once

// A heightmap as JSON, for `dsphere info`.

#include "cli/describe.h"

namespace dsphere::cli {

/// A map given in place of a scene; its notices go to standard error.
Json describeMapFile(const std::string& path);
/// A map of a scene, as its shapes read it.
Json describeMap(const SceneMaps& maps, int index);

}  // namespace dsphere::cli
