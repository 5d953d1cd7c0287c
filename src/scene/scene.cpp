#include "scene/scene.h"

#include <fmt/format.h>

#include <utility>

namespace dsphere {

std::string SourceLocation::text() const {
    return line > 0 ? fmt::format("{}:{}:{}", file, line, column) : file;
}

dvec3 middleOf(const TriangleMesh& mesh) {
    dvec3 least = mesh.points.front(), greatest = least;
    for (const dvec3& point : mesh.points) {
        least = glm::min(least, point);
        greatest = glm::max(greatest, point);
    }
    return 0.5 * (least + greatest);
}

const Texture* textureOf(const Material& material) {
    if (const auto* matte = std::get_if<Matte>(&material)) return &matte->reflectance;
    if (const auto* plastic = std::get_if<Plastic>(&material)) return &plastic->diffuse;
    return nullptr;
}

Texture* textureOf(Material& material) {
    return const_cast<Texture*>(textureOf(std::as_const(material)));
}

}  // namespace dsphere
