#pragma once

#include "viewer/document.h"
#include "viewer/picker.h"
#include "viewer/show.h"

#include <array>
#include <future>
#include <memory>
#include <optional>
#include <string>

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

    /// Takes the film for pictures of `show` of width x height, with shadows or without; true if its old one had to go.
    bool prepareFilm(Show show, bool shadows, int width, int height);
    /// That was taken last.
    LiveFilm& film() { return *films_[film_in_use_]; }
    const LiveFilm& film() const { return *films_[film_in_use_]; }
    bool shadows() const { return film_in_use_ == 0; }
    /// Starts a picture with the present camera.
    void begin(const ViewSettings& view, Sampling sampling);
    /// On a device that will need drafts without shadows: so that the first of them is not held up by their shaders,
    /// which were translated on another thread meanwhile. Does nothing before these are, or a second time.
    void makeDraftsReady(const ViewSettings& view);

    /// The ray of the film's pixel that holds a point, given as shares of the window.
    std::optional<Pick> pick(const dvec2& share);

  private:
    bool makeRoom(std::size_t film, std::uint32_t mask, int width, int height);

    gpu::Device& device_;
    std::unique_ptr<Document> document_;
    Renderer renderer_;
    std::array<std::optional<LiveFilm>, 2> films_;  ///< with cast shadows, without
    std::size_t film_in_use_ = 0;
    std::optional<Picker> picker_;
    MarchMethod method_;
    std::future<void> translating_;
};

/// WarmUp of a device: on a CPU, whose driver leaves most of the work for the first dispatch, by way of another device
/// of the same kind and the driver's own cache.
void warmUp(gpu::Device& device, const std::string& selector, const SceneTraits& traits, const MarchMethod& method);

}  // namespace dsphere::viewer
