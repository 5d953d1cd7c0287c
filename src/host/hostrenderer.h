#pragma once

#include "host/kernel.h"
#include "render/scenerenderer.h"
#include "render/spans.h"

namespace dsphere::host {

/// Renders with the kernel compiled as C++, on all cores, without Vulkan.
class HostRenderer final : public SceneRenderer {
  public:
    /// With the camera and film of `scene`; the packed scene must outlive it. Error (InvalidInput) for a scene that the
    /// method cannot march.
    HostRenderer(const PackedScene& packed, const Scene& scene, const MarchMethod& method, Precision precision);

    void setCamera(const Scene& scene) override;
    void setCrop(const Box& crop) override;
    void setLook(const Scene& scene, const SceneMaps& maps) override;
    void setPacking(const PackedScene& packed) override;
    SampleSums renderSums(SampleSums start, int from, int to, std::uint32_t seed, const Progress& progress,
                          std::uint32_t planes = kColourPlanes) override;
    Image renderPlanes(std::uint32_t mask, const Progress& progress) override;

    const RenderStats& stats() const override { return stats_; }
    std::uint64_t mapBytes() const override { return scene_.mapBytes(); }
    std::uint64_t imageBytes() const override { return scene_.imageBytes(); }

  private:
    HostFilm makeFilm(std::uint32_t mask) const;
    void runTiles(HostFilm& film, std::uint32_t mask, int sample, std::uint32_t seed, const Progress& progress);
    Image read(const HostFilm& film, std::uint32_t mask) const;

    HostScene scene_;
    PackedState state_;
    MarchMethod method_;
    float stride_;
    Kernels kernels_;
    Box crop_, display_;
    std::vector<Box> tiles_;  ///< of the film's pixels
    RenderStats stats_;
};

}  // namespace dsphere::host
