#include "scene/scene.h"

#include "base/overloads.h"

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
    std::visit(Overloads{[](Matte&) {}, [&](Conductor& metal) { widen(metal.alpha); }, [](Mirror&) {},
                         [&](Plastic& plastic) { widen(plastic.alpha); }},
               material);
    return material;
}

const Texture* textureOf(const Material& material) {
    using Found = const Texture*;
    return std::visit(
        Overloads{[](const Matte& matte) -> Found { return &matte.reflectance; },
                  [](const Conductor&) -> Found { return nullptr; }, [](const Mirror&) -> Found { return nullptr; },
                  [](const Plastic& plastic) -> Found { return &plastic.diffuse; }},
        material);
}

Texture* textureOf(Material& material) {
    return const_cast<Texture*>(textureOf(std::as_const(material)));
}

}  // namespace dsphere
