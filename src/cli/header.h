#pragma once

// What the header of a rendered EXR says.

#include "cli/resume.h"
#include "gpu/device.h"
#include "image/picture.h"
#include "render/renderer.h"
#include "surface/scenemaps.h"

#include <optional>

namespace dsphere::cli {

Origin originOf(const Scene& scene, const SceneMaps& maps, const MarchMethod& method, const gpu::DeviceInfo& device);

/// `seconds` on the device; unset: a reproducible header, which leaves out what differs from run to run and from
/// machine to machine (the time, the device and its driver).
Metadata makeMetadata(const Scene& scene, const Origin& origin, int samples, std::optional<double> seconds);

}  // namespace dsphere::cli
