#pragma once

#include "base/image.h"
#include "base/math.h"
#include "scene/scene.h"

namespace dsphere {

/// The camera's rays as a linear function of the raster position: the ray through (x, y) has the world direction
/// `origin + x right + y down` (not normalised), x and y in pixels of the whole film, pixel centres at + 0.5.
struct Raster {
    dvec3 eye;  ///< world
    dvec3 origin, right, down;
    dmat4 camera_from_world;
    dvec2 screen_min, screen_max;  ///< camera coordinates at z = 1 of the film's left bottom and right top
    int width, height;

    dvec3 direction(double x, double y) const { return origin + x * right + y * down; }
    /// Raster position of a world point; the film's middle if it is not in front of the camera.
    dvec2 project(const dvec3& world) const;
};

Raster makeRaster(const Camera& camera, const Film& film);

/// The pixels that the film's crop window holds, as pbrt rounds it.
Box cropBox(const Film& film);

}  // namespace dsphere
