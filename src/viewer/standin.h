#pragma once

#include "scene/scene.h"

namespace dsphere::viewer {

/// A scene of the same shapes, in the same places and order, that the shaders without paths can draw: materials become
/// matte, lamps become points, the sky becomes a lamp at the camera. Flat meshes become disks, others are hidden, as
/// lamps are.
Scene standIn(const Scene& scene);

}  // namespace dsphere::viewer
