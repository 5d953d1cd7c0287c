#pragma once

#include "bench/method.h"
#include "bench/workload.h"
#include "report/results.h"

#include <functional>

namespace dsphere::bench {

struct Plan {
    std::vector<Method> methods;
    int repeats = 7;               ///< timed runs of each method, after one that warms it
    double seconds = 4.0;          ///< a method that takes longer on a view is repeated less, three times at least
    int setups = 3;                ///< times that the set-up is measured
    std::uint64_t samples = 4000;  ///< pixels a view to hold against the reference
};

/// A workload that is made when its turn comes, for maps are large.
struct Source {
    std::function<Workload()> make;
    int views = 1;
};

/// Measures every method on every view of every source, one source after another. Methods take turns, so that what else
/// the machine does hits all alike. Errors of rendering and Embree; Error (Interrupted) when `progress` says stop.
std::vector<report::ViewResult> measure(gpu::Device& device, const std::vector<Source>& sources, const Plan& plan,
                                        const Progress& progress);

}  // namespace dsphere::bench
