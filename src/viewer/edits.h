#pragma once

#include "scene/scene.h"

#include <optional>
#include <vector>

namespace dsphere::viewer {

/// What the panel has changed of one shape; unset: as the file says.
struct ShapeEdits {
    double exaggeration = 1.0;       ///< factor of the file's displacement
    std::optional<double> midlevel;  ///< of displaced spheres, as the filter
    std::optional<Filter> filter;
    std::optional<Texture> texture;  ///< of materials that have one

    bool operator==(const ShapeEdits&) const = default;
};

/// All that the panel has changed of a scene. They stay when the file changes on disk.
struct Edits {
    std::vector<ShapeEdits> shapes;      ///< one a shape
    std::optional<dvec3> sun_direction;  ///< of the first distant light: world, unit
    double sun_brightness = 1.0;         ///< factor of its radiance
    double night_light = 0.0;            ///< of the light opposite to it, as a share of it; 0: there is none

    bool operator==(const Edits&) const = default;
};

/// No edit of a scene, whose light opposite to the sun is the night side's, but the factor that its displaced spheres
/// begin with.
Edits noEdits(const Scene& scene, double exaggeration);

/// The scene with its edits, which are of as many shapes.
Scene edited(const Scene& original, const Edits& edits);

/// What is left of edits for another version of the scene, whose further shapes have none but `exaggeration`; the words
/// for each edit that no longer fits go to `lost`.
Edits refit(const Edits& edits, const Scene& scene, double exaggeration, std::vector<std::string>& lost);

/// What differs between edits of the same scene, in words: "exaggeration, sun".
std::string inWords(const Edits& edits, const Edits& others);

/// What it takes to show a scene's shapes and lights when others are shown, the least first.
enum class Rework { Nothing, Look, Relief, Reading };
Rework reworkBetween(const Scene& shown, const Scene& wanted);

/// The first distant light, which the panel calls the sun; null: there is none.
const DistantLight* sunOf(const Scene& scene);

/// "planet 2", "sphere", "disk 3": a shape as messages and the panel call it, numbered where there are several shapes.
std::string shapeName(const Scene& scene, std::size_t shape);

}  // namespace dsphere::viewer
