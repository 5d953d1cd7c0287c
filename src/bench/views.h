#pragma once

#include "base/math.h"
#include "scene/scene.h"

#include <span>
#include <string>

namespace dsphere::bench {

/// A camera's place by a planet about the origin.
struct StandardView {
    const char* name;   ///< "whole planet"
    const char* word;   ///< of --views: "whole"
    dvec3 eye, target;  ///< in units of the greatest radius
    double fov;         ///< degrees over the shorter axis
};

/// Whole planet, limb close-up, low horizon: of 1280x720 they fill some 27, 49 and 50 %.
std::span<const StandardView> standardViews();

/// The view's camera, +y up, for a planet of that greatest radius.
Camera cameraOf(const StandardView& view, double greatest_radius);

/// Where the light of the measurements comes from; not normalised.
inline const dvec3 kSun{1.5, 1.8, 1.9};

}  // namespace dsphere::bench
