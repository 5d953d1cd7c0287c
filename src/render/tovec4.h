#pragma once

#include "base/math.h"
#include "shaders/layout.h"

namespace dsphere {

/// (v, w) as the shaders read it.
inline layout::vec4 toVec4(const dvec3& v, double w) {
    return layout::vec4(glm::vec3(v), float(w));
}

}  // namespace dsphere
