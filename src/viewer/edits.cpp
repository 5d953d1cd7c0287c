#include "viewer/edits.h"

#include <fmt/ranges.h>

#include <algorithm>

#include <glm/gtx/component_wise.hpp>

#include "render/traits.h"
#include "shaders/layout.h"

namespace dsphere::viewer {

namespace {

DistantLight* mutableSun(Scene& scene) {
    for (Light& light : scene.lights)
        if (auto* distant = std::get_if<DistantLight>(&light)) return distant;
    return nullptr;
}

/// A distant light exactly opposite to the sun, as a saved scene has it.
struct NightLight {
    std::size_t light;
    double share;  ///< of the sun's radiance
};

std::optional<NightLight> nightLightOf(const Scene& scene) {
    const DistantLight* sun = sunOf(scene);
    if (!sun || glm::compMax(sun->radiance) <= 0.0) return {};
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const auto* light = std::get_if<DistantLight>(&scene.lights[i]);
        if (!light || light->direction != -sun->direction) continue;
        const double share = glm::compMax(light->radiance) / glm::compMax(sun->radiance);
        const double off = glm::length(light->radiance - share * sun->radiance);
        if (share <= 1.0 && off <= 1e-12 * glm::length(sun->radiance)) return NightLight{i, share};
    }
    return {};
}

void editShape(Shape& shape, const ShapeEdits& edits) {
    if (auto* sphere = std::get_if<DisplacedSphere>(&shape.geometry)) {
        sphere->max_displacement *= edits.exaggeration;
        if (sphere->height_scale) *sphere->height_scale *= edits.exaggeration;
        if (edits.midlevel) sphere->midlevel = *edits.midlevel;
        if (edits.filter && !sphere->ripples) sphere->filter = *edits.filter;
    }
    if (edits.texture)
        if (Texture* texture = textureOf(shape.material)) *texture = *edits.texture;
}

// An image that comes or goes is read with its scene.
Rework reworkOf(const Texture* shown, const Texture* wanted) {
    if (!shown || !wanted) return shown == wanted ? Rework::Nothing : Rework::Reading;
    if (*shown == *wanted) return Rework::Nothing;
    const bool images = std::holds_alternative<ImageMap>(*shown) || std::holds_alternative<ImageMap>(*wanted) ||
                        std::holds_alternative<Checkerboard>(*shown) || std::holds_alternative<Checkerboard>(*wanted);
    return images ? Rework::Reading : Rework::Look;
}

// No edit changes which value is unknown; it may be NaN, which nothing equals.
DisplacedSphere withoutNodata(DisplacedSphere sphere) {
    sphere.nodata.reset();
    return sphere;
}

Rework reworkOf(const Geometry& shown, const Geometry& wanted) {
    const auto* before = std::get_if<DisplacedSphere>(&shown);
    const auto* after = std::get_if<DisplacedSphere>(&wanted);
    if (!before || !after) return shown == wanted ? Rework::Nothing : Rework::Reading;
    if (withoutNodata(*before) == withoutNodata(*after)) return Rework::Nothing;
    return before->filter == after->filter ? Rework::Relief : Rework::Reading;
}

}  // namespace

Edits noEdits(const Scene& scene, double exaggeration) {
    Edits edits{std::vector<ShapeEdits>(scene.shapes.size()), {}};
    if (const std::optional<NightLight> night = nightLightOf(scene)) edits.night_light = night->share;
    for (std::size_t i = 0; i < scene.shapes.size(); ++i)
        if (std::holds_alternative<DisplacedSphere>(scene.shapes[i].geometry))
            edits.shapes[i].exaggeration = exaggeration;
    return edits;
}

Scene edited(const Scene& original, const Edits& edits) {
    Scene scene = original;
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) editShape(scene.shapes[i], edits.shapes[i]);
    if (DistantLight* sun = mutableSun(scene)) {
        if (edits.sun_direction) sun->direction = *edits.sun_direction;
        sun->radiance *= edits.sun_brightness;
        const DistantLight opposite{-sun->direction, edits.night_light * sun->radiance};
        const std::optional<NightLight> own = nightLightOf(original);
        const bool as_it_was = own && own->share == edits.night_light && *sun == *sunOf(original);
        if (own && !as_it_was)
            scene.lights[own->light] = opposite;
        else if (!own && edits.night_light > 0.0 && scene.lights.size() < MAX_LIGHTS)
            scene.lights.emplace_back(opposite);
    }
    return scene;
}

