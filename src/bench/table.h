#pragma once

#include "bench/results.h"

namespace dsphere::bench {

/// A table a view, for a terminal.
std::string table(const Results& results);

}  // namespace dsphere::bench
