#include "render/traits.h"

#include "base/overloads.h"
#include "render/filtertable.h"

#include <algorithm>

namespace dsphere {

namespace {

std::uint32_t bit(int place) {
    return 1u << place;
}

// layout.h and the scene know the same kinds: of lights, the device tells apart those with an image and without, and
// spheres and disks.
static_assert(std::variant_size_v<Geometry> == KIND_COUNT);
static_assert(std::variant_size_v<Light> + 2 == LIGHT_COUNT);

std::uint32_t surfacesOf(const DisplacedSphere& sphere) {
    const int surface = surfaceKind(sphere.filter, sphere.ripples.has_value());
    const bool smooth = surface == SURFACE_BILINEAR && sphere.smooth_normals;
    return bit(surface) | (smooth ? bit(SURFACE_SMOOTH_NORMALS) : 0u);
}

int onlyShape(const Scene& scene, bool displaced) {
    const auto meant = [&](const Shape& shape) {
        return std::holds_alternative<DisplacedSphere>(shape.geometry) == displaced;
    };
    if (std::ranges::count_if(scene.shapes, meant) != 1) return -1;
    return int(std::ranges::find_if(scene.shapes, meant) - scene.shapes.begin());
}

/// Scenes have one at most.
int infiniteLightOf(const Scene& scene) {
    const auto found = std::ranges::find_if(
        scene.lights, [](const Light& light) { return std::holds_alternative<InfiniteLight>(light); });
    return found == scene.lights.end() ? -1 : int(found - scene.lights.begin());
}

SceneTraits::Paths pathsOf(const Scene& scene) {
    SceneTraits::Paths paths;
    paths.materials = 0;
    for (const Shape& shape : scene.shapes) {
        paths.materials |= bit(materialKind(shape.material));
        const auto* matte = std::get_if<Matte>(&shape.material);
        paths.rough_mattes = paths.rough_mattes || (matte && matte->sigma > 0.0);
        if (textureAs<Checkerboard>(shape.material)) paths.checkerboards |= bit(geometryKind(shape.geometry));
        paths.meshes = paths.meshes || std::holds_alternative<TriangleMesh>(shape.geometry);
    }
    for (const Light& light : scene.lights) paths.light_kinds |= bit(lightKind(scene, light));
    paths.infinite_light = infiniteLightOf(scene);
    paths.diffuse_paths = scene.integrator.kind == Integrator::Kind::Path;
    paths.max_depth = std::uint32_t(scene.integrator.max_depth);
    paths.clamp = float(scene.integrator.clamp);
    paths.regularize = paths.diffuse_paths && scene.integrator.regularize;
    paths.hide_distance = scene.integrator.hide_distance;
    paths.filter = filterKind(scene.pixel_filter);
    paths.radius_x = float(scene.pixel_filter.radius.x);
    paths.radius_y = float(scene.pixel_filter.radius.y);
    return paths;
}

}  // namespace

bool SceneTraits::needsPaths() const {
    const std::uint32_t delta_lights = bit(LIGHT_DISTANT) | bit(LIGHT_POINT);
    return paths.materials != bit(MATERIAL_MATTE) || (paths.light_kinds & ~delta_lights) != 0 || paths.rough_mattes ||
           paths.checkerboards != 0 || paths.meshes || paths.diffuse_paths || paths.clamp > 0.0f ||
           paths.filter != FILTER_BOX || paths.radius_x != 0.5f || paths.radius_y != 0.5f;
}

int geometryKind(const Geometry& geometry) {
    return std::visit(
        Overloads{[](const DisplacedSphere&) { return KIND_DISPLACED; }, [](const Sphere&) { return KIND_SPHERE; },
                  [](const Disk&) { return KIND_DISK; }, [](const TriangleMesh&) { return KIND_MESH; }},
        geometry);
}

int surfaceKind(Filter filter, bool ripples) {
    if (ripples) return SURFACE_RIPPLES;
    switch (filter) {
        case Filter::Bilinear:
            return SURFACE_BILINEAR;
        case Filter::BSpline:
            return SURFACE_SPLINE;
    }
    return SURFACE_BILINEAR;
}

int lightKind(const Scene& scene, const Light& light) {
    const auto ofShape = [&](const AreaLight& area) {
        const Shape& shape = scene.shapes[std::size_t(area.shape)];
        return std::holds_alternative<Disk>(shape.geometry) ? LIGHT_DISK : LIGHT_SPHERE;
    };
    return std::visit(
        Overloads{[](const DistantLight&) { return LIGHT_DISTANT; }, [](const PointLight&) { return LIGHT_POINT; },
                  [](const InfiniteLight& sky) { return sky.map_path.empty() ? LIGHT_INFINITE : LIGHT_IMAGE; },
                  ofShape},
        light);
}

SceneTraits traitsOf(const Scene& scene) {
    SceneTraits traits;
    traits.objects = std::uint32_t(scene.shapes.size());
    traits.lights = std::uint32_t(scene.lights.size());
    for (const Shape& shape : scene.shapes) {
        if (textureAs<ImageMap>(shape.material)) traits.images |= bit(geometryKind(shape.geometry));
        traits.ramps = traits.ramps || textureAs<HeightRamp>(shape.material) != nullptr;
        traits.kinds |= bit(geometryKind(shape.geometry));
        if (const auto* mesh = std::get_if<TriangleMesh>(&shape.geometry))
            traits.triangles += std::uint32_t(mesh->triangles.size());
        if (const auto* displaced = std::get_if<DisplacedSphere>(&shape.geometry))
            traits.surfaces |= surfacesOf(*displaced);
    }
    traits.only_displaced = onlyShape(scene, true);
    traits.only_plain = onlyShape(scene, false);
    traits.paths = pathsOf(scene);
    return traits;
}

}  // namespace dsphere
