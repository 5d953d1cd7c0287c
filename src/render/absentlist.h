#pragma once

#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "render/tilepool.h"

#include <functional>
#include <vector>

namespace dsphere {

/// The pixels or rays of a submission that met a tile of heights which is not on the device (BINDING_ABSENT): reads the
/// tiles, and has them done again, until none is left.
class AbsentList {
  public:
    /// For submissions of at most `capacity` pixels or rays. The pool must outlive it.
    AbsentList(gpu::Device& device, TilePool& pool, std::uint64_t capacity);

    const gpu::Buffer& buffer() const { return buffer_; }
    /// Whether the scene has maps in tiles at all; the rest means nothing without.
    bool active() const { return !pool_.empty(); }
    /// Empties the list: before the first dispatch of a submission.
    void reset(gpu::Batch& batch) const;
    /// After a submission. `redo(count)` submits the pipelines that take the listed ones, `count` of them, and waits;
    /// it must not reset(). Throws Error (Failure) where the tiles of a single one find no room.
    void settle(const std::function<void(std::uint32_t count)>& redo);

  private:
    std::vector<layout::AbsentPixel> take();
    void list(const std::vector<layout::AbsentPixel>& pixels);

    TilePool& pool_;
    std::uint32_t capacity_;
    gpu::Buffer buffer_;
};

}  // namespace dsphere
