#pragma once

// How results are written, the same in every report.

#include "report/results.h"

namespace dsphere::report {

/// "fractal 4096x2048, 5 %".
std::string caseName(const ViewResult& view);
/// "14.1 (13.9..14.3)"; "-" if not measured.
std::string megaRays(const Spread& rays_per_second);
/// "14.1", the median alone.
std::string megaRaysMedian(const Spread& rays_per_second);
std::string seconds(const Spread& spread);
std::string mebibytes(std::uint64_t bytes);
/// First hits that are wrong, later roots included, of a million camera rays; "-" without an accuracy.
std::string wrongOfAMillion(const MethodResult& method);
std::string fetches(const MethodResult& method);

}  // namespace dsphere::report
