#include "host/kernel.h"

#include "render/variants.h"

namespace dsphere::host {

// fill_MARCH_VARIANT_REAL: see CMakeLists.txt.
#define DECLARE(name)                                                                                         \
    void name(const HostScene& scene, const Specialization& specialization, const layout::RenderParams& tile, \
              HostFilm& film, std::vector<layout::RetryPixel>& retry);
#define DECLARE_VARIANTS(march)           \
    DECLARE(fill_##march##_lean_float)    \
    DECLARE(fill_##march##_curved_float)  \
    DECLARE(fill_##march##_paths_float)   \
    DECLARE(fill_##march##_lean_double)   \
    DECLARE(fill_##march##_curved_double) \
    DECLARE(fill_##march##_paths_double)
DECLARE_VARIANTS(filter)
DECLARE_VARIANTS(full)
DECLARE_VARIANTS(baseline)

// probe_VARIANT_REAL.
#define DECLARE_PROBE(name)                                                                                         \
    void name(const HostScene& scene, const Specialization& specialization, std::span<const layout::ProbeRay> rays, \
              std::span<layout::ProbeHit> hits);
DECLARE_PROBE(probe_lean_float)
DECLARE_PROBE(probe_curved_float)
DECLARE_PROBE(probe_lean_double)
DECLARE_PROBE(probe_curved_double)

namespace {

/// One way to march.
struct March {
    VariantsOf<FillTile> floats, doubles;

    FillTile of(const SceneTraits& traits, Precision precision) const {
        return (precision == Precision::Float ? floats : doubles).of(traits);
    }
};

#define MARCH(march)                                                                              \
    {                                                                                             \
        {fill_##march##_lean_float, fill_##march##_curved_float, fill_##march##_paths_float}, {   \
            fill_##march##_lean_double, fill_##march##_curved_double, fill_##march##_paths_double \
        }                                                                                         \
    }
constexpr March kFilter = MARCH(filter), kFull = MARCH(full), kBaseline = MARCH(baseline);

}  // namespace

ProbeRays probeFor(const SceneTraits& traits, Precision precision) {
    if (precision == Precision::Float) return traits.curved() ? probe_curved_float : probe_lean_float;
    return traits.curved() ? probe_curved_double : probe_lean_double;
}

Kernels kernelsFor(const SceneTraits& traits, const MarchMethod& method, Precision precision) {
    if (method.marcher != Marcher::Exact) return {kBaseline.of(traits, precision), nullptr};
    return {kFilter.of(traits, precision), kFull.of(traits, precision)};
}

}  // namespace dsphere::host
