#pragma once

#include "bench/results.h"

namespace dsphere::gpu {
class Device;
}

namespace dsphere::bench {

/// This build, this host, that device, now.
Environment describeEnvironment(const gpu::Device& device, double device_open_seconds);

}  // namespace dsphere::bench
