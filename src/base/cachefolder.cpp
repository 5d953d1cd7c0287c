#include "base/cachefolder.h"

#include <cstdlib>

namespace dsphere {

std::filesystem::path cacheFolder() {
    namespace fs = std::filesystem;
    const char* cache = std::getenv("XDG_CACHE_HOME");
    // The XDG base directory specification: a relative path there is to be ignored.
    if (cache && fs::path(cache).is_absolute()) return fs::path(cache) / "dsphere";
    const char* home = std::getenv("HOME");
    if (home && fs::path(home).is_absolute()) return fs::path(home) / ".cache" / "dsphere";
    return {};
}

}  // namespace dsphere
