#pragma once

#include "scene/scene.h"

#include <filesystem>
#include <string>

namespace dsphere::viewer {

/// The camera as pbrt text: a Transform and a Camera directive. Parsing it gives the same camera, bit for bit.
std::string cameraText(const Camera& camera);

/// The whole scene as pbrt text for a file in `folder`, to which the names of maps and images are made relative.
std::string sceneText(const Scene& scene, const std::filesystem::path& folder);

}  // namespace dsphere::viewer
