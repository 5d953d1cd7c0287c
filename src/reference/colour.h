#pragma once

#include "scene/scene.h"
#include "surface/colourmap.h"

namespace dsphere::reference {

/// The surface coordinates of a point on a shape, object space: a displaced sphere's as its heights have them, v = 0 in
/// the north; sphere and disk as pbrt has them, v = 1 on top (sphere) or at the inner edge (disk); a mesh's nearest
/// triangle's.
dvec2 surfaceUv(const Shape& shape, const dvec3& p);

/// The colour of an image at a point of a shape: bilinear and repeated; on a displaced sphere its first and last rows
/// run to their means at the poles.
dvec3 imageColour(const Shape& shape, const ImageMap& texture, const ColourMap& image, const dvec3& p);

/// The checkerboard's colour at surface coordinates.
dvec3 checkerboardColour(const Checkerboard& texture, const dvec2& uv);

}  // namespace dsphere::reference
