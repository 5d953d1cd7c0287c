#pragma once

#include "cli/anydevice.h"
#include "cli/sceneoptions.h"
#include "render/movingscene.h"

#include <cstdint>
#include <optional>

namespace dsphere::cli {

/// The device that the options ask for, with a scene on it.
class SceneOnDevice {
  public:
    /// Reads the maps, and prints their notices unless --quiet, while the driver compiles what `planes` takes. Errors
    /// of both; that of a map comes first. `scene` gets the camera that the options place above its ground.
    SceneOnDevice(Scene& scene, const SceneOptions& placement, const CommonOptions& common, const MarchMethod& method,
                  std::uint32_t planes);

    const AnyDevice& device() const { return *device_; }
    MovingScene& moving() { return *moving_; }
    SceneRenderer& renderer() { return moving_->renderer(); }

  private:
    std::optional<AnyDevice> device_;
    std::optional<MovingScene> moving_;
};

}  // namespace dsphere::cli
