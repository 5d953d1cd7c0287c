#pragma once

#include "report/results.h"

namespace dsphere::report {

/// One line a view and method after a line of column names (RFC 4180); what was not measured is empty.
std::string csv(const Results& results);

}  // namespace dsphere::report
