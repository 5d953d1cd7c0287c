#pragma once

#include "gpu/pipeline.h"
#include "render/method.h"
#include "render/pack.h"
#include "render/traits.h"

#include <span>

namespace dsphere {

enum class Shader { Render, Probe, Query };

/// Whether the device is a CPU: few invocations share their instructions then, and its driver makes machine code at the
/// first dispatch. Other devices have invocations to spare.
bool runsOnCpu(const gpu::Device& device);

/// Pixels that an invocation of the first pipeline takes, one after the other, so that those whose paths end early are
/// not idle until the longest of their group has.
int turnsOf(const gpu::Device& device, const SceneTraits& traits, const MarchMethod& method);

/// A pipeline of a shader (one of its MARCH_ variants) that marches such a scene, specialised to what the scene
/// holds: its bindings are DeviceScene::resources(), then the film, the list of pixels to retry and AbsentList
/// (Render), or the buffers of rays and hits (Probe), or those of rays, rays to retry, AbsentList, answers and looks
/// (Query).
gpu::ComputePipeline makeMarchPipeline(gpu::Device& device, const SceneTraits& traits, float stride,
                                       std::span<const std::uint32_t> spirv, Shader shader, const MarchMethod& method,
                                       std::uint32_t planes);

}  // namespace dsphere
