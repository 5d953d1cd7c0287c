#pragma once

#include "query/sentrays.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

namespace dsphere::query {

struct Place;

/// Rays as rows of 6 doubles (origin, direction) or 8 (t_min and t_max too).
struct RayRows {
    const double* first = nullptr;
    int columns = 8;
    std::size_t count = 0;

    QueryRay at(std::size_t i) const;
    /// Rays begin, begin + 1 and so on.
    void copyTo(std::size_t begin, std::span<QueryRay> rays) const;
};

struct Answer {
    QueryHit hit;
    std::array<float, 3> colour{};  ///< direct light, if it was asked for
    dvec3 device_position{0.0};     ///< the hit in the shape's space on the device, if `root` was wanted
};

/// What the host fills of answers besides status and id; the rest stays as it is in a QueryHit without a hit.
struct AnswerParts {
    bool root = true;  ///< t, refined in double
    bool position = true, normal = true;
    bool place = true;  ///< latitude, longitude, height, metres, u and v

    static AnswerParts none() { return {false, false, false, false}; }
};

/// Traces rays through one scene on one device. What is given must outlive it; use from one thread at a time.
class Engine {
  public:
    struct Options {
        Frame frame = Frame::World;
        RayWishes wishes = {};
        AnswerParts parts = {};
        bool secondary = false;  ///< by the rules of shadow rays: they leave a surface, and a start inside is no hit
        std::function<void()> between_blocks = {};  ///< called every few hundredths of a second; may throw
    };
    /// Takes the answers of rays first, first + 1 and so on, once for each; called from many threads.
    using Sink = std::function<void(std::size_t first, std::span<const Answer> answers)>;

    Engine(gpu::Device& device, const Scene& scene, const SceneMaps& maps, const PackedScene& packed,
           const DeviceScene& device_scene, const Options& options);

    /// Rays 0 to count - 1 of the source.
    void traceBatches(std::size_t count, const RaySource& source, const Sink& sink);
    /// Same as traceBatches, ray by ray: source(i) gives ray i, sink(i, answer) takes its answer.
    template <typename Source, typename AnswerSink>
    void trace(std::size_t count, const Source& source, const AnswerSink& sink) {
        traceBatches(
            count,
            [&](std::size_t first, std::span<QueryRay> rays) {
                for (std::size_t k = 0; k < rays.size(); ++k) rays[k] = source(first + k);
            },
            [&](std::size_t first, std::span<const Answer> answers) {
                for (std::size_t k = 0; k < answers.size(); ++k) sink(first + k, answers[k]);
            });
    }

    const std::vector<ShapeFrame>& shapes() const { return shapes_; }
    /// Rays that a limit of steps ended, which is a defect of the program: they have the status Invalid.
    std::uint64_t runaways() const { return runaways_; }

  private:
    /// Some rays, on the host and on the device.
    struct Block {
        SentRays sent;
        std::unique_ptr<RayBlock> on_device;
        std::uint32_t count = 0;  ///< on the device
    };

    void pack(Block& block, std::size_t first, std::size_t count, const RaySource& source) const;
    void finish(const Block& block, std::size_t first, const Sink& sink);
    /// Returns how many runaways it met.
    std::uint64_t finishChunk(const Block& block, std::size_t chunk, std::size_t first, const Sink& sink) const;
    struct Batch;
    /// Whether the root has to be found too.
    bool fill(Answer& answer, const layout::QueryHit& found, const layout::QueryLook* look) const;
    void solve(Batch& batch) const;
    void describe(Answer& answer, const QueryRay& ray, const layout::QueryHit& found, const Place& place) const;

    Options options_;
    std::vector<ShapeFrame> shapes_;
    dmat3 frame_from_world_normal_;
    std::uint32_t seed_;
    RayPipelines pipelines_;
    std::uint32_t capacity_;
    std::vector<Block> blocks_;  ///< two: one is packed and read while the device has the other
    std::uint64_t traced_ = 0, runaways_ = 0;
};

}  // namespace dsphere::query
