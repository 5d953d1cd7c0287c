#pragma once

#include "base/image.h"
#include "gpu/commands.h"
#include "gpu/pipeline.h"
#include "render/devicescene.h"
#include "render/planes.h"
#include "render/spans.h"

#include <compare>
#include <functional>
#include <map>
#include <memory>
#include <utility>

namespace dsphere {

/// Order as MARCHER_ of layout.h.
enum class Marcher { Exact, Naive, NaiveShell, Lipschitz };

/// How rays find hits; a marcher alone stands for it with its defaults.
struct MarchMethod {
    Marcher marcher = Marcher::Exact;
    float threshold = 3e-6f;  ///< baselines: a hit where |p| - r falls under it, units of R

    MarchMethod(Marcher chosen = Marcher::Exact, float hit_below = 3e-6f) : marcher(chosen), threshold(hit_below) {}
    auto operator<=>(const MarchMethod&) const = default;
};

struct RenderStats {
    double device_seconds = 0.0;  ///< of all dispatches, pipelines warm
    double wall_seconds = 0.0;    ///< of the same on the host's clock, submissions and waits included
    std::uint64_t camera_rays = 0;
};

/// Called with the share of the work that is done, 0 to 1; false stops the render.
using Progress = std::function<bool(double)>;

/// Renders one scene on one device. The packed scene and device must outlive it.
class Renderer {
  public:
    Renderer(gpu::Device& device, const PackedScene& packed, const Scene& scene, const MarchMethod& method);

    /// Takes the camera and film of `scene`; packCamera has given them to the packed scene before.
    void setCamera(const Scene& scene);
    /// For the renders that follow. Pipelines of methods used before are kept.
    void setMethod(const MarchMethod& method) { method_ = method; }

    /// R, G, B: the mean of `samples` jittered samples a pixel (1 to 65536). Error (Interrupted) when stopped.
    Image renderColour(int samples, std::uint32_t seed, const Progress& progress);
    /// The planes of `mask` for the ray through each pixel's centre; kColourPlanes among them are that ray's colour.
    Image renderPlanes(std::uint32_t mask, const Progress& progress);

    const RenderStats& stats() const { return stats_; }
    std::uint64_t mapBytes() const { return device_scene_.mapBytes(); }

  private:
    struct Film;
    struct Pass;

    Image render(std::uint32_t mask, int samples, std::uint32_t seed, const Progress& progress);
    void runTiles(Pass& pass, int sample, double done_before, double share, const Progress& progress);
    const gpu::ComputePipeline& pipelineFor(std::uint32_t mask);
    void fillMisses(Image& image) const;

    gpu::Device& device_;
    const PackedScene& packed_;
    DeviceScene device_scene_;
    gpu::Batch batch_;
    MarchMethod method_;
    std::map<std::pair<MarchMethod, std::uint32_t>, gpu::ComputePipeline> pipelines_;  ///< by method and planes
    Box crop_, display_;
    std::vector<Span> spans_;  ///< one a row of the crop
    std::vector<Box> tiles_;   ///< what is dispatched, in film pixels
    RenderStats stats_;
};

}  // namespace dsphere
