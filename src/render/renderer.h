#pragma once

#include "base/image.h"
#include "render/devicescene.h"
#include "render/pass.h"
#include "render/planes.h"
#include "render/samplesums.h"
#include "render/spans.h"
#include "render/tiles.h"

#include <functional>
#include <map>
#include <memory>
#include <utility>

namespace dsphere {

struct RenderStats {
    double device_seconds = 0.0;  ///< of all dispatches, pipelines warm
    double wall_seconds = 0.0;    ///< of the same on the host's clock, submissions and waits included
    std::uint64_t camera_rays = 0;
    std::uint64_t retried_pixels = 0;  ///< samples of pixels that single floats could not decide, or were spared
};

/// Called with the share of the work that is done, 0 to 1; false stops the render.
using Progress = std::function<bool(double)>;

/// Renders one scene on one device. The packed scene and device must outlive it.
class Renderer {
  public:
    Renderer(gpu::Device& device, const PackedScene& packed, const Scene& scene, const MarchMethod& method);

    /// Takes the camera and film of `scene`; packCamera has given them to the packed scene before.
    void setCamera(const Scene& scene);
    /// Takes what packLook or, `reliefs`, a new packing of the same maps has made of the packed scene.
    void update(bool reliefs);
    /// For the renders that follow. Pipelines of methods used before are kept.
    void setMethod(const MarchMethod& method) { method_ = method; }

    /// R, G, B: the mean of `samples` jittered samples a pixel (1 to 65536). Error (Interrupted) when stopped.
    Image renderColour(int samples, std::uint32_t seed, const Progress& progress);
    /// The sums of samples 0 to `to` - 1, of which `start` has some (fewer) already, from this renderer's crop. When
    /// stopped the sample in progress is completed, and the sums are of fewer than `to`. The same sums whatever
    /// `start`. `planes`: kColourPlanes, and kAlphaPlane if wanted; `start` has channels of both or is empty.
    SampleSums renderSums(SampleSums start, int to, std::uint32_t seed, const Progress& progress,
                          std::uint32_t planes = kColourPlanes);
    /// The planes of `mask` for the ray through each pixel's centre; kColourPlanes among them are that ray's colour.
    Image renderPlanes(std::uint32_t mask, const Progress& progress);

    const RenderStats& stats() const { return stats_; }
    /// For pictures of the caller's own: what this renderer's are made with.
    PassPipelines& pipelines(const MarchMethod& method, std::uint32_t mask);
    const DeviceScene& deviceScene() const { return device_scene_; }
    const Box& crop() const { return crop_; }
    const std::vector<Span>& spans() const { return spans_; }  ///< one a row of the crop
    std::uint64_t mapBytes() const { return device_scene_.mapBytes(); }
    std::uint64_t imageBytes() const { return device_scene_.imageBytes(); }

  private:
    void runTiles(Pass& pass, TileRun& run, int sample, std::uint32_t seed, const Progress& progress);
    void fillMisses(Image& image, const std::vector<Box>& tiles) const;

    gpu::Device& device_;
    const PackedScene& packed_;
    DeviceScene device_scene_;
    MarchMethod method_;
    std::map<std::pair<MarchMethod, std::uint32_t>, PassPipelines> pipelines_;  ///< by method and planes
    Box crop_, display_;
    std::vector<Span> spans_;
    RenderStats stats_;
};

}  // namespace dsphere