Edits refit(const Edits& edits, const Scene& scene, double exaggeration, std::vector<std::string>& lost) {
    Edits fitted = edits;
    fitted.shapes = noEdits(scene, exaggeration).shapes;
    std::copy_n(edits.shapes.begin(), std::min(edits.shapes.size(), fitted.shapes.size()), fitted.shapes.begin());
    for (std::size_t i = 0; i < edits.shapes.size(); ++i) {
        const ShapeEdits& was = edits.shapes[i];
        if (was == ShapeEdits{}) continue;
        if (i >= scene.shapes.size()) {
            lost.push_back(fmt::format("shape {} is gone", i + 1));
            continue;
        }
        const Shape& shape = scene.shapes[i];
        ShapeEdits& now = fitted.shapes[i];
        const bool relief = was.exaggeration != 1.0 || was.midlevel || was.filter;
        if (relief && !std::holds_alternative<DisplacedSphere>(shape.geometry)) {
            lost.push_back(fmt::format("{} has no relief now", shapeName(scene, i)));
            now = {.texture = was.texture};
        }
        if (was.texture && !textureOf(shape.material)) {
            lost.push_back(fmt::format("the material of {} has no colour now", shapeName(scene, i)));
            now.texture.reset();
        }
    }
    if ((edits.sun_direction || edits.sun_brightness != 1.0 || edits.night_light > 0.0) && !sunOf(scene)) {
        lost.push_back("there is no sun now");
        fitted.sun_direction.reset();
        fitted.sun_brightness = 1.0;
        fitted.night_light = 0.0;
    }
    return fitted;
}

std::string inWords(const Edits& edits, const Edits& others) {
    const auto differs = [&](auto field) {
        return !std::ranges::equal(edits.shapes, others.shapes, [&](const ShapeEdits& one, const ShapeEdits& other) {
            return one.*field == other.*field;
        });
    };
    std::vector<const char*> words;
    const auto tell = [&](bool changed, const char* word) {
        if (changed) words.push_back(word);
    };
    tell(differs(&ShapeEdits::exaggeration), "exaggeration");
    tell(differs(&ShapeEdits::midlevel), "zero level");
    tell(differs(&ShapeEdits::filter), "surface");
    tell(differs(&ShapeEdits::texture), "colour");
    tell(edits.sun_direction != others.sun_direction, "the sun's direction");
    tell(edits.sun_brightness != others.sun_brightness, "the sun's brightness");
    tell(edits.night_light != others.night_light, "night side");
    return fmt::format("{}", fmt::join(words, ", "));
}

Rework reworkBetween(const Scene& shown, const Scene& wanted) {
    Rework rework = shown.lights == wanted.lights ? Rework::Nothing : Rework::Look;
    if (shown.lights.size() != wanted.lights.size()) rework = Rework::Reading;
    for (std::size_t i = 0; i < shown.shapes.size(); ++i) {
        const Shape &before = shown.shapes[i], &after = wanted.shapes[i];
        rework = std::max({rework, reworkOf(before.geometry, after.geometry),
                           reworkOf(textureOf(before.material), textureOf(after.material))});
    }
    // Pipelines are made for some traits, such as whether anything is coloured by its heights.
    if (rework == Rework::Look && traitsOf(shown) != traitsOf(wanted)) rework = Rework::Relief;
    return rework;
}

const DistantLight* sunOf(const Scene& scene) {
    return mutableSun(const_cast<Scene&>(scene));
}

std::string shapeName(const Scene& scene, std::size_t shape) {
    const Geometry& geometry = scene.shapes[shape].geometry;
    const char* kind = "planet";
    if (std::holds_alternative<Sphere>(geometry)) kind = "sphere";
    if (std::holds_alternative<Disk>(geometry)) kind = "disk";
    if (std::holds_alternative<TriangleMesh>(geometry)) kind = "mesh";
    return scene.shapes.size() > 1 ? fmt::format("{} {}", kind, shape + 1) : kind;
}

}  // namespace dsphere::viewer
