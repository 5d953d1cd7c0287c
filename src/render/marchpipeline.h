#pragma once

#include "gpu/pipeline.h"
#include "render/method.h"
#include "render/pack.h"

#include <span>

namespace dsphere {

enum class Shader { Render, Probe };

/// What of a scene pipelines are specialised to: known before its maps are read.
struct SceneTraits {
    std::uint32_t objects = 0, lights = 0;
    std::uint32_t kinds = 0, surfaces = 0;  ///< bit per KIND_ and SURFACE_ in use
    bool images = false;

    bool operator==(const SceneTraits&) const = default;
    /// Whether the shader variants WITH_CURVED are needed.
    bool curved() const { return surfaces > 1u << SURFACE_BILINEAR; }
};

SceneTraits traitsOf(const Scene& scene);
SceneTraits traitsOf(const PackedScene& packed);

/// The share of |p| - r that no step of the Lipschitz marcher may exceed; 1 for the others.
float safeStride(const PackedScene& packed, const MarchMethod& method);

/// A pipeline of a shader (one of its MARCH_ variants) that marches such a scene, specialised to what the scene
/// holds: its bindings are DeviceScene::resources(), then the film and the list of pixels to retry (Render) or the
/// buffers of rays and hits (Probe).
gpu::ComputePipeline makeMarchPipeline(gpu::Device& device, const SceneTraits& traits, float stride,
                                       std::span<const std::uint32_t> spirv, Shader shader, const MarchMethod& method,
                                       std::uint32_t planes);

}  // namespace dsphere
