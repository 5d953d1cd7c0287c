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

/// Traces a list of rays against the scene's first shape on the device, with the exact marcher.
class Probe {
  public:
    Probe(gpu::Device& device, const PackedScene& packed);

    std::vector<layout::ProbeHit> trace(const std::vector<ProbeQuery>& queries);

  private:
    gpu::Device& device_;
    DeviceScene device_scene_;
    gpu::ComputePipeline pipeline_;
};

}  // namespace dsphere
