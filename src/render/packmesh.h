#pragma once

#include "scene/scene.h"
#include "shaders/layout.h"

#include <vector>

namespace dsphere {

/// Appends the triangles and points the object to them; returns the length that is 1 on the device, the distance of the
/// farthest corner from its middle, which is the origin there.
double packMesh(layout::ObjectData& object, const TriangleMesh& mesh, std::vector<layout::TriangleData>& triangles);

}  // namespace dsphere
