// Included once for each GLSL_REAL: see cpp_shaders.h.

#define INOUT(T) T&
#define precise

// Each test file has its own copy of the functions, and need not call them all.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"

namespace dsphere::test::GLSL_NAMESPACE {
namespace {

using namespace glm;
using namespace dsphere::layout;
using real = GLSL_REAL;
using vec2 = glm::tvec2<real>;
using vec3 = glm::tvec3<real>;
using vec4 = glm::tvec4<real>;

inline real heightAt(const MapData&, int column, int row) {
    return real(current_resources->nodes->row(row)[column]);
}
inline int faceRow(const MapData&, int axis, real sign_of_face) {
    return axis * 2 + (sign_of_face < real(0) ? 1 : 0);
}
inline real boundAt(const MapData& map, int face, int side, int i, int j) {
    return real(current_resources->bounds->at(face, std::countr_zero(unsigned(map.bounds_side / side)), i, j));
}
inline vec4 edgesAt(int x, int y) {
    const Resources& resources = *current_resources;
    const std::vector<glm::vec4>* rows[] = {&resources.longitude_edges, &resources.colatitude_edges,
                                            &resources.column_centres, &resources.row_centres};
    return vec4((*rows[y])[std::size_t(x)]);
}
inline vec3 imageTexel(const ObjectData&, int column, int row) {
    return vec3(current_resources->image->texel(column, row));
}

inline real leadingBits(real x) {
    return real(std::bit_cast<float>(std::bit_cast<std::uint32_t>(float(x)) & 0xfffff000u));
}

#include "shaders/numeric.glsl"
#include "shaders/surface.glsl"
#include "shaders/ray.glsl"
#include "shaders/frame.glsl"
#include "shaders/walk.glsl"
#include "shaders/march.glsl"
#include "shaders/filter.glsl"

// All kinds of object, the exact marcher: what the device gets by specialisation.
constexpr int kMarcher = MARCHER_EXACT;
constexpr real kThreshold = real(3e-6), kStride = real(1);
constexpr int kKinds = 1 << KIND_DISPLACED | 1 << KIND_SPHERE | 1 << KIND_DISK;

#include "shaders/hit.glsl"
#include "shaders/naive.glsl"
#include "shaders/objects.glsl"
#include "shaders/colour.glsl"
#include "shaders/sample.glsl"

}  // namespace
}  // namespace dsphere::test::GLSL_NAMESPACE

#pragma GCC diagnostic pop

#undef INOUT
#undef precise
