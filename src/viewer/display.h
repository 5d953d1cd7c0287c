#pragma once

#include "gpu/commands.h"
#include "gpu/pipeline.h"
#include "render/live.h"
#include "viewer/show.h"

#include <optional>

namespace dsphere::viewer {

/// Turns films into the codes that the window shows.
class Display {
  public:
    explicit Display(gpu::Device& device);

    /// The film's complete samples, between() two; `near` and `far` are what Show::Distance ranges over, world units.
    void convert(const LiveFilm& film, Show show, const ToneSettings& tone, double near, double far);
    /// The film that was converted last is going.
    void forget() { film_ = nullptr; }
    const gpu::Buffer& pixels() const { return *pixels_; }

  private:
    void choose(Show show);

    gpu::Device& device_;
    std::optional<gpu::ComputePipeline> pipeline_;  ///< for show_
    Show show_ = Show::Colour;
    gpu::Batch batch_;
    std::optional<gpu::Buffer> pixels_;
    std::optional<gpu::BindingSet> set_;
    const LiveFilm* film_ = nullptr;  ///< that set_ binds
};

}  // namespace dsphere::viewer
