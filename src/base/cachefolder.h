#pragma once

#include <filesystem>

namespace dsphere {

/// $XDG_CACHE_HOME/dsphere, else $HOME/.cache/dsphere; empty if neither variable holds an absolute path.
std::filesystem::path cacheFolder();

}  // namespace dsphere
