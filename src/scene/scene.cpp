#include "scene/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace dsphere {

std::string SourceLocation::text() const {
    return line > 0 ? fmt::format("{}:{}:{}", file, line, column) : file;
}

const char* nameOf(PixelFilter::Kind kind) {
    constexpr const char* kNames[] = {"box", "gaussian", "triangle", "mitchell", "sinc"};
    return kNames[int(kind)];
}

dvec3 middleOf(const TriangleMesh& mesh) {
    dvec3 least = mesh.points.front(), greatest = least;
    for (const dvec3& point : mesh.points) {
        least = glm::min(least, point);
        greatest = glm::max(greatest, point);
    }
    return 0.5 * (least + greatest);
}

Material regularized(Material material) {
    const auto widen = [](double& alpha) {
        if (alpha < 0.3) alpha = std::clamp(2.0 * alpha, 0.1, 0.3);
    };
    if (auto* conductor = std::get_if<Conductor>(&material)) widen(conductor->alpha);
    if (auto* plastic = std::get_if<Plastic>(&material)) widen(plastic->alpha);
    return material;
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
