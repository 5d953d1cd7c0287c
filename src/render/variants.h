#pragma once

#include "render/traits.h"

#include <cstdint>
#include <span>

namespace dsphere {

using Spirv = std::span<const std::uint32_t>;

/// One shader's variants, from the leanest on.
struct Variants {
    Spirv lean, curved, paths;

    Spirv of(const SceneTraits& traits) const {
        return traits.needsPaths() ? paths : (traits.curved() ? curved : lean);
    }
};

/// One for any scene, one for a planet alone.
struct Shaders {
    Variants any, planet;

    Spirv of(const SceneTraits& traits) const { return (traits.onePlanet() ? planet : any).of(traits); }
};

/// What the list of pixels or rays to retry starts as.
inline constexpr layout::RetryHead kEmptyRetryList = {.groups = {0, 1, 1}, .count = 0};

}  // namespace dsphere
