#pragma once

#include "scene/scene.h"

#include <string>

namespace dsphere {

/// What a heightmap given in place of a scene shows: the map over its own range of values as a matte sphere of radius
/// 1, displaced by 5 %, NaNs filled, under one sun, from 18 degrees north of the middle of the map; east to the right.
Scene heightmapScene(const std::string& map_path);

}  // namespace dsphere
