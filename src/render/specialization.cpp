#include "render/specialization.h"

#include "base/error.h"
#include "surface/slope.h"

#include <algorithm>
#include <bit>
#include <cmath>

namespace dsphere {

static_assert(int(Marcher::Exact) == MARCHER_EXACT && int(Marcher::Naive) == MARCHER_NAIVE &&
              int(Marcher::NaiveShell) == MARCHER_NAIVE_SHELL && int(Marcher::Lipschitz) == MARCHER_LIPSCHITZ);

// For the steepest of the scene's maps; rounded down.
float safeStride(const PackedScene& packed, const MarchMethod& method) {
    if (method.marcher != Marcher::Lipschitz) return 1.0f;
    if (packed.traits.curved())
        throwInvalid(
            "the Lipschitz marcher knows bilinear surfaces alone; the scene has a B-spline, ripples or smooth normals");
    double bound = 1.0;
    for (const PackedRelief& relief : packed.reliefs)
        bound = std::max(bound, gradientBound(*packed.nodes[std::size_t(relief.map)], relief.base, relief.scale));
    return std::nextafter(float(1.0 / bound), 0.0f);
}

Specialization specializationOf(const SceneTraits& traits, float stride, const MarchMethod& method,
                                std::uint32_t planes) {
    Specialization specialization = {};
    specialization[SPEC_MARCHER] = std::uint32_t(method.marcher);
    specialization[SPEC_OBJECT_COUNT] = traits.objects;
    specialization[SPEC_LIGHT_COUNT] = traits.lights;
    specialization[SPEC_KINDS] = traits.kinds;
    specialization[SPEC_ONLY_DISPLACED] = std::uint32_t(traits.only_displaced);
    specialization[SPEC_ONLY_PLAIN] = std::uint32_t(traits.only_plain);
    specialization[SPEC_TURNS] = 1;
    specialization[SPEC_TILES] = traits.tiles ? (traits.curved() ? 2 : 1) : 0;
    specialization[SPEC_PLANES] = planes;
    specialization[SPEC_IMAGES] = traits.images;
    specialization[SPEC_RAMPS] = traits.ramps ? 1 : 0;
    specialization[SPEC_SURFACES] = traits.surfaces;
    specialization[SPEC_THRESHOLD] = std::bit_cast<std::uint32_t>(method.threshold);
    specialization[SPEC_STRIDE] = std::bit_cast<std::uint32_t>(stride);
    specialization[SPEC_DETAIL] = std::bit_cast<std::uint32_t>(method.detail);
    specialization[SPEC_SHADOWS] = method.shadows ? 1 : 0;
    specialization[SPEC_RETRY_STRIDE] = 1;
    const SceneTraits::Paths& paths = traits.paths;
    specialization[SPEC_MATERIALS] = paths.materials;
    specialization[SPEC_LIGHT_KINDS] = paths.light_kinds;
    specialization[SPEC_INFINITE_LIGHT] = std::uint32_t(paths.infinite_light);
    specialization[SPEC_ROUGH_MATTES] = paths.rough_mattes ? 1 : 0;
    specialization[SPEC_CHECKERBOARDS] = paths.checkerboards;
    specialization[SPEC_MAX_DEPTH] = paths.max_depth;
    specialization[SPEC_DIFFUSE_PATHS] = paths.diffuse_paths ? 1 : 0;
    specialization[SPEC_CLAMP] = std::bit_cast<std::uint32_t>(paths.clamp);
    specialization[SPEC_REGULARIZE] = paths.regularize ? 1 : 0;
    specialization[SPEC_HIDE_DISTANCE] = paths.hide_distance ? 1 : 0;
    specialization[SPEC_FILTER] = std::uint32_t(paths.filter);
    specialization[SPEC_RADIUS_X] = std::bit_cast<std::uint32_t>(paths.radius_x);
    specialization[SPEC_RADIUS_Y] = std::bit_cast<std::uint32_t>(paths.radius_y);
    return specialization;
}

}  // namespace dsphere
