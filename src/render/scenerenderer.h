#pragma once

#include "base/image.h"
#include "render/pack.h"
#include "render/planes.h"
#include "render/samplesums.h"
#include "scene/scene.h"

#include <cstdint>
#include <functional>

namespace dsphere {

struct RenderStats {
    double device_seconds = 0.0;  ///< of all dispatches, pipelines warm
    double wall_seconds = 0.0;    ///< of the same on the host's clock, submissions and waits included
    std::uint64_t camera_rays = 0;
    /// Samples of pixels that single floats could not decide, or that were left unbegun (NEXT_PIXEL_STEPS).
    std::uint64_t retried_pixels = 0;
    /// Samples of pixels for which a search met more cells than a device's loops can have turns (MAX_STEPS): they may
    /// be wrong. Only rays that skim the ground across a pole of a map wider than 46,080 meet as many.
    std::uint64_t given_up_pixels = 0;
    std::uint64_t tiles_read = 0;  ///< of maps that stay in their file, and their bytes on the device
    std::uint64_t tile_bytes = 0;
};

/// Called with the share of the work that is done, 0 to 1; false stops the render.
using Progress = std::function<bool(double)>;

/// Renders pictures of one packed scene: on a Vulkan device (Renderer) or on the host (host/hostrenderer.h). The packed
/// scene is read, never changed: each renderer has a PackedState of its own.
class SceneRenderer {
  public:
    virtual ~SceneRenderer() = default;

    /// Takes the camera and film of `scene`, which has changed in nothing else.
    virtual void setCamera(const Scene& scene) = 0;
    /// Renders these pixels of the film in place of those of its crop window.
    virtual void setCrop(const Box& crop) = 0;
    /// Takes the lights and the constant and ramp colours of `scene`, which has changed in nothing else, and has the
    /// same traits.
    virtual void setLook(const Scene& scene, const SceneMaps& maps) = 0;
    /// Takes another packing of the same maps, with its camera, lights and colours, in place of the present one: the
    /// same reliefs in the same order, whatever their radii and displacements.
    virtual void setPacking(const PackedScene& packed) = 0;

    /// addSamples() of this renderer's crop. `planes`: kColourPlanes, and kAlphaPlane if wanted; `start` has channels
    /// of both or is empty.
    virtual SampleSums renderSums(SampleSums start, int from, int to, std::uint32_t seed, const Progress& progress,
                                  std::uint32_t planes = kColourPlanes) = 0;
    /// The planes of `mask` for the ray through each pixel's centre; kColourPlanes among them are that ray's colour.
    /// Lights are sampled with the numbers of sample 0 and seed 0, whatever the scene's seed.
    virtual Image renderPlanes(std::uint32_t mask, const Progress& progress) = 0;

    virtual const RenderStats& stats() const = 0;
    virtual std::uint64_t mapBytes() const = 0;    ///< of heights, bounds and edge tables, where it renders
    virtual std::uint64_t imageBytes() const = 0;  ///< of colour images
};

}  // namespace dsphere
