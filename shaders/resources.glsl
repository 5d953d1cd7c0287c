// The constants and bindings of the device, and the dialect that makes the kernel's other files C++ as well: the host
// compiles them with declarations of its own in place of these (src/host).
// The marcher's and the shading's parameters are const: glslang copies others into variables, and drivers then take
// twice as long to translate a shader.
#define real float
#define INOUT(T) inout T
#define OUT(T) out T
#define FORWARD(declaration) declaration;  // in C++ all functions of the kernel know each other
#define XY(v) (v).xy                       // in C++ a vector of reals, whatever `v` is made of
#define XYZ(v) (v).xyz
#define ROUND_AS_FILMED(v)             // in C++ reals may hold more than the film's floats: what is lit is what it holds

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
layout(constant_id = SPEC_TILES) const int kTiles = 0;
layout(constant_id = SPEC_LISTED) const int kListed = 0;

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
layout(binding = BINDING_TILES, r32ui) readonly uniform uimage2DArray tiles;

#ifdef WITH_CURVED
layout(binding = BINDING_NODES, rgba32f) readonly uniform image2DArray nodes;
#endif

#include "marcher.glsl"
