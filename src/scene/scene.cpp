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

Texture matteTextureOf(const Material& material) {
    const auto ofMetal = [](const Conductor& metal) -> Texture {
        // Fresnel's reflectance at normal incidence.
        const dvec3 below = metal.eta - 1.0, above = metal.eta + 1.0, k2 = metal.k * metal.k;
        return ConstantColour{(below * below + k2) / (above * above + k2)};
    };
    return std::visit(Overloads{[](const Matte& matte) { return matte.reflectance; }, ofMetal,
                                [](const Mirror& mirror) -> Texture { return ConstantColour{mirror.reflectance}; },
                                [](const Plastic& plastic) { return plastic.diffuse; }},
                      material);
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
