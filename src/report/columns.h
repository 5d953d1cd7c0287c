#pragma once

// The tables of the HTML and Markdown reports, as plain text.

#include "report/results.h"

namespace dsphere::report {

using Cells = std::vector<std::string>;

/// Names of a view's columns, with their units.
const Cells& columnNames();
/// A method's cells; the first is its name.
Cells cellsOf(const MethodResult& method);

/// The exact marcher over the full grid mesh, a row a view. Empty without both.
inline constexpr const char* kPeerText =
    "Ratios to Embree's grid of all nodes, from the same run. Rays a second: above 1x is faster. Set-up time, memory "
    "and "
    "error (distance to the surface of 99.9 % of the hits): below 1x is less.";
const Cells& peerColumnNames();
std::vector<Cells> peerRows(const Results& results);

/// Name and value: what was measured where, and how.
std::vector<std::pair<std::string, std::string>> facts(const Results& results);

/// Paragraphs that say what the columns mean.
const Cells& explanations();

}  // namespace dsphere::report
