#pragma once

#include "query/frames.h"
#include "render/rayblock.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace dsphere::query {

/// Rays as rows of 6 doubles (origin, direction) or 8 (t_min and t_max too).
struct RayRows {
    const double* first = nullptr;
    int columns = 8;
    std::size_t count = 0;

    QueryRay at(std::size_t i) const;
};

struct Answer {
    QueryHit hit;
    std::array<float, 3> colour{};  ///< direct light, if it was asked for
    dvec3 device_position{0.0};     ///< the hit in the shape's space on the device
};

/// Traces rays through one scene on one device. What is given must outlive it; use from one thread at a time.
class Engine {
  public:
    struct Options {
        Frame frame = Frame::World;
        RayWishes wishes = {};
        bool whole = true;       ///< false: status and id alone are wanted
        bool secondary = false;  ///< by the rules of shadow rays: they leave a surface, and a start inside is no hit
        std::function<void()> between_blocks = {};  ///< called every few hundredths of a second; may throw
    };
    using Source = std::function<QueryRay(std::size_t)>;
    /// Takes the answer of a ray, once for each; called from many threads.
    using Sink = std::function<void(std::size_t, const Answer&)>;

    Engine(gpu::Device& device, const Scene& scene, const SceneMaps& maps, const PackedScene& packed,
           const DeviceScene& device_scene, const Options& options);

    /// Rays 0 to count - 1 of the source, which is called from many threads too.
    void trace(std::size_t count, const Source& source, const Sink& sink);
    void trace(const RayRows& rays, const Sink& sink);

    const std::vector<ShapeFrame>& shapes() const { return shapes_; }
    std::uint64_t retried() const { return retried_; }
    /// Rays that a limit of steps ended, which is a defect of the program: they have the status Invalid.
    std::uint64_t runaways() const { return runaways_; }

  private:
    void pack(RayBlock& block, std::size_t first, std::size_t count, const Source& source) const;
    void finish(const RayBlock& block, std::size_t first, std::size_t count, const Source& source, const Sink& sink);
    Answer answerOf(const QueryRay& ray, const layout::QueryHit& found, const layout::QueryLook* look) const;

    Options options_;
    std::vector<ShapeFrame> shapes_;
    dmat3 frame_from_world_normal_;
    std::uint32_t seed_;
    RayPipelines pipelines_;
    std::uint32_t capacity_;
    std::vector<std::unique_ptr<RayBlock>> blocks_;  ///< two: one is packed and read while the device has the other
    std::uint64_t traced_ = 0, retried_ = 0, runaways_ = 0;
};

/// Whether a ray can be traced at all; others have the status Invalid.
bool isValid(const QueryRay& ray);

}  // namespace dsphere::query
