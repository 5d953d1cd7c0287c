#pragma once

#include "viewer/document.h"
#include "viewer/picker.h"
#include "viewer/show.h"

#include <future>
#include <memory>
#include <optional>

namespace dsphere::viewer {

/// A document on the device, and the picture of it that grows.
class Stage {
  public:
    Stage(gpu::Device& device, std::unique_ptr<Document> document, const MarchMethod& method);

    Document& document() { return *document_; }
    const Document& document() const { return *document_; }

    /// Gives the renderer this camera and a film of width x height.
    void setCamera(const Camera& camera, int width, int height);
    /// Takes the lights and the constant and ramp colours of a scene.
    void updateLook(const Scene& scene);
    /// Takes a new packing that retune() made of this scene's reliefs.
    void updateRelief(PackedScene packed, const Scene& scene);

    /// Room for pictures of `show` of width x height; true if the old film had to go.
    bool prepareFilm(Show show, int width, int height);
    bool hasFilm() const { return film_.has_value(); }
    LiveFilm& film() { return *film_; }
    /// Starts a picture with the present camera.
    void begin(const ViewSettings& view, Sampling sampling, bool shadows);
    /// On a device that will need drafts without shadows: so that the first of them is not held up by their shaders,
    /// which were translated on another thread meanwhile. Does nothing before these are, or a second time.
    void makeDraftsReady(const ViewSettings& view);

    /// The ray of the film's pixel that holds a point, given as shares of the window.
    std::optional<Pick> pick(const dvec2& share);

  private:
    gpu::Device& device_;
    std::unique_ptr<Document> document_;
    Renderer renderer_;
    std::optional<LiveFilm> film_;
    std::optional<Picker> picker_;
    MarchMethod method_;
    std::future<void> translating_;
};

}  // namespace dsphere::viewer
