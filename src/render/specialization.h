#pragma once

#include "render/method.h"
#include "render/pack.h"
#include "render/traits.h"

#include <array>
#include <cstdint>

namespace dsphere {

/// The values of the SPEC_ constants, floats as their bits.
using Specialization = std::array<std::uint32_t, SPEC_COUNT>;

/// The share of |p| - r that no step of the Lipschitz marcher may exceed; 1 for the others. Error (InvalidInput) for a
/// scene that it cannot march.
float safeStride(const PackedScene& packed, const MarchMethod& method);

/// What a kernel is specialised to that marches such a scene and fills the planes of a mask. `stride`: safeStride().
/// One pixel an invocation, and no gaps between retried ones.
Specialization specializationOf(const SceneTraits& traits, float stride, const MarchMethod& method,
                                std::uint32_t planes);

}  // namespace dsphere
