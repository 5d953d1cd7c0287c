#pragma once

#include "base/image.h"
#include "base/math.h"
#include "scene/scene.h"

namespace dsphere {

/// A vector or point of world space that is linear in the raster position (x, y): pixels of the whole film, x to the
/// right, y downward, pixel centres at + 0.5.
struct RasterLinear {
    dvec3 origin, right, down;

    dvec3 at(double x, double y) const { return origin + x * right + y * down; }
};

/// The camera's rays: both where they start and their directions (not normalised) are linear in the raster position. A
/// perspective camera's start is constant, an orthographic one's direction.
struct Raster {
    RasterLinear start, direction;
    dmat4 camera_from_world;
    Projection projection;
    dvec2 screen_min,
        screen_max;  ///< camera coordinates (at z = 1 in perspective) of the film's left bottom, right top
    int width, height;

    /// Raster position of a world point; the film's middle if it is not in front of a perspective camera.
    dvec2 project(const dvec3& world) const;
};

Raster makeRaster(const Camera& camera, const Film& film);

/// The pixels that the film's crop window holds, as pbrt rounds it.
Box cropBox(const Film& film);

}  // namespace dsphere
