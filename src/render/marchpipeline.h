#pragma once

#include "gpu/pipeline.h"
#include "render/method.h"
#include "render/pack.h"

#include <span>

namespace dsphere {

enum class Shader { Render, Probe };

/// A pipeline of a shader (one of its MARCH_ variants) that marches the packed scene, specialised to what the scene
/// holds: its bindings are DeviceScene::resources(), then the film and the list of pixels to retry (Render) or the
/// buffers of rays and hits (Probe).
gpu::ComputePipeline makeMarchPipeline(gpu::Device& device, const PackedScene& packed,
                                       std::span<const std::uint32_t> spirv, Shader shader, const MarchMethod& method,
                                       std::uint32_t planes);

}  // namespace dsphere
