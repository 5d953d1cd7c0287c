#pragma once

// A heightmap as JSON, for `dsphere info`.

#include "cli/describe.h"

namespace dsphere::cli {

/// A map given in place of a scene; its notices go to standard error. Of a map of more than kLargeMapTexels that can be
/// read in windows the texels are read only if `scan` is true.
Json describeMapFile(const std::string& path, bool scan);
/// A map of a scene, as its shapes read it.
Json describeMap(const SceneMaps& maps, int index);

}  // namespace dsphere::cli
