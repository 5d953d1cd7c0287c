#include "bench/environment.h"

#include "bench/commit.h"
#include "bench/contender.h"
#include "gpu/device.h"

#include <fmt/chrono.h>

#include <cstdlib>
#include <ctime>
#include <fstream>
#include <thread>

namespace dsphere::bench {

namespace {

std::string cpuName() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);) {
        std::size_t colon = line.find(": ");
        if (line.rfind("model name", 0) == 0 && colon != std::string::npos) return line.substr(colon + 2);
    }
    return "unknown CPU";
}

}  // namespace

double systemLoad() {
    double load = 0.0;
    return getloadavg(&load, 1) == 1 ? load : 0.0;
}

std::string buildCommit() {
    return DSPHERE_COMMIT;
}

report::Environment describeEnvironment(const gpu::Device& device, double device_open_seconds, double load) {
    report::Environment environment;
    environment.version = DSPHERE_VERSION;
    environment.commit = buildCommit();
    environment.date = fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr)));
    environment.cpu = cpuName();
    environment.cores = int(std::thread::hardware_concurrency());
    environment.load = load;
    environment.device = device.info().name;
    environment.driver = device.info().driver;
    environment.device_open_seconds = device_open_seconds;
    environment.embree = embreeVersion();
    return environment;
}

}  // namespace dsphere::bench
