#pragma once

#include "report/results.h"

#include <string>

namespace dsphere::gpu {
class Device;
}

namespace dsphere::bench {

/// Processes ready to run, the mean of the last minute; 0 where the system does not tell.
double systemLoad();

/// The commit that this program was built from, "unknown" outside of a repository.
std::string buildCommit();

/// This build, this host, that device, now. `load` is the system's before the run.
report::Environment describeEnvironment(const gpu::Device& device, double device_open_seconds, double load);

}  // namespace dsphere::bench
