#pragma once

#include "bench/contender.h"

namespace dsphere::bench {

/// A scene on the device, seen from one view after another.
class DeviceView {
  public:
    DeviceView(gpu::Device& device, const Scene& scene, const SceneMaps& maps, const View& view,
               Levels levels = Levels::Finest);
    /// Of a scene packed already.
    DeviceView(gpu::Device& device, Scene scene, PackedScene packed);

    void look(const View& view);
    Renderer& renderer() { return renderer_; }
    const Scene& scene() const { return scene_; }

  private:
    Scene scene_;
    PackedScene packed_;
    Renderer renderer_;
};

/// Asked now and then; false stops the run.
using Alive = std::function<bool()>;

/// The device's own methods; several may share a DeviceView, which must outlive them. `unit` is R in object units.
std::unique_ptr<Contender> makeDeviceContender(DeviceView& view, const Method& method, double unit, Alive alive);

/// Of a scene with one plain shape.
SceneMaps noMaps();

/// From the map in memory to the first t on the host, wall seconds: nodes, bounds, upload, film, and pipelines, the
/// exact marcher's beside the first two. The device must have no caches: DeviceOptions::caches.
double timeDeviceSetup(gpu::Device& device, const Workload& workload, const View& view, const Method& method);

/// Seconds of a wall clock since some start.
double wallSeconds();

}  // namespace dsphere::bench
