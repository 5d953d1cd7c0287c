#pragma once

#include "bench/runner.h"

namespace dsphere::bench {

/// What the default suite holds.
struct Suite {
    std::vector<int> widths = {1024, 4096, 8192};      ///< of the maps, texels
    std::vector<double> percents = {5.0, 15.0, 50.0};  ///< displacements
    std::vector<std::string> views;                    ///< words of standardViews(); empty: all
    int width = 1280, height = 720;                    ///< pixels
};

/// Every map under every displacement from every view. Error (Usage) names an unknown view or a map width that is odd
/// or outside 2 to 16,384.
std::vector<Source> suiteSources(const Suite& suite);

}  // namespace dsphere::bench
