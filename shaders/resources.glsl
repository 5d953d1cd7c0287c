// What the shaders read on the device, behind the names that the pure functions expect.
// The marcher's and the shading's parameters are const: glslang copies others into variables, and drivers then take
// twice as long to translate a shader.
#define real float
#define INOUT(T) inout T

#include "layout.h"

layout(constant_id = SPEC_MARCHER) const int kMarcher = MARCHER_EXACT;
layout(constant_id = SPEC_LIGHT_COUNT) const int kLightCount = 0;
#ifdef ONE_PLANET  // the scene is a displaced sphere alone
const int kObjectCount = 1;
const int kOnlyDisplaced = 0;
const int kOnlyPlain = -1;
const int kKinds = 1 << KIND_DISPLACED;
#else
layout(constant_id = SPEC_OBJECT_COUNT) const int kObjectCount = 1;
layout(constant_id = SPEC_ONLY_DISPLACED) const int kOnlyDisplaced = -1;
layout(constant_id = SPEC_ONLY_PLAIN) const int kOnlyPlain = -1;
layout(constant_id = SPEC_KINDS) const int kKinds = 1;
#endif
layout(constant_id = SPEC_PLANES) const uint kPlanes = 0u;
layout(constant_id = SPEC_IMAGES) const int kImages = 0;
layout(constant_id = SPEC_LIGHT_KINDS) const int kLightKinds = 1;
#ifdef WITH_CURVED
layout(constant_id = SPEC_SURFACES) const int kSurfaces = 1;
#endif
#ifdef WITH_PATHS
layout(constant_id = SPEC_TURNS) const int kTurns = 1;
layout(constant_id = SPEC_MATERIALS) const int kMaterials = 1;
layout(constant_id = SPEC_CHECKERBOARDS) const int kCheckerboards = 0;
layout(constant_id = SPEC_MAX_DEPTH) const int kMaxDepth = 5;
layout(constant_id = SPEC_DIFFUSE_PATHS) const int kDiffusePaths = 0;
layout(constant_id = SPEC_CLAMP) const float kClamp = 0.0;
layout(constant_id = SPEC_REGULARIZE) const int kRegularize = 0;
layout(constant_id = SPEC_HIDE_DISTANCE) const int kHideDistance = 0;
layout(constant_id = SPEC_FILTER) const int kFilter = FILTER_BOX;
layout(constant_id = SPEC_RADIUS_X) const float kRadiusX = 0.5;
layout(constant_id = SPEC_RADIUS_Y) const float kRadiusY = 0.5;
#endif
layout(constant_id = SPEC_SHADOWS) const int kShadows = 1;
layout(constant_id = SPEC_RETRY_STRIDE) const uint kRetryStride = 1u;
layout(constant_id = SPEC_THRESHOLD) const float kThreshold = 3e-6;
layout(constant_id = SPEC_STRIDE) const float kStride = 1.0;
layout(constant_id = SPEC_DETAIL) const float kDetail = 0.0;

layout(std140, binding = BINDING_OBJECTS) uniform Objects { ObjectData objects[MAX_OBJECTS]; };
layout(std140, binding = BINDING_MAPS) uniform Maps { MapData maps[MAX_OBJECTS * MAX_LEVELS]; };
layout(std140, binding = BINDING_LIGHTS) uniform Lights { LightData lights[MAX_LIGHTS]; };
#ifdef WITH_PATHS
layout(std140, binding = BINDING_MATERIALS) uniform Materials { MaterialData materials[2 * MAX_OBJECTS]; };
layout(std140, binding = BINDING_TRIANGLES) uniform Triangles { TriangleData triangles[MAX_TRIANGLES]; };
layout(std430, binding = BINDING_TABLES) readonly buffer Tables { float tables[]; };
#endif
layout(std430, binding = BINDING_RAMPS) readonly buffer Ramps { vec4 ramp_points[]; };
layout(binding = BINDING_HEIGHTS, r32f) readonly uniform image2DArray heights;
layout(binding = BINDING_BOUNDS, r32f) readonly uniform image2DArray bounds;
layout(binding = BINDING_EDGES, rgba32f) readonly uniform image2DArray edges;
layout(binding = BINDING_IMAGES, r32ui) readonly uniform uimage2DArray images;

#ifdef WITH_CURVED
layout(binding = BINDING_NODES, rgba32f) readonly uniform image2DArray nodes;
#endif

bool sceneHasLight(const int kind) {
    return (kLightKinds & (1 << kind)) != 0;
}

bool isLight(const LightData light, const int kind) {
    return kLightKinds == 1 << kind || (sceneHasLight(kind) && light.kind == kind);
}

// Storage images, not textures: filtering may snap weights to 8 bits, and on lavapipe a load costs half a texelFetch.
float heightAt(const MapData map, const int column, const int row) {
    // Only levels of detail do not start at the image's left edge.
    int x = kDetail > 0.0 ? map.heights_x + column : column;
    return imageLoad(heights, ivec3(x, map.heights_y + row, map.layer)).x;
}

#ifdef WITH_CURVED
vec4 nodeAt(const MapData map, const int column, const int row) {
    return imageLoad(nodes, ivec3(column, map.nodes_y + row, map.nodes_layer));
}
#endif

// Levels above the finest lie side by side below it, each face in 1.5 side rows.
int faceRow(const MapData map, const int axis, const float sign_of_face) {
    int face = axis * 2 + (sign_of_face < 0.0 ? 1 : 0);
    return map.bounds_y + face * (map.bounds_side + (map.bounds_side >> 1));
}

float boundAt(const MapData map, const int face_row, const int side, const int i, const int j) {
    bool finest = side == map.bounds_side;
    int x = i + (finest ? 0 : map.bounds_side - 2 * side);
    int y = face_row + j + (finest ? 0 : map.bounds_side);
    return imageLoad(bounds, ivec3(x, y, map.bounds_layer)).x;
}

vec4 edgesAt(const int x, const int y) {
    return imageLoad(edges, ivec3(x, y, 0));
}

uint imageWord(const int x, const int y, const int layer) {
    return imageLoad(images, ivec3(x, y, layer)).x;
}

float imageFloat(const int x, const int y, const int layer) {
    return uintBitsToFloat(imageWord(x, y, layer));
}

// The light of a texel at (x, y) of a layer: the only place that knows how images of `height` rows lie on the device.
vec3 placedTexel(const int image, const int x, const int y, const int layer, const int height) {
    if (image == IMAGE_CODES) {
        uint codes = imageWord(x, y, layer);
        return vec3(imageFloat(int(codes & 255u), 0, 0), imageFloat(int(codes >> 8 & 255u), 0, 0),
                    imageFloat(int(codes >> 16), 0, 0));
    }
    return vec3(imageFloat(x, y, layer), imageFloat(x, y + height, layer), imageFloat(x, y + 2 * height, layer));
}

vec3 imageTexel(const ObjectData o, const int column, const int row) {
    return placedTexel(o.image, column, o.image_y + row, o.image_layer, o.image_height);
}

// The leading 12 bits of x; a product of two such values is exact.
float leadingBits(const float x) {
    return uintBitsToFloat(floatBitsToUint(x) & 0xfffff000u);
}

#include "numeric.glsl"
#include "surface.glsl"
#ifdef WITH_CURVED
#include "curved.glsl"
#endif
#include "ray.glsl"
#include "frame.glsl"
#include "walk.glsl"
#include "march.glsl"
#include "filter.glsl"
#ifdef WITH_CURVED
#include "curvedstroll.glsl"
#endif
#include "hit.glsl"
#include "naive.glsl"
#include "objects.glsl"
#include "colour.glsl"
