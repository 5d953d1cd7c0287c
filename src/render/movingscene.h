#pragma once

#include "render/method.h"
#include "render/pack.h"
#include "render/scenerenderer.h"

#include <functional>
#include <memory>

namespace dsphere {

/// The levels of detail that a method needs.
inline Levels levelsOf(const MarchMethod& method) {
    return method.detail > 0.0f ? Levels::All : Levels::Finest;
}

/// Makes the renderer of a packed scene, which outlives it.
using MakeRenderer = std::function<std::unique_ptr<SceneRenderer>(const PackedScene& packed, const Scene& scene)>;

/// A scene on a device whose camera, lights and displacements change from picture to picture, while maps, images and
/// pipelines stay.
class MovingScene {
  public:
    /// `maps`: what loadSceneMaps() has read of the scene; `packed`: what packScene() has made of both with `levels`,
    /// those of the renderers' method.
    MovingScene(MakeRenderer make_renderer, Scene scene, SceneMaps maps, PackedScene packed, Levels levels);

    /// Takes a scene that differs from the one before in nothing else. What is rendered then is, bit for bit, what a
    /// MovingScene made with it renders. Error (InvalidInput) as makeRelief() has them.
    void change(Scene scene);

    const Scene& scene() const { return scene_; }
    const SceneMaps& maps() const { return maps_; }
    SceneRenderer& renderer() { return *renderer_; }

  private:
    void repack();

    MakeRenderer make_renderer_;
    Levels levels_;
    Scene scene_;
    SceneMaps maps_;
    PackedScene packed_;
    std::unique_ptr<SceneRenderer> renderer_;
};

}  // namespace dsphere
