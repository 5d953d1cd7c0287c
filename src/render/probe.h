#pragma once

#include "render/renderer.h"

#include <vector>

namespace dsphere {

/// A ray in the object space of the scene's first shape, in units of its R.
struct ProbeQuery {
    dvec3 origin, direction;  ///< direction of any length
    double length = 1e30;     ///< of the ray, in units of R
    bool secondary = false;   ///< by the rules of shadow rays: a start inside is no hit
};

/// The query in floats. The point nearest the centre, far away a difference of large numbers, is made in double.
layout::ProbeRay packProbe(const ProbeQuery& query);

/// Traces lists of rays against the first shape of a packed scene, which must outlive it, with the exact marcher: on a
/// Vulkan device (Probe) or on the host (host/hostprobe.h).
class RayProbe {
  public:
    virtual ~RayProbe() = default;
    virtual std::vector<layout::ProbeHit> trace(const std::vector<ProbeQuery>& queries) = 0;
};

class Probe final : public RayProbe {
  public:
    Probe(gpu::Device& device, const PackedScene& packed);

    std::vector<layout::ProbeHit> trace(const std::vector<ProbeQuery>& queries) override;

  private:
    gpu::Device& device_;
    DeviceScene device_scene_;
    gpu::ComputePipeline pipeline_;
};

}  // namespace dsphere
