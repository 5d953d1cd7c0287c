#pragma once

#include "report/results.h"

#include <filesystem>

namespace dsphere::report {

/// A page that needs nothing beside it: figures as SVG, light or dark as the reader's system is.
std::string html(const Results& results);

/// The tables and texts of html() in Markdown. `figure`: the path of a picture to show, "": none.
std::string markdown(const Results& results, const std::string& figure);

/// The main figure as a file of its own: primary rays/s against error. Empty where there is nothing to draw.
std::string figureFile(const Results& results);

/// Writes a file whole or not at all. Error (Failure) with the reason.
void writeText(const std::filesystem::path& path, const std::string& text);

}  // namespace dsphere::report
