#include "scene/scene.h"

#include <fmt/format.h>

namespace dsphere {

std::string SourceLocation::text() const {
    return fmt::format("{}:{}:{}", file, line, column);
}

}  // namespace dsphere
