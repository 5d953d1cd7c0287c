#pragma once

#include "host/kernel.h"
#include "render/probe.h"

namespace dsphere::host {

/// Traces lists of rays with the kernel compiled as C++, on all cores, without Vulkan.
class HostProbe final : public RayProbe {
  public:
    HostProbe(const PackedScene& packed, Precision precision);

    std::vector<layout::ProbeHit> trace(const std::vector<ProbeQuery>& queries) override;

  private:
    HostScene scene_;
    Specialization specialization_;
    ProbeRays probe_;
};

}  // namespace dsphere::host
