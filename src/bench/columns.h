#pragma once

// The tables of the HTML and Markdown reports, as plain text.

#include "bench/results.h"

namespace dsphere::bench {

using Cells = std::vector<std::string>;

/// Names of a view's columns, with their units.
const Cells& columnNames();
/// A method's cells; the first is its name.
Cells cellsOf(const MethodResult& method);

/// The exact marcher against the full grid mesh, a row a view: how often its speed, its set-up and its memory. Empty
/// without both.
const Cells& peerColumnNames();
std::vector<Cells> peerRows(const Results& results);

/// Name and value: what was measured where, and how.
std::vector<std::pair<std::string, std::string>> facts(const Results& results);

/// Paragraphs that say what the columns mean.
const Cells& explanations();

}  // namespace dsphere::bench
