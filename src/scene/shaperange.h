#pragma once

#include "scene/scene.h"

#include <optional>
#include <string>

namespace dsphere {

/// Throws SceneError at the shape for sizes and places in the world that single floats do not hold exactly enough:
/// beyond limits::kLength and limits::kGreatestCoordinate.
void requireShapeInRange(const Shape& shape);

/// What is wrong with a camera whose eye lies beyond limits::kGreatestCoordinate; unset where nothing is.
std::optional<std::string> eyeOutOfRange(const Camera& camera);

}  // namespace dsphere
