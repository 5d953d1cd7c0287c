#pragma once

#include "report/results.h"

namespace dsphere::report {

/// How a run differs from an earlier one, for a terminal: every method of every view that both have.
std::string changes(const Results& now, const Results& before);

}  // namespace dsphere::report
