// Included once for each GLSL_REAL: see cpp_shaders.h.

#define INOUT(T) T&
#define precise

// Each test file has its own copy of the functions, and need not call them all; in a variant some parameters have no use.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-parameter"

namespace dsphere::test::GLSL_NAMESPACE {
namespace {

using namespace glm;
using namespace dsphere::layout;
using real = GLSL_REAL;
using vec2 = glm::tvec2<real>;
using vec3 = glm::tvec3<real>;
using vec4 = glm::tvec4<real>;

inline vec4 cornersAt(const MapData& map, const ivec2& cell) {
    const float *north = current_resources->nodes->row(cell.y), *south = current_resources->nodes->row(cell.y + 1);
    const int next = cell.x + 1 == map.width ? 0 : cell.x + 1;
    return vec4(north[cell.x], north[next], south[cell.x], south[next]);
}
inline bool missesTile() {
    return false;
}
inline void giveUp() {}
inline int faceRow(const MapData&, int axis, real sign_of_face) {
    return axis * 2 + (sign_of_face < real(0) ? 1 : 0);
}
inline real boundAt(const MapData& map, int face, int side, int i, int j) {
    return real(current_resources->bounds->at(face, std::countr_zero(unsigned(map.bounds_side / side)), i, j));
}
inline vec2 horizonAt(const MapData&, int face, int i, int j) {
    const Bounds& bounds = *current_resources->bounds;
    return vec2(bounds.squared[bounds.horizonIndex(face, i, j)], bounds.squared[bounds.horizonLeastIndex(face, i, j)]);
}
inline vec4 edgesAt(int x, int y) {
    return vec4(current_resources->edges[y][std::size_t(x)]);
}
#ifdef WITH_CURVED
inline vec4 nodeAt(const MapData&, int column, int row) {
    const SplineNodes::Node& node = current_resources->spline_nodes[std::size_t(row)][std::size_t(column)];
    return vec4(node[0], node[1], node[2], node[3]);
}

// No map is in tiles here.
constexpr int kTiles = 0;
struct Controls {
    vec4 above, north, south, below;
};
inline Controls controlsAt(const MapData&, const ivec2&) {
    return {};
}
#endif
inline vec3 imageTexel(const ObjectData&, int column, int row) {
    return vec3(current_resources->image->texel(column, row));
}

inline real leadingBits(real x) {
    return real(std::bit_cast<float>(std::bit_cast<std::uint32_t>(float(x)) & 0xfffff000u));
}

// Of all surfaces.
[[maybe_unused]] constexpr int kSurfaces = 1 << SURFACE_BILINEAR | 1 << SURFACE_SPLINE | 1 << SURFACE_RIPPLES;

#include "shaders/kinds.glsl"
#include "shaders/numeric.glsl"
#include "shaders/surface.glsl"
#include "patch.glsl"
#include "shaders/ray.glsl"
#include "shaders/frame.glsl"
#include "shaders/walk.glsl"
#include "shaders/march.glsl"
#include "shaders/filter.glsl"

// All kinds of object, the exact marcher: what the device gets by specialisation.
constexpr int kMarcher = MARCHER_EXACT;
constexpr real kThreshold = real(3e-6), kStride = real(1);
constexpr int kKinds = 1 << KIND_DISPLACED | 1 << KIND_SPHERE | 1 << KIND_DISK;
constexpr int kImages = kKinds;
constexpr int kOnlyDisplaced = -1, kOnlyPlain = -1;

#include "shaders/hit.glsl"
#include "shaders/naive.glsl"
#include "shaders/displaced.glsl"
#include "search.glsl"
#include "scope.glsl"
#include "shaders/objects.glsl"
#include "shaders/colour.glsl"
#include "shaders/sample.glsl"

}  // namespace
}  // namespace dsphere::test::GLSL_NAMESPACE

#pragma GCC diagnostic pop

#undef INOUT
#undef precise
