#pragma once

#include "gpu/buffer.h"
#include "gpu/image.h"
#include "gpu/pipeline.h"
#include "render/pack.h"
#include "render/tilepool.h"

#include <memory>
#include <vector>

namespace dsphere {

namespace gpu {
class Device;
}

/// A packed scene on the device. Maps lie once, stacked in layers of one image however many shapes use them.
class DeviceScene {
  public:
    /// Uploads. Error (InvalidInput) when a map is larger than the device's images; Error (Failure) out of memory.
    DeviceScene(gpu::Device& device, const PackedScene& packed);

    /// Uploads the objects again.
    void updateObjects(const PackedState& state);
    /// Uploads lights and materials again, as many as before.
    void updateLook(const PackedState& state);
    /// Uploads bounds and maps again: of the same maps under other reliefs, as many as before.
    void updateReliefs(const PackedScene& packed);

    /// Of maps that stay in their files. Reading more tiles changes no answer, so that a scene that is const may do it.
    TilePool& tiles() const { return *tiles_; }
    /// Bindings BINDING_OBJECTS to BINDING_TILES, in order.
    std::vector<gpu::Resource> resources() const;
    /// Bytes on the device: heights, bounds and edge tables.
    std::uint64_t mapBytes() const { return map_bytes_; }
    /// Bytes of the colour images.
    std::uint64_t imageBytes() const { return image_bytes_; }

  private:
    struct Layout;

    std::unique_ptr<TilePool> tiles_;  // before what is placed in it
    std::shared_ptr<const Layout> layout_;
    gpu::Buffer objects_, maps_, lights_, materials_, triangles_, ramps_, tables_;
    std::uint64_t map_bytes_ = 0, image_bytes_ = 0;
    gpu::StorageImage heights_, bounds_, edges_, images_, nodes_;

    DeviceScene(gpu::Device& device, const PackedScene& packed, std::unique_ptr<TilePool> tiles);
};

}  // namespace dsphere
