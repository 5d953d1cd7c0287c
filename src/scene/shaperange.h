#pragma once

#include "scene/scene.h"

namespace dsphere {

/// Throws SceneError at the shape for sizes and places in the world that single floats do not hold exactly enough:
/// beyond limits::kLength and limits::kGreatestCoordinate.
void requireShapeInRange(const Shape& shape);

}  // namespace dsphere
