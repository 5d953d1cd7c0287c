#pragma once

#include "scene/scene.h"

namespace dsphere {

/// East, north and up at a place of a displaced sphere, in its own space; unit vectors.
struct LocalFrame {
    dvec3 east, north, up;
};

/// Degrees.
LocalFrame localFrameAt(double latitude, double longitude);

/// A place above the first displaced sphere of a scene and a direction from there.
struct GlobeView {
    double latitude = 0.0, longitude = 0.0;  ///< degrees
    double distance = 2.0;                   ///< from the sphere's centre, in its own space
    double heading = 0.0;                    ///< degrees from north towards east
    double pitch = -90.0;                    ///< degrees above the horizontal; -90 looks straight down
};

/// Index of the scene's first displaced sphere, or -1.
int firstDisplacedSphere(const Scene& scene);

/// Places the camera there: upright, with what is right of the heading on the right of the picture. The scene has a
/// displaced sphere.
void lookFrom(Scene& scene, const GlobeView& view);

}  // namespace dsphere
