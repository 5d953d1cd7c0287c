#pragma once

#include "scene/scene.h"
#include "shaders/layout.h"

#include <vector>

namespace dsphere {

/// The middle of the mesh's bounding box, object space: the origin of its space on the device.
dvec3 meshCentre(const TriangleMesh& mesh);

/// Appends the triangles and points the object to them; returns the length that is 1 on the device, the distance of the
/// farthest corner from the centre.
double packMesh(layout::ObjectData& object, const TriangleMesh& mesh, std::vector<layout::TriangleData>& triangles);

}  // namespace dsphere
