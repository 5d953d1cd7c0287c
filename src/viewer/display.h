#pragma once

#include "gpu/commands.h"
#include "gpu/pipeline.h"
#include "render/progressivefilm.h"
#include "shaders/displaylayout.h"
#include "viewer/show.h"

#include <optional>

namespace dsphere::viewer {

/// How films become what the window shows.
struct DisplaySettings {
    Show show = Show::Colour;
    ToneSettings tone;
    ShownRange range;
};

/// Turns films into the codes that the window shows.
class Display {
  public:
    explicit Display(gpu::Device& device);

    /// The film's complete samples, of which there is one, and what the next one has so far. `world` is of the document
    /// that the film shows.
    void convert(ProgressiveFilm& film, const DisplaySettings& settings, const layout::DisplayWorld& world);
    /// The film that was converted last is going.
    void forget() { film_ = nullptr; }
    /// That was converted last, and is there yet; null: none.
    ProgressiveFilm* film() const { return film_; }
    const gpu::Buffer& pixels() const { return *pixels_; }

  private:
    void choose(std::uint32_t shown);
    void bind(ProgressiveFilm& film);

    gpu::Device& device_;
    std::optional<gpu::ComputePipeline> pipeline_;  ///< for shown_
    std::uint32_t shown_ = SHOW_COLOUR;             ///< a SHOW_
    gpu::Batch batch_;
    gpu::Buffer world_;
    std::optional<gpu::Buffer> pixels_;
    std::optional<gpu::BindingSet> set_;
    ProgressiveFilm* film_ = nullptr;  ///< that set_ binds
};

}  // namespace dsphere::viewer
