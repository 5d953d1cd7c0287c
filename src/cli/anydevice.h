#pragma once

#include "cli/commands.h"
#include "host/hostrenderer.h"

#include <future>
#include <memory>
#include <optional>

namespace dsphere::cli {

/// Where a command renders: on a Vulkan device, or on the host by the kernel compiled as C++ (--device host or
/// host-double).
class AnyDevice {
  public:
    /// Error (NoDevice) when there is no such Vulkan device; it names the host.
    explicit AnyDevice(const CommonOptions& options);

    bool isVulkan() const { return device_.has_value(); }
    const gpu::DeviceInfo& info() const { return device_ ? device_->info() : host_info_; }
    /// Has a Vulkan device's driver compile, as dsphere::warmAhead(); nothing of the host, without a state.
    std::future<void> warmAhead(const SceneTraits& traits, const MarchMethod& method, std::uint32_t mask);
    /// The packed scene and the device must outlive the renderer.
    std::unique_ptr<SceneRenderer> makeRenderer(const PackedScene& packed, const Scene& scene,
                                                const MarchMethod& method);
    /// Pixels that an invocation takes one after the other; 1 on the host.
    int turns(const SceneTraits& traits, const MarchMethod& method) const;
    /// checkValidation() of a Vulkan device.
    void checkValidation() const;

  private:
    host::Precision precision_ = host::Precision::Float;
    gpu::DeviceInfo host_info_;
    std::optional<gpu::Device> device_;  ///< empty: the host
};

}  // namespace dsphere::cli
