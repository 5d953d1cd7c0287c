#pragma once

#include "report/results.h"

namespace dsphere::report {

/// A table a view, for a terminal.
std::string table(const Results& results);

}  // namespace dsphere::report
