#pragma once

#include "bench/workload.h"
#include "render/raster.h"

namespace dsphere::bench {

/// World lengths that a pixel of a view spans at a distance t of the camera.
struct PixelSize {
    double constant, per_distance;

    explicit PixelSize(const View& view) {
        const Raster raster = makeRaster(view.camera, view.film);
        const dvec3 middle = raster.direction.at(0.5 * view.film.width, 0.5 * view.film.height);
        constant = glm::length(raster.start.right);
        per_distance = glm::length(raster.direction.right) / glm::length(middle);
    }
    double at(double t) const { return constant + per_distance * t; }
};

}  // namespace dsphere::bench
