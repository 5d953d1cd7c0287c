#pragma once

#include "query/engine.h"
#include "verify/compare.h"

#include <mutex>

namespace dsphere::query {

/// What the reference says of a ray. NaN: it proves that the ray meets nothing, or the ray is none.
struct Truth {
    double t_low = QueryHit::kNone, t_high = QueryHit::kNone;  ///< enclose the first root, in units of |direction|
    bool tangent = false;                                      ///< moving the ray sideways by 1e-6 R changes the answer
    bool wrong = false;                                        ///< the answer breaks the contract
};

/// Holds answers against the certified reference. Scene and maps must outlive it; thread-safe.
class Certifier {
  public:
    /// `wants_tangent`: Truth::tangent is filled, which takes some 40 times as long.
    Certifier(const Scene& scene, const SceneMaps& maps, Frame frame, bool wants_tangent);

    Truth check(std::uint64_t index, const QueryRay& ray, const Answer& answer);

    /// Of all rays so far. Not while check() runs.
    const verify::Report& report() const { return report_; }
    /// What the answers break of the contract, one line each. The share of tangent rays is the caller's own affair.
    std::vector<std::string> violations() const;

  private:
    bool isTangent(const verify::WorldRay& ray, const reference::WorldHit& truth) const;

    const Scene& scene_;
    verify::Comparison comparison_;
    dmat4 world_from_frame_;
    bool wants_tangent_;
    verify::Report report_;
    std::mutex mutex_;
};

}  // namespace dsphere::query
