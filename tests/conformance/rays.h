#pragma once

// Lists of rays for probes: object space, units of R. Fixed seeds: always the same rays.

#include "render/probe.h"
#include "tests/conformance/world.h"

#include <random>

namespace dsphere::conformance {

using Random = std::mt19937_64;
using Queries = std::vector<ProbeQuery>;

/// Whether the cases are run once more, for another surface or on the host.
bool isRunAgain();

/// Rays of a case that is not made by nested loops: above the 20,000 that every case must trace. A quarter of that
/// where the cases are run once more.
inline const int kRays = isRunAgain() ? 6000 : 24000;
/// The same where faults are rare, and rays random.
inline const int kManyRays = isRunAgain() ? 12000 : 100000;

double uniform(Random& random, double low, double high);
dvec3 randomUnit(Random& random);
/// A unit vector across `axis`.
dvec3 randomAcross(Random& random, const dvec3& axis);
/// `low` to `high` (both > 0), the logarithm evenly spread, with a random sign.
double logarithmic(Random& random, double low, double high);

ProbeQuery aim(const dvec3& from, const dvec3& at);
/// From points `distance` away from the centre towards points within `reach` of it.
Queries randomRays(int count, double distance, double reach, std::uint64_t seed = 1);

}  // namespace dsphere::conformance
