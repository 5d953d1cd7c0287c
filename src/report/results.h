#pragma once

// What a run measured: plain data, written to and read from JSON.

#include "report/statistics.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace dsphere::report {

/// Against the certified reference, on a sample of a view's pixels.
struct Accuracy {
    std::uint64_t rays = 0, hits = 0;
    std::uint64_t wrong_verdicts = 0, later_roots = 0, tangent = 0;  ///< tangent: excused
    std::uint64_t shadow_rays = 0, wrong_shadows = 0, tangent_shadows = 0;
    std::uint64_t runaways = 0;                                                 ///< stopped by the step limit
    double distance_median = 0.0, distance_999 = 0.0, distance_greatest = 0.0;  ///< to the surface, units of R
    double pixels_median = 0.0, pixels_999 = 0.0, pixels_greatest = 0.0;        ///< the same as seen, in pixels
};

/// Rays a second. Meshes are traced on the host: device and wall are then the same.
struct Speed {
    Spread device, wall;
};

struct MethodResult {
    std::string method, family;
    std::string skipped;  ///< why it was not run; empty if it was
    Speed primary, shadow;
    std::uint64_t shadow_rays = 0;
    double fetches_per_hit = 0.0;    ///< of heights and bounds, primary rays that hit; 0 for meshes
    Spread setup_seconds;            ///< from the map in memory to the first pixels on the host; first view alone
    std::uint64_t memory_bytes = 0;  ///< maps, bounds or mesh, and the film of t
    std::optional<Accuracy> accuracy;
};

struct ViewResult {
    std::string map;
    int map_width = 0, map_height = 0;
    double percent = 0.0;
    std::string view;
    int width = 0, height = 0;  ///< pixels
    double hit_share = 0.0;
    std::vector<MethodResult> methods;
};

struct Environment {
    std::string version, commit, date;  ///< date: UTC, ISO 8601
    std::string cpu;
    int cores = 0;
    double load = 0.0;  ///< what else ran when it began: processes ready to run, the mean of a minute
    std::string device, driver;
    double device_open_seconds = 0.0;  ///< the driver's start-up
    std::string embree;                ///< version; empty without
};

struct Results {
    Environment environment;
    bool quick = false;
    int repeats = 0;
    std::uint64_t samples = 0;  ///< pixels a view held against the reference
    std::vector<ViewResult> views;
};

}  // namespace dsphere::report
