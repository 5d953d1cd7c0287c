#pragma once

#include "viewer/camera.h"
#include "viewer/document.h"

#include <optional>
#include <string>

namespace dsphere::viewer {

/// What lengths of the world are said in.
struct LengthUnit {
    double per_world = 1.0;  ///< such units in a unit of the world
    bool metres = false;     ///< else radii of the globe

    /// "12.3 km", "0.25 R": of a length of the world.
    std::string text(double length) const;
    /// "m" or "R".
    const char* name() const { return metres ? "m" : "R"; }
};

/// Metres where the shape's map knows its radius.
LengthUnit lengthUnitOf(const Document& document, const Globe& globe, std::size_t shape);

/// What the window's instruments show of the view.
struct Gauges {
    dvec2 north{0.0};          ///< on the window, right and up; the shorter the more it points into the picture
    std::optional<dvec3> sun;  ///< towards it: right, up, towards the viewer; unit
    double pixel = 0.0;        ///< world length of a pixel of the window in its middle
    LengthUnit unit;
};

/// Of a picture of width x height pixels.
Gauges gaugesOf(const CameraControl& control, const Document& document, int width, int height);

}  // namespace dsphere::viewer
