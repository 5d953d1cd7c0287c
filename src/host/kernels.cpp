#include "host/kernels.h"

namespace dsphere::host {

ProbeRays probeFor(const SceneTraits& traits, Precision precision) {
    if (precision == Precision::Float) return traits.curved() ? probe_curved_float : probe_lean_float;
    return traits.curved() ? probe_curved_double : probe_lean_double;
}

Kernels kernelsFor(const SceneTraits& traits, const MarchMethod& method, Precision precision) {
    const bool exact = method.marcher == Marcher::Exact;
    if (precision == Precision::Float)
        return exact ? Kernels{kFill_filter_float.of(traits), kFill_full_float.of(traits)}
                     : Kernels{kFill_baseline_float.of(traits), nullptr};
    return exact ? Kernels{kFill_filter_double.of(traits), kFill_full_double.of(traits)}
                 : Kernels{kFill_baseline_double.of(traits), nullptr};
}

}  // namespace dsphere::host
