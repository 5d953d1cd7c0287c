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

    /// Takes the film of drafts or that of stills for a picture of `show` of width x height; true if its old one had
    /// to go. Each has its own, since drafts are smaller: a film is cleared as a whole.
    bool prepareFilm(Show show, bool draft, int width, int height);
    /// That was taken last.
    ProgressiveFilm& film() { return *films_[film_in_use_]; }
    const ProgressiveFilm& film() const { return *films_[film_in_use_]; }
    /// Starts a picture with the present camera; without `shadows` light fades beyond horizons instead.
    void begin(const ViewSettings& view, Sampling sampling, bool shadows);
    bool shadows() const { return shadows_; }  ///< of the picture that was started last
    /// For a document that will need drafts by draftMethod(): so that the first of them is not held up by its shaders,
    /// which were translated on another thread meanwhile. Does nothing before these are, or a second time.
    void makeDraftsReady(const ViewSettings& view);

    /// The ray of the film's pixel that holds a point, given as shares of the window.
    std::optional<Pick> pick(const dvec2& share);

  private:
    MarchMethod draftMethod(MarchMethod method) const;
    bool makeRoom(std::size_t film, std::uint32_t mask, int width, int height);

    gpu::Device& device_;
    std::unique_ptr<Document> document_;
    Renderer renderer_;
    std::array<std::optional<ProgressiveFilm>, 2> films_;  ///< of stills, of drafts
    std::size_t film_in_use_ = 0;
    bool shadows_ = true;
    std::optional<Picker> picker_;
    MarchMethod method_;
    std::future<void> translating_;
};

/// WarmUp of a device: on a CPU, whose driver leaves most of the work for the first dispatch, by way of another device
/// of the same kind and the driver's own cache.
void warmUp(gpu::Device& device, const std::string& selector, const SceneTraits& traits, const MarchMethod& method);

}  // namespace dsphere::viewer
