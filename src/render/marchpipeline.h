#pragma once

#include "gpu/pipeline.h"
#include "render/method.h"
#include "render/pack.h"

#include <span>

namespace dsphere {

enum class Shader { Render, Probe };

/// Order as PRECISION_ of layout.h.
enum class Precision { Filter, Full, Both };

/// A pipeline of a shader that marches the packed scene, specialised to what the scene holds: its bindings are
/// DeviceScene::resources(), then the film and the list of pixels to retry (Render) or the buffers of rays and hits
/// (Probe).
gpu::ComputePipeline makeMarchPipeline(gpu::Device& device, const PackedScene& packed,
                                       std::span<const std::uint32_t> spirv, Shader shader, const MarchMethod& method,
                                       Precision precision, std::uint32_t planes);

}  // namespace dsphere
