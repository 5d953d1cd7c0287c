#pragma once

#include "bench/results.h"

namespace dsphere::bench {

/// How a run differs from an earlier one, for a terminal: every method of every view that both have.
std::string changes(const Results& now, const Results& before);

}  // namespace dsphere::bench
