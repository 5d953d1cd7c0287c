#pragma once

#include "report/results.h"

namespace dsphere::report {

/// The views of one map and displacement.
struct CaseViews {
    std::string name;
    std::vector<const ViewResult*> views;
};

/// In the order of the results, which must outlive them.
std::vector<CaseViews> casesOf(const Results& results);
/// The one to show first: of the middle map, the first displacement. `cases` is not empty.
const CaseViews& mainCase(const std::vector<CaseViews>& cases);

enum class RayKind { Primary, Shadow };

// SVG; empty where there is nothing to draw.

/// Rays/s against the error of 99.9 % of the hits, a panel a view.
std::string speedFigure(const CaseViews& of, RayKind kind);
/// Primary rays/s against the map's width, a panel a view; needs two widths under one displacement.
std::string sizeFigure(const Results& results);
/// Time to the first image, and memory, a row a method.
std::string setupFigure(const Results& results);
std::string memoryFigure(const Results& results);

}  // namespace dsphere::report
