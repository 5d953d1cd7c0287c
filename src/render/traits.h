#pragma once

#include "scene/scene.h"
#include "shaders/layout.h"

#include <cstdint>

namespace dsphere {

/// What of a scene pipelines are specialised to: known before its maps are read.
struct SceneTraits {
    std::uint32_t objects = 0, lights = 0;
    std::uint32_t kinds = 0, surfaces = 0;     ///< bit per KIND_ and SURFACE_ in use
    std::uint32_t images = 0;                  ///< bit per KIND_ of the shapes with a colour image
    bool ramps = false;                        ///< a shape has one
    bool tiles = false;                        ///< a map stays in its file: known once their files are opened
    std::uint32_t triangles = 0;               ///< of all meshes
    int only_displaced = -1, only_plain = -1;  ///< the only shape of its kind, by its index; -1: none or several

    /// What shade_paths alone knows. Without it: Lambertian surfaces, distant and point lights, and one box
    /// as large as a pixel for a filter.
    struct Paths {
        std::uint32_t materials = 1u << MATERIAL_MATTE, light_kinds = 0;  ///< bit per MATERIAL_ and LIGHT_ in use
        int infinite_light = -1;                                          ///< its index; -1: there is none
        std::uint32_t checkerboards = 0;                                  ///< bit per KIND_ of the shapes that have one
        bool rough_mattes = false, meshes = false;
        bool diffuse_paths = false;  ///< path, not directlighting
        std::uint32_t max_depth = 0;
        float clamp = 0.0f;  ///< 0: none
        bool regularize = false, hide_distance = false;
        int filter = FILTER_BOX;  ///< FILTER_ of the pixel filter
        float radius_x = 0.5f, radius_y = 0.5f;

        bool operator==(const Paths&) const = default;
    } paths;

    bool operator==(const SceneTraits&) const = default;
    /// Whether the shaders of scene_planet may be taken.
    bool onePlanet() const { return objects == 1 && kinds == 1u << KIND_DISPLACED; }
    /// Whether those of patch_curved are needed.
    bool curved() const { return surfaces > 1u << SURFACE_BILINEAR; }
    /// Whether those of shade_paths are.
    bool needsPaths() const;
};

SceneTraits traitsOf(const Scene& scene);

/// KIND_, SURFACE_, LIGHT_ and MATERIAL_ of the scene's.
int geometryKind(const Geometry& geometry);
int surfaceKind(Filter filter, bool ripples);
int lightKind(const Scene& scene, const Light& light);
int materialKind(const Material& material);

}  // namespace dsphere
