#pragma once

#include "gpu/buffer.h"
#include "gpu/commands.h"
#include "gpu/pipeline.h"
#include "render/devicescene.h"
#include "render/leftovers.h"
#include "render/tovec4.h"

#include <algorithm>
#include <future>
#include <optional>
#include <span>

namespace dsphere {

/// What is asked about a hit besides where it is.
struct RayWishes {
    bool normal = true;
    bool lit = false, colour = false, place = false;  ///< place: the shape's own (u, v)

    bool looks() const { return colour || place; }
};

/// The pipelines that trace lists of rays through one scene: search_filter, and search_full for the rays that it
/// leaves.
class RayPipelines {
  public:
    RayPipelines(gpu::Device& device, const SceneTraits& traits, const RayWishes& wishes);

    const gpu::ComputePipeline& first() const { return *first_; }
    /// Null: there is none, the scene has no displaced sphere.
    const gpu::ComputePipeline* full() const { return full_.valid() ? &full_.get() : nullptr; }

  private:
    std::optional<gpu::ComputePipeline> first_;
    std::shared_future<gpu::ComputePipeline> full_;
};

/// Packs a ray of an object's space in units of R, in double. The direction is unit, `point` the ray's point nearest
/// the centre; the ray begins and ends at these distances from there, which may be infinite. `number`: see
/// layout::QueryRay.
inline layout::QueryRay packRay(const dvec3& point, const dvec3& direction, double begin, double end, bool secondary,
                                std::uint32_t number) {
    // In R. Squares of greater lengths would overflow in floats, and nothing that a float says of the surface lies
    // farther off.
    constexpr double kFarthest = 1e15;
    layout::QueryRay ray;
    ray.point = toVec4(point, std::clamp(begin, -kFarthest, kFarthest));
    ray.point_lo = toVec4(point - dvec3(ray.point), std::clamp(end, -kFarthest, kFarthest));
    ray.direction = toVec4(direction, secondary ? 1.0 : 0.0);
    ray.direction_lo = toVec4(direction - dvec3(ray.direction), double(number));
    return ray;
}

/// Room on the device for some rays and their answers, and the trace of them. All that is given must outlive it.
class RayBlock {
  public:
    RayBlock(gpu::Device& device, const RayPipelines& pipelines, const DeviceScene& scene, const RayWishes& wishes,
             std::uint32_t objects, std::uint32_t capacity);

    /// One per ray and object: ray i in the space of object k stands at i * objects + k. To be filled before trace().
    std::span<layout::QueryRay> rays();
    /// Traces the first `count` rays. `first`: the index of the first of them among all rays, see QueryParams.
    void trace(std::uint32_t count, std::uint32_t first, std::uint32_t seed);
    /// Of the last trace.
    std::span<const layout::QueryHit> hits() const;
    std::span<const layout::QueryLook> looks() const;

  private:
    const RayPipelines& pipelines_;
    Leftovers leftovers_;
    gpu::Buffer rays_, hits_, looks_;
    gpu::BindingSet set_;
    gpu::Batch batch_;
};

}  // namespace dsphere
