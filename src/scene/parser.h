#pragma once

#include "scene/scene.h"

#include <filesystem>
#include <string_view>

namespace dsphere {

/// Parses a scene file (a strict subset of pbrt, v3 and v4 spellings); "-" reads standard input.
/// Throws Error (InvalidInput) "file:line:column: what was wrong; what is supported".
Scene parseSceneFile(const std::filesystem::path& path);

/// Parses scene text. `name` stands in messages; relative paths are resolved against `folder`.
Scene parseScene(std::string_view text, const std::string& name, const std::filesystem::path& folder);

}  // namespace dsphere
