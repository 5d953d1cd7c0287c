#pragma once

// Complex indices of refraction of metals that scenes name.

#include "base/math.h"

#include <span>
#include <string_view>

namespace dsphere {

struct Metal {
    std::string_view name;  ///< the element's symbol
    dvec3 eta, k;           ///< RGB
};

std::span<const Metal> metals();

}  // namespace dsphere
