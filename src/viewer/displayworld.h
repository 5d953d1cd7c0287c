#pragma once

#include "shaders/displaylayout.h"
#include "viewer/document.h"

#include <string>

namespace dsphere::viewer {

/// What heights are said in: those of the map's own facts, else stored values.
struct HeightUnit {
    double scale = 1.0, offset = 0.0;  ///< height = offset + scale * stored value
    std::string name;                  ///< "m"; empty: unknown

    double of(double stored) const { return offset + scale * stored; }
};

HeightUnit heightUnitOf(const Heightmap& map);
/// Of a shape of the document; stored values where it has no map.
HeightUnit heightUnitOf(const Document& document, std::size_t shape);

/// The least and greatest height of a displaced sphere of the document, in its unit.
std::pair<double, double> heightRange(const Document& document, std::size_t shape);

/// What display.comp knows of the document's objects.
layout::DisplayWorld displayWorld(const Document& document);

/// 1, 2 or 5 times a power of ten: the greatest that is not above `most` (> 0).
double roundStep(double most);

}  // namespace dsphere::viewer
