#pragma once

#include "surface/heightmap.h"

#include <memory>
#include <vector>

namespace dsphere {

/// The heightmaps of a scene, each distinct one loaded once, and what each shape makes of its map.
struct SceneMaps {
    std::vector<std::unique_ptr<Heightmap>> maps;
    std::vector<int> map_of_shape;  ///< index in `maps`; -1 for shapes that are no displaced sphere
    std::vector<Relief> reliefs;    ///< one a shape; defaults for shapes without a map

    /// One pointer a shape, nullptr without a map.
    std::vector<const Heightmap*> perShape() const;
};

/// Loads every map of the scene. Errors as loadHeightmap and makeRelief, prefixed by the shape's place in the scene.
SceneMaps loadSceneMaps(const Scene& scene);

}  // namespace dsphere
