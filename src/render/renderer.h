#pragma once

#include "render/cropfilm.h"
#include "render/devicescene.h"
#include "render/filmtracer.h"
#include "render/planes.h"
#include "render/scenerenderer.h"
#include "render/spans.h"

#include <limits>
#include <map>
#include <memory>
#include <utility>

namespace dsphere {

/// Renders on a Vulkan device, which must outlive it, as the packed scene must.
class Renderer final : public SceneRenderer {
  public:
    /// With the camera and film of `scene`, whatever the packing has.
    Renderer(gpu::Device& device, const PackedScene& packed, const Scene& scene, const MarchMethod& method);

    void setCamera(const Scene& scene) override;
    void setCrop(const Box& crop) override;
    void setLook(const Scene& scene, const SceneMaps& maps) override;
    void setPacking(const PackedScene& packed) override;
    /// For the renders that follow. Pipelines of methods used before are kept.
    void setMethod(const MarchMethod& method) { method_ = method; }

    /// R, G, B: the mean of `samples` jittered samples a pixel (1 to 65536). Error (Interrupted) when stopped.
    Image renderColour(int samples, std::uint32_t seed, const Progress& progress);
    SampleSums renderSums(SampleSums start, int from, int to, std::uint32_t seed, const Progress& progress,
                          std::uint32_t planes = kColourPlanes) override;
    Image renderPlanes(std::uint32_t mask, const Progress& progress) override;

    const RenderStats& stats() const override { return stats_; }
    /// For pictures of the caller's own: what this renderer's are made with.
    FilmPipelines& pipelines(const MarchMethod& method, std::uint32_t mask);
    const DeviceScene& deviceScene() const { return device_scene_; }
    const Box& crop() const { return crop_; }
    const std::vector<Span>& spans() const { return spans_; }  ///< one a row of the crop
    std::uint64_t mapBytes() const override { return device_scene_.mapBytes(); }
    std::uint64_t imageBytes() const override { return device_scene_.imageBytes(); }

  private:
    CropFilm makeFilm(std::uint32_t mask);
    void addSample(CropFilm& film, int sample, std::uint32_t seed, const Progress& progress);
    void countWork(const FilmTracer& tracer);
    void fillMisses(Image& image, const std::vector<Box>& tiles) const;

    gpu::Device& device_;
    const PackedScene* packed_;
    SceneTraits traits_;  ///< that the pipelines are made for
    PackedState state_;
    DeviceScene device_scene_;
    MarchMethod method_;
    std::map<std::pair<MarchMethod, std::uint32_t>, FilmPipelines> pipelines_;  ///< by method and planes
    Box crop_, display_;
    std::vector<Span> spans_;
    int film_rows_ = std::numeric_limits<int>::max();  ///< as many as the device has had memory for
    RenderStats stats_;
};

}  // namespace dsphere
