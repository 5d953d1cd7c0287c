#pragma once

// The marcher's functions compiled as C++, once with real = float and once with real = double. A failure is then
// told apart: reference against glsl64 (the algorithm), glsl64 against glsl32 (precision), glsl32 against the device.
// A program that defines WITH_CURVED has those of patch_curved, others those of patch_bilinear.

#include "shaders/layout.h"

#include "surface/bounds.h"
#include "surface/colourmap.h"
#include "surface/nodes.h"
#include "surface/spline.h"

#include <glm/glm.hpp>

#include <bit>
#include <cstdint>
#include <vector>

namespace dsphere::test {

/// What the shaders fetch from images on the device. Lookups read the one that the calling thread has made current.
struct Resources {
    const NodeGrid* nodes = nullptr;
    const Bounds* bounds = nullptr;
    std::vector<std::vector<SplineNodes::Node>> spline_nodes;  ///< rows from pole to pole, if there is a spline
    const ColourMap* image = nullptr;
    /// Sines and cosines: of the grid's longitude and colatitude edges, then of the centres of the image's texel
    /// columns and rows, or of the ripples' phases at the edges.
    std::vector<glm::vec4> edges[4];
};

extern thread_local const Resources* current_resources;

}  // namespace dsphere::test

#define GLSL_NAMESPACE glsl32
#define GLSL_REAL float
#include "tests/shaders/cpp_shaders.inl"
#undef GLSL_NAMESPACE
#undef GLSL_REAL

#define GLSL_NAMESPACE glsl64
#define GLSL_REAL double
#include "tests/shaders/cpp_shaders.inl"
#undef GLSL_NAMESPACE
#undef GLSL_REAL
