#pragma once

#include "render/progressivefilm.h"

#include <optional>

namespace dsphere::viewer {

struct Pick {
    dvec3 point;      ///< world
    double distance;  ///< from the eye
    int shape;        ///< index in Scene::shapes
};

/// Traces the ray of one pixel with the exact marcher.
class Picker {
  public:
    Picker(gpu::Device& device, Renderer& renderer);

    /// Of pixel (x, y) of the renderer's present film; unset on a miss or beside the film.
    std::optional<Pick> at(int x, int y);

  private:
    Renderer& renderer_;
    DeviceFilm film_;
    FilmTracer tracer_;
};

}  // namespace dsphere::viewer
