#pragma once

#include "render/traits.h"

#include <cstdint>
#include <span>

namespace dsphere {

using Spirv = std::span<const std::uint32_t>;

/// A kernel's variants, from the leanest on: shaders, or functions of the host.
template <typename Kernel>
struct VariantsOf {
    Kernel lean, curved, paths;

    /// The leanest that knows the scene.
    Kernel of(const SceneTraits& traits) const {
        return traits.needsPaths() ? paths : (traits.curved() ? curved : lean);
    }
};

using Variants = VariantsOf<Spirv>;

/// One for any scene, one for a planet alone.
struct Shaders {
    Variants any, planet;

    Spirv of(const SceneTraits& traits) const { return (traits.onePlanet() ? planet : any).of(traits); }
};

}  // namespace dsphere
