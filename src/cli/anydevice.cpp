#include "cli/anydevice.h"

#include "base/error.h"
#include "render/filmtracer.h"
#include "render/marchpipeline.h"
#include "render/renderer.h"

namespace dsphere::cli {

namespace {

std::string compilerText() {
#ifdef __clang__
    return fmt::format("clang {}", __clang_version__);
#else
    return fmt::format("GCC {}", __VERSION__);
#endif
}

gpu::DeviceInfo hostInfo(host::Precision precision) {
    gpu::DeviceInfo info;
    info.name = hostName(precision);
    info.type = "host";
    info.driver = fmt::format("dsphere {} ({})", DSPHERE_VERSION, compilerText());
    info.usable = true;
    return info;
}

}  // namespace

AnyDevice::AnyDevice(const CommonOptions& options) {
    if (const auto precision = hostPrecision(options.device)) {
        if (options.validation) throwUsage("--validation is of Vulkan devices, not of {}", hostName(*precision));
        precision_ = *precision;
        host_info_ = hostInfo(precision_);
        return;
    }
    namingTheHost([&] { device_.emplace(gpu::DeviceOptions{options.device, options.validation}); });
}

std::future<void> AnyDevice::warmAhead(const SceneTraits& traits, const MarchMethod& method, std::uint32_t mask) {
    return device_ ? dsphere::warmAhead(*device_, traits, method, mask) : std::future<void>();
}

std::unique_ptr<SceneRenderer> AnyDevice::makeRenderer(const PackedScene& packed, const Scene& scene,
                                                       const MarchMethod& method) {
    if (device_) return std::make_unique<Renderer>(*device_, packed, scene, method);
    return std::make_unique<host::HostRenderer>(packed, scene, method, precision_);
}

int AnyDevice::turns(const SceneTraits& traits, const MarchMethod& method) const {
    return device_ ? turnsOf(*device_, traits, method) : 1;
}

void AnyDevice::checkValidation() const {
    if (device_) cli::checkValidation(*device_);
}

}  // namespace dsphere::cli
