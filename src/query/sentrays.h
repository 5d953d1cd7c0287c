#pragma once

#include "query/frames.h"
#include "render/rayblock.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

namespace dsphere::query {

/// Fills rays first, first + 1 and so on; called from many threads.
using RaySource = std::function<void(std::size_t first, std::span<QueryRay> rays)>;

/// A block of rays on its way to the device. Rays that pass outside the spheres which hold all shapes are misses, and
/// those that are no rays have no answer: the device gets the others, without gaps.
class SentRays {
  public:
    static constexpr std::size_t kChunk = 2048;  ///< rays that one thread does at a time

    enum class Fate : std::uint8_t { Miss, Sent, Invalid };

    explicit SentRays(std::size_t capacity);

    /// Takes `count` rays, at most the capacity, from ray `first` of the source on; on all cores.
    void take(std::span<const ShapeFrame> shapes, std::size_t first, std::size_t count, const RaySource& source);
    /// Writes those to be sent as RayBlock takes them, on all cores, and returns how many they are. Where neighbours of
    /// the source enter a scene's only shape far apart they are sent in the order of where they enter: neighbours on
    /// the device then need the same parts of the map.
    std::uint32_t pack(std::span<const ShapeFrame> shapes, bool secondary, std::span<layout::QueryRay> target);

    /// Calls body(fate, ray, place) for each ray of a chunk in order; `place` is where the ray was sent to. Ray and
    /// place mean something if it was sent.
    template <typename Body>
    void forEach(std::size_t chunk, const Body& body) const {
        const std::size_t begin = chunk * kChunk, end = std::min(begin + kChunk, count_);
        for (std::size_t i = begin, k = begin; i < end; ++i) {  // k <= i: there is such a ray
            body(fates_[i], rays_[k], places_[k]);
            k += fates_[i] == Fate::Sent;
        }
    }
    std::size_t chunks() const { return (count_ + kChunk - 1) / kChunk; }

  private:
    /// The rays of a chunk that are sent lie at the beginning of its part of `rays_`.
    struct Chunk {
        std::uint32_t sent = 0, first_place = 0;
        bool scattered = false;  ///< neighbours enter far apart
    };

    void takeChunk(std::span<const ShapeFrame> shapes, std::size_t chunk, std::size_t first, const RaySource& source);
    void sortPlaces(const ShapeFrame& shape);

    std::vector<QueryRay> rays_;
    std::vector<std::uint32_t> places_;  ///< of each of rays_
    std::vector<Fate> fates_;            ///< of each ray
    std::vector<Chunk> parts_;
    std::size_t count_ = 0;
};

/// Whether a ray can be traced at all; others have the status Invalid.
bool isValid(const QueryRay& ray);

}  // namespace dsphere::query
