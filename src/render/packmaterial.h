#pragma once

#include "render/pathtables.h"
#include "scene/scene.h"
#include "shaders/layout.h"
#include "surface/heightmap.h"

#include <vector>

namespace dsphere {

/// The fields of an object that hold its material's colour: of a texture, or what stands for one.
void packColour(layout::ObjectData& object, const Shape& shape, const Relief& relief);

/// One per object; with a regularising integrator, its regularized() one MAX_OBJECTS later.
std::vector<layout::MaterialData> packMaterials(const Scene& scene, const PathTables& tables);

}  // namespace dsphere
