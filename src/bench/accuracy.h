#pragma once

#include "bench/contender.h"
#include "report/results.h"

namespace dsphere::bench {

/// `count` pixels of `total`, drawn with a fixed seed; all where there are no more.
std::vector<std::size_t> samplePixels(std::size_t total, std::uint64_t count);

/// Judges answers about a view of the workload on all cores. `comparison` is of its scene and tolerates approximations.
/// `exact` holds the exact marcher's answers about the same pixels: whether a pixel is in shadow is asked where these
/// start, whatever surface the method has put in its place.
report::Accuracy judge(const verify::Comparison& comparison, const View& view, const std::vector<PixelAnswer>& answers,
                       const std::vector<PixelAnswer>& exact, const Progress& progress);

}  // namespace dsphere::bench
