#pragma once

#include "render/pathtables.h"
#include "scene/scene.h"
#include "shaders/layout.h"
#include "surface/scenemaps.h"

#include <vector>

namespace dsphere {

/// Lights, as seen from the first object's centre (world, that of ObjectData::from_first): a planet and its lamp may be
/// far from the origin. Image lights lack their place in the images.
std::vector<layout::LightData> packLights(const Scene& scene, const SceneMaps& maps, const PathTables& tables,
                                          const dvec3& first_centre);

}  // namespace dsphere
