#pragma once

#include "base/math.h"
#include "scene/scene.h"

namespace dsphere::reference {

struct CameraRay {
    dvec3 origin, direction;  ///< world; direction is unit
};

/// The ray through raster position (x, y) of the whole film (not of its crop): pixels, y downward, pixel centres at
/// + 0.5. pbrt's cameras: perspective, the screen window at tan(fov / 2), or orthographic,
/// the window in camera units; y up.
CameraRay cameraRay(const Camera& camera, const Film& film, double x, double y);

}  // namespace dsphere::reference
