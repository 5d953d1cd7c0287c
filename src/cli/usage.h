#pragma once

#include <CLI/CLI.hpp>

#include <string>

namespace dsphere::cli {

/// What the parser of the command line would take without a word, or refuse without a hint. Error (Usage) for an empty
/// value, and for a command that there is none of: it says which was probably meant.
void checkArguments(const CLI::App& app, int argc, const char* const* argv);

/// The parser's own complaint, with what to type instead.
std::string explained(const CLI::App& app, const CLI::ParseError& error);

}  // namespace dsphere::cli
