#pragma once

// The mesh peers: Embree's scenes. Only in builds that have Embree.

#include "bench/mesh.h"

#include <atomic>
#include <memory>
#include <span>

struct RTCDeviceTy;
struct RTCSceneTy;

namespace dsphere::bench {

enum class MeshKind { Grid, Triangles };

/// A range of rays, as many as packets hold: a multiple of kPacketSize. They start at t = 0.
struct RaySet {
    std::vector<float> x, y, z, dx, dy, dz;

    std::size_t size() const { return x.size(); }
    void add(const dvec3& origin, const dvec3& direction);
    /// Repeats the last ray until the packets are full: rtcOccluded16 with lanes switched off can hang on some
    /// geometries.
    void fillPackets();
};

/// The nodes' mesh in Embree, robust mode, packets of 16, on all cores. Units of R.
class EmbreeScene {
  public:
    EmbreeScene(const NodeGrid& nodes, double base, double scale, double spacing, MeshKind kind);
    EmbreeScene(const EmbreeScene&) = delete;
    EmbreeScene& operator=(const EmbreeScene&) = delete;

    /// t of each ray's first hit, +infinity on a miss. `normals` (or null) receives the facets', of any length and
    /// side.
    void intersect(const RaySet& rays, std::span<float> t, glm::vec3* normals) const;
    /// Whether anything is hit: -infinity then, +infinity otherwise.
    void occluded(const RaySet& rays, std::span<float> t) const;

    /// The greatest that Embree held at once, vertices and indices included.
    std::uint64_t peakBytes() const { return std::uint64_t(peak_bytes_.load()); }

  private:
    void checkDevice(const char* call) const;

    struct Release {
        void operator()(RTCDeviceTy* device) const;
        void operator()(RTCSceneTy* scene) const;
    };
    std::atomic<std::int64_t> bytes_ = 0, peak_bytes_ = 0;  ///< before the device, which counts in them to its end
    std::unique_ptr<RTCDeviceTy, Release> device_;
    std::unique_ptr<RTCSceneTy, Release> scene_;
};

}  // namespace dsphere::bench
