#pragma once

#include "bench/results.h"

namespace dsphere::test {

/// Two views, three methods (one skipped, one without errors), names that need escaping.
bench::Results exampleResults();

}  // namespace dsphere::test
