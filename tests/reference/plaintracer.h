#pragma once

#include "reference/tracer.h"

#include <vector>

namespace dsphere::reference::test {

/// Of a scene without displaced spheres.
inline Tracer plainTracer(const Scene& scene) {
    return Tracer(scene, std::vector<const Heightmap*>(scene.shapes.size()), std::vector<Relief>(scene.shapes.size()));
}

}  // namespace dsphere::reference::test
