#pragma once

#include "render/renderer.h"

#include <optional>

namespace dsphere {

/// The levels of detail that a method needs.
inline Levels levelsOf(const MarchMethod& method) {
    return method.detail > 0.0f ? Levels::All : Levels::Finest;
}

/// A scene on a device whose camera, lights and displacements change from picture to picture, while maps, images and
/// pipelines stay.
class MovingScene {
  public:
    /// `maps`: what loadSceneMaps() has read of the scene; `packed`: what packScene() has made of both, with the levels
    /// that levelsOf() says.
    MovingScene(gpu::Device& device, Scene scene, SceneMaps maps, PackedScene packed, const MarchMethod& method);

    /// Takes a scene that differs from the one before in nothing else. What is rendered then is, bit for bit, what a
    /// MovingScene made with it renders. Error (InvalidInput) as makeRelief() has them.
    void change(Scene scene);

    const Scene& scene() const { return scene_; }
    const SceneMaps& maps() const { return maps_; }
    Renderer& renderer() { return *renderer_; }

  private:
    void repack();

    gpu::Device& device_;
    MarchMethod method_;
    Scene scene_;
    SceneMaps maps_;
    PackedScene packed_;
    std::optional<Renderer> renderer_;
};

}  // namespace dsphere
