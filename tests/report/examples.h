#pragma once

#include "report/results.h"

namespace dsphere::test {

/// Two views, three methods (one skipped, one without errors), names that need escaping.
report::Results exampleResults();

}  // namespace dsphere::test
