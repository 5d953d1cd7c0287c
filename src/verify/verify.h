#pragma once

#include "render/probe.h"
#include "render/renderer.h"
#include "verify/report.h"

namespace dsphere::verify {

struct Outcome {
    Report report;
    Image device;  ///< kVerifyPlanes
};

/// Holds `samples` pixels (drawn with a fixed seed; 0: all) of kVerifyPlanes, as renderPlanes() of a renderer of the
/// scene gives them, against the certified reference. Uses all cores. Error (Interrupted) when `progress` says stop.
Outcome verifyPlanes(Image planes, const Scene& scene, const SceneMaps& maps, std::uint64_t samples,
                     const Progress& progress);
/// The same of planes that it renders first. Errors of rendering, too.
Outcome verifyScene(SceneRenderer& renderer, const Scene& scene, const SceneMaps& maps, std::uint64_t samples,
                    const Progress& progress);

/// The reference's own picture of the same scene: R, G, B, t, id and lit at the pixels' centres.
Image referenceImage(const Scene& scene, const SceneMaps& maps, const Progress& progress);

/// Traces rays against the scene's first shape, a displaced sphere whose object space is the world, and holds the
/// answers against the reference. A ray's own direction must be finite and not zero.
Report verifyRays(RayProbe& probe, const Scene& scene, const SceneMaps& maps, const std::vector<ProbeQuery>& queries);

}  // namespace dsphere::verify
