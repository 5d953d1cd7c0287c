#pragma once

#include "render/probe.h"
#include "render/renderer.h"
#include "verify/report.h"

namespace dsphere::verify {

struct Options {
    Marcher marcher = Marcher::Exact;
    std::uint64_t samples = 0;  ///< pixels to compare, drawn with a fixed seed; 0: all
};

struct Outcome {
    Report report;
    Image device;  ///< kVerifyPlanes
    RenderStats stats;
};

/// Renders all planes of the scene with a renderer of it, and holds `samples` pixels (drawn with a fixed seed; 0: all)
/// against the certified reference. Uses all cores. Errors of rendering; Error (Interrupted) when `progress` says stop.
Outcome verifyScene(SceneRenderer& renderer, const Scene& scene, const SceneMaps& maps, std::uint64_t samples,
                    const Progress& progress);

/// Renders all planes of the scene on the device and holds its pixels against the certified reference. Uses all cores.
/// Errors of rendering; Error (Interrupted) when `progress` says stop.
Outcome verifyScene(gpu::Device& device, const Scene& scene, const SceneMaps& maps, const Options& options,
                    const Progress& progress);

/// The reference's own picture of the same scene: R, G, B, t, id and lit at the pixels' centres.
Image referenceImage(const Scene& scene, const SceneMaps& maps, const Progress& progress);

/// Traces rays against the scene's first shape, a displaced sphere whose object space is the world, and holds the
/// answers against the reference. A ray's own direction must be finite and not zero.
Report verifyRays(RayProbe& probe, const Scene& scene, const SceneMaps& maps, const std::vector<ProbeQuery>& queries);

}  // namespace dsphere::verify
