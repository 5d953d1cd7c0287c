#pragma once

// The accuracy contract in numbers, and what a run measured against it. R is an object's greatest radius; distances are
// in object space.

#include <nlohmann/json_fwd.hpp>

#include <cstdint>
#include <string>
#include <vector>

namespace dsphere::verify {

namespace contract {
inline constexpr double kSideways = 1e-6;      ///< R; moving a ray by this may change a tangent ray's answer
inline constexpr double kTangentShare = 1e-4;  ///< of the rays, plus kTangentFree, may be excused as tangent
inline constexpr int kTangentFree = 2;
inline constexpr double kDistance999 = 3e-7;    ///< R; 99.9 % of the hits lie this close to the surface
inline constexpr double kDistanceAll = 1e-6;    ///< R; all hits
inline constexpr double kAlongRay = 1e-6;       ///< R / |cos(d, N)|, plus two ulp of t
inline constexpr double kNormalDegrees = 0.02;  ///< 99 % of the normals
inline constexpr double kNormalShare = 0.99;
inline constexpr double kColour = 1e-4;  ///< relative
}  // namespace contract

/// A pixel or ray that broke the contract, for the message.
struct Fault {
    std::uint64_t ray;
    std::string what;
};

struct Report {
    std::uint64_t rays = 0, hits = 0;
    std::uint64_t wrong_verdicts = 0;  ///< hit against miss, another object, or a root before the first
    std::uint64_t later_roots = 0;
    std::uint64_t tangent = 0;           ///< excused
    std::uint64_t along_ray_faults = 0;  ///< the right root, too far off along the ray
    std::uint64_t not_finite = 0, runaways = 0;
    std::uint64_t shadow_rays = 0, wrong_shadows = 0, tangent_shadows = 0;
    std::uint64_t colours = 0, wrong_colours = 0;
    std::vector<float> distances;       ///< to the surface, R, one a hit that is not `inside`
    std::vector<float> normal_degrees;  ///< against the normal of the surface at the device's own point
    double worst_along_ray = 0.0;       ///< as a share of its bound
    double worst_colour = 0.0;          ///< relative, as a share of its bound
    std::vector<Fault> faults;          ///< the first few

    /// Adds another report's counts; `distances` and `normal_degrees` are appended.
    void merge(Report&& other);
    void addFault(std::uint64_t ray, std::string what);

    double distanceQuantile(double share) const;  ///< 0 without hits
    double normalQuantile(double share) const;
    /// What breaks the contract, one line each; empty if nothing does.
    std::vector<std::string> violations() const;
    bool passed() const { return violations().empty(); }

    std::string table() const;  ///< for a terminal
    nlohmann::ordered_json json() const;
};

}  // namespace dsphere::verify
