// The constants and bindings of the device, and the dialect that makes the kernel's other files C++ as well: the host
// compiles them with declarations of its own in place of these (src/host). What a variant does not use of them, the
// optimizer takes out.
// A variant of a shader is a choice of folders that its includes are looked for in: patch_bilinear or patch_curved,
// search_filter, search_full, search_both or search_baseline, scene_planet or scene_general, shade_lambert or shade_paths,
// rays_camera or rays_listed (src/render/CMakeLists.txt). Variants, not constants: drivers would inline all before they
// drop any (rule N3). A variant's constants, such as kPaths, stand alone in a condition: glslang makes a specialization
// constant of one that is joined with another by && or ||, which nothing compiles away.
// Parameters are const (rule L8): glslang copies others into variables, and drivers then take twice as long to translate a
// shader.
#define real float
#define INOUT(T) inout T
#define OUT(T) out T
#define XY(v) (v).xy                       // in C++ a vector of reals, whatever `v` is made of
#define XYZ(v) (v).xyz
#define ROUND_AS_FILMED(v)             // in C++ reals may hold more than the film's floats: what is lit is what it holds

#include "layout.h"

layout(constant_id = SPEC_MARCHER) const int kMarcher = MARCHER_EXACT;
layout(constant_id = SPEC_LIGHT_COUNT) const int kLightCount = 0;
#include "objectcount.glsl"
layout(constant_id = SPEC_PLANES) const uint kPlanes = 0u;
layout(constant_id = SPEC_IMAGES) const int kImages = 0;
layout(constant_id = SPEC_RAMPS) const int kRamps = 0;
layout(constant_id = SPEC_LIGHT_KINDS) const int kLightKinds = 1;
layout(constant_id = SPEC_INFINITE_LIGHT) const int kInfiniteLight = -1;
layout(constant_id = SPEC_SURFACES) const int kSurfaces = 1;
layout(constant_id = SPEC_TURNS) const int kTurns = 1;
layout(constant_id = SPEC_MATERIALS) const int kMaterials = 1;
layout(constant_id = SPEC_ROUGH_MATTES) const int kRoughMattes = 0;
layout(constant_id = SPEC_CHECKERBOARDS) const int kCheckerboards = 0;
layout(constant_id = SPEC_MAX_DEPTH) const int kMaxDepth = 5;
layout(constant_id = SPEC_DIFFUSE_PATHS) const int kDiffusePaths = 0;
layout(constant_id = SPEC_CLAMP) const float kClamp = 0.0;
layout(constant_id = SPEC_REGULARIZE) const int kRegularize = 0;
layout(constant_id = SPEC_HIDE_DISTANCE) const int kHideDistance = 0;
layout(constant_id = SPEC_FILTER) const int kFilter = FILTER_BOX;
layout(constant_id = SPEC_RADIUS_X) const float kRadiusX = 0.5;
layout(constant_id = SPEC_RADIUS_Y) const float kRadiusY = 0.5;
layout(constant_id = SPEC_SHADOWS) const int kShadows = 1;
layout(constant_id = SPEC_RETRY_STRIDE) const uint kRetryStride = 1u;
layout(constant_id = SPEC_THRESHOLD) const float kThreshold = 3e-6;
layout(constant_id = SPEC_STRIDE) const float kStride = 1.0;
layout(constant_id = SPEC_DETAIL) const float kDetail = 0.0;
layout(constant_id = SPEC_TILES) const int kTiles = 0;

layout(std140, binding = BINDING_OBJECTS) uniform Objects { ObjectData objects[MAX_OBJECTS]; };
layout(std140, binding = BINDING_MAPS) uniform Maps { MapData maps[MAX_OBJECTS * MAX_LEVELS]; };
layout(std140, binding = BINDING_LIGHTS) uniform Lights { LightData lights[MAX_LIGHTS]; };
layout(std140, binding = BINDING_MATERIALS) uniform Materials { MaterialData materials[2 * MAX_OBJECTS]; };
layout(std140, binding = BINDING_TRIANGLES) uniform Triangles { TriangleData triangles[MAX_TRIANGLES]; };
layout(std430, binding = BINDING_TABLES) readonly buffer Tables { float tables[]; };
layout(std430, binding = BINDING_RAMPS) readonly buffer Ramps { vec4 ramp_points[]; };
layout(binding = BINDING_HEIGHTS, r32f) readonly uniform image2DArray heights;
layout(binding = BINDING_BOUNDS, r32f) readonly uniform image2DArray bounds;
layout(binding = BINDING_EDGES, rgba32f) readonly uniform image2DArray edges;
layout(binding = BINDING_IMAGES, r32ui) readonly uniform uimage2DArray images;
layout(binding = BINDING_TILES, r32ui) readonly uniform uimage2DArray tiles;

layout(binding = BINDING_SPLINE_NODES, rgba32f) readonly uniform image2DArray nodes;

#include "marcher.glsl"
