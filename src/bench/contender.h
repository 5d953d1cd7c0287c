#pragma once

// What a bench run races: a method made ready for one view.

#include "bench/method.h"
#include "bench/workload.h"
#include "verify/compare.h"

#include <memory>
#include <span>

namespace dsphere::bench {

struct Timing {
    double device = 0.0, wall = 0.0;  ///< seconds
};

/// A method's word on one pixel, for the reference to judge.
struct PixelAnswer {
    std::size_t pixel = 0;
    verify::Answer answer;
    dvec3 start{0.0};       ///< the device's: P', object units
    bool has_light = true;  ///< false: the method finds no shadows
    bool lit = false;       ///< by the one sun
    bool runaway = false;
};

struct Answers {
    std::vector<PixelAnswer> pixels;
    std::uint64_t hits = 0;        ///< of all pixels
    double fetches_per_hit = 0.0;  ///< mean over the pixels that hit
};

class Contender {
  public:
    virtual ~Contender() = default;

    /// One run of all camera rays, t alone.
    virtual Timing tracePrimary() = 0;
    /// One run of all shadow rays, which leave the method's own hits where they face the sun. On the device: what t and
    /// lit take together, less the last tracePrimary().
    virtual Timing traceShadows() = 0;
    virtual std::uint64_t shadowRays() const = 0;
    /// Not timed.
    virtual Answers answer(std::span<const std::size_t> pixels) = 0;
};

/// Whether this build can trace meshes.
bool haveEmbree();
/// Its version, "" without.
std::string embreeVersion();

/// A mesh of the workload's planet, built once and used for all its views.
class MeshScene {
  public:
    virtual ~MeshScene() = default;
    virtual std::uint64_t memoryBytes() const = 0;  ///< greatest while it was built, vertices included
    virtual std::unique_ptr<Contender> contender(const Workload& workload, const View& view) const = 0;
};

/// Builds it on all cores; nullptr without Embree.
std::unique_ptr<MeshScene> makeMeshScene(const Workload& workload, const Method& method);

}  // namespace dsphere::bench
