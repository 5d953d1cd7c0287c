#pragma once

#include "scene/parameters.h"
#include "scene/scene.h"

namespace dsphere {

/// Notes parameter N, one normal for each point given, if every triangle's corners have the triangle's own normal or
/// its opposite (meshes are two-sided): the light is the same without them. Reports it otherwise.
/// Corner k of triangle t is given point corners[3 t + k].
void ignoreFlatNormals(Parameters& p, const TriangleMesh& mesh, const std::vector<int>& corners);

}  // namespace dsphere
