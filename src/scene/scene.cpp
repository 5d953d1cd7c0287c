#include "scene/scene.h"

#include <fmt/format.h>

namespace dsphere {

std::string SourceLocation::text() const {
    return line > 0 ? fmt::format("{}:{}:{}", file, line, column) : file;
}

}  // namespace dsphere
