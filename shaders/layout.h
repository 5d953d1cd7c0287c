// What the host writes and the shaders read, once for both: structs, bindings, group size, film planes.
// Structs hold only 4-byte scalars and 16-byte aligned vec4s and are multiples of 16 bytes long, so that std140, std430
// and C++ agree; the host asserts it. (RetryHead, of a storage buffer alone, has an array.)
// Object space is scaled so that the surface's greatest radius is 1 ("units of R").
#ifndef DSPHERE_LAYOUT_H
#define DSPHERE_LAYOUT_H

#ifdef __cplusplus
#include <cstdint>
#include <glm/vec4.hpp>
namespace dsphere::layout {
using vec4 = glm::vec4;
using uint = std::uint32_t;
#endif

#define GROUP_SIZE_X 8  // the SIMD axis of lavapipe: a multiple of 8
#define GROUP_SIZE_Y 8
#define PROBE_GROUP_SIZE 64

#define BINDING_OBJECTS 0  // uniform buffers: lavapipe reads storage buffers lane by lane (rule L4)
// MAX_OBJECTS a level of detail, one an object in the same order: a looked-up index would not count as uniform.
#define BINDING_MAPS 1
#define BINDING_LIGHTS 2
#define BINDING_MATERIALS 3
#define BINDING_TRIANGLES 4
#define BINDING_RAMPS 5
#define BINDING_TABLES 6   // floats: what shade_paths looks up (PathTables of the host)
#define BINDING_HEIGHTS 7  // r32f array: stored map values, pole rows included
#define BINDING_BOUNDS 8   // r32f array: squared radii, the cube-map pyramids
// rgba32f: sine and cosine of each cell's west (north) edge, then what their rounding left; the same of the centres of
// images' texels (disk: their distances).
#define BINDING_EDGES 9
#define BINDING_IMAGES 10        // r32ui array: the colour images' texels
#define BINDING_SPLINE_NODES 11  // rgba32f array: a spline's value, slopes east and south, and twist at the nodes
#define BINDING_TILES 12         // r32ui array: the heights of maps in tiles, and where their tiles lie
#define BINDING_FILM 13          // r32ui array: one layer a plane (probe.comp: the rays)
#define BINDING_HITS 14          // probe.comp: the answers
#define BINDING_RETRY 14         // render.comp, query.comp: the pixels or rays that search_filter leaves to search_full
#define BINDING_ABSENT 15        // render.comp, query.comp: those that wait for a tile
#define BINDING_ANSWERS 16       // query.comp: a QueryHit per ray
#define BINDING_LOOKS 17         // query.comp: a QueryLook per ray, if PLANE_R or PLANE_U is asked for

// scene_planet knows what SPEC_OBJECT_COUNT, SPEC_KINDS and SPEC_ONLY_ would tell.
#define SPEC_MARCHER 0
#define SPEC_OBJECT_COUNT 1
#define SPEC_LIGHT_COUNT 2
#define SPEC_KINDS 3      // bit per KIND_ that the scene holds
#define SPEC_PLANES 4     // bit per PLANE_ that the film holds
#define SPEC_IMAGES 5     // bit per KIND_ of the objects with a colour image
#define SPEC_THRESHOLD 6  // float; naive, lipschitz: a hit where |p| - r falls under it, units of R
#define SPEC_STRIDE 7     // float; lipschitz: the share of |p| - r that no step exceeds
#define SPEC_DETAIL 8     // float; exact: pixels that a level of detail may be off, 0: none is used
#define SPEC_SURFACES 9   // bit per SURFACE_ that the scene holds; read by patch_curved alone
// Of the next nine, shade_lambert reads SPEC_LIGHT_KINDS alone.
#define SPEC_MATERIALS 10      // bit per MATERIAL_ that the scene holds
#define SPEC_LIGHT_KINDS 11    // bit per LIGHT_ that the scene holds
#define SPEC_CHECKERBOARDS 12  // bit per KIND_ of the objects that have one
#define SPEC_MAX_DEPTH 13      // reflections that are followed
#define SPEC_DIFFUSE_PATHS 14  // 1: every material reflects (path); 0: mirrors alone do (directlighting)
#define SPEC_CLAMP 15          // float; the most that a channel of a sample may hold, 0: no limit
#define SPEC_FILTER 16         // FILTER_ of the pixel filter
#define SPEC_RADIUS_X 17       // float, of the pixel filter
#define SPEC_RADIUS_Y 18
#define SPEC_SHADOWS 19         // 0: no shadow rays; light ends at the horizons of mean spheres (horizonShare)
#define SPEC_REGULARIZE 20      // 1: later facets are rougher
#define SPEC_RETRY_STRIDE 21    // invocations from one retried pixel to the next, whose rays differ (rule N1)
#define SPEC_ONLY_DISPLACED 22  // the scene's only displaced sphere, by its index; -1: it has none or several
#define SPEC_ONLY_PLAIN 23      // the same of all other objects
#define SPEC_TURNS 24           // pixels that an invocation takes, one after the other; shade_paths alone
#define SPEC_HIDE_DISTANCE 25   // 1: camera rays that miss see no infinite light; shade_paths alone
#define SPEC_TILES 26           // 0: the scene has no map in tiles; 1: it has; 2: and their tiles have a TILE_MARGIN
#define SPEC_RAMPS 27           // 1 if an object is coloured by a ramp
#define SPEC_INFINITE_LIGHT 28  // the infinite light, by its index; -1: the scene has none; shade_paths alone
#define SPEC_ROUGH_MATTES 29    // 1 if a matte surface is not Lambertian; shade_paths alone
#define SPEC_COUNT 30

#define MARCHER_EXACT 0
#define MARCHER_NAIVE 1        // the seed's: from the camera
#define MARCHER_NAIVE_SHELL 2  // the same, started at the shell
#define MARCHER_LIPSCHITZ 3    // sphere tracing with a proven bound of the slope

#define KIND_DISPLACED 0
#define KIND_SPHERE 1
#define KIND_DISK 2
#define KIND_MESH 3  // shade_paths alone
#define KIND_COUNT 4

#define MATERIAL_MATTE 0
#define MATERIAL_CONDUCTOR 1
#define MATERIAL_MIRROR 2
#define MATERIAL_PLASTIC 3
#define MATERIAL_COUNT 4

// shade_lambert knows the first two alone.
#define LIGHT_DISTANT 0
#define LIGHT_POINT 1
#define LIGHT_INFINITE 2
#define LIGHT_IMAGE 3  // infinite, with an image
#define LIGHT_SPHERE 4
#define LIGHT_DISK 5
#define LIGHT_COUNT 6

// What a displaced sphere's heights are between the nodes. patch_bilinear knows the first
// alone.
#define SURFACE_BILINEAR 0
#define SURFACE_SPLINE 1
#define SURFACE_RIPPLES 2
#define SURFACE_SMOOTH_NORMALS 3  // not a surface: a bilinear one whose shading normals are the spline's

// How the samples of a map in tiles are stored. 16-bit ones lie two to a word, the lower half first.
#define SAMPLES_UINT16 0
#define SAMPLES_INT16 1
#define SAMPLES_FLOAT 2
#define EDGE_COLUMNS 8192  // of the edges image in a scene with a map in tiles
#define EDGE_ROWS 4
#define NO_TILE 0xffffffffu  // in the table: the tile is not on the device
#define TILE_MARGIN 1        // nodes beyond each edge of a tile, which a spline in its outermost cells depends on

#define IMAGE_NONE 0
#define IMAGE_CODES 1   // a word a texel: 8-bit sRGB codes, R lowest. The image's first row holds their light, as float
#define IMAGE_FLOATS 2  // planes of R, G and B, float, one below the other

// Film planes in the order of their layers; a film holds only those of its mask. R, G, B and A are accumulated over
// samples, all others belong to the ray through the pixel's centre. OBJECT_ planes are for verify: in units of R, float
// as computed, before any transform to world.
#define PLANE_R 0
#define PLANE_G 1
#define PLANE_B 2
#define PLANE_A 3  // the share of samples that hit something
#define PLANE_T 4
#define PLANE_PX 5
#define PLANE_PY 6
#define PLANE_PZ 7
#define PLANE_NX 8
#define PLANE_NY 9
#define PLANE_NZ 10
#define PLANE_NSX 11
#define PLANE_NSY 12
#define PLANE_NSZ 13
#define PLANE_U 14
#define PLANE_V 15
#define PLANE_ALBEDO_R 16
#define PLANE_ALBEDO_G 17
#define PLANE_ALBEDO_B 18
#define PLANE_ID 19
#define PLANE_LIT 20
#define PLANE_STEPS 21
#define PLANE_RESIDUAL 22
#define PLANE_OBJECT_PX 23
#define PLANE_OBJECT_PY 24
#define PLANE_OBJECT_PZ 25
#define PLANE_START_X 26  // P', the origin of shadow rays
#define PLANE_START_Y 27
#define PLANE_START_Z 28
#define PLANE_FLAGS 29  // bit 0: inside, bit 1: the step limit ended the march (never, if all is well)
#define PLANE_COUNT 30

// Loops of one invocation share 65,535 back-edges on lavapipe (rule L7), all rays of its pixels together, and end
// silently there; its whole SIMD group shares them, and pays the sum where its lanes are not long at once. A march
// takes some 25 on average; the longest, across a pole of a map 46,080 wide, passes 23,040 cells of 4 fetches each.
// With a shadow ray that is as long this is what back-edges allow. The picture of a search that ends here is not exact:
// it is counted, RetryHead::given_up.
#define MAX_STEPS 96000
#define MAX_MARCHES 640  // shapes times (lights + 1)
// An invocation whose searches took more takes no further pixel. A back-edge through a cell is 4 steps.
#define NEXT_PIXEL_STEPS 12000
// Back-edges of an invocation's loops outside of marches: through objects, triangles, vertices.
#define TURN_LOOPS 16384

#define MAX_OBJECTS 64
#define MAX_LIGHTS 32
#define MAX_DEPTH 64
#define FILTER_INTERVALS 256  // of a pixel filter's tables, where the tables begin: places x and y, weights x and y
#define FILTER_BOX 0          // no tables: all places of a rectangle, evenly
#define FILTER_POSITIVE 1     // places by the tables, each sample counts once
#define FILTER_SIGNED 2       // and as the weights say
#define LOSS_INTERVALS 128    // of a conductor's loss over the root of the cosine; one value more at either end
#define MAX_TRIANGLES 512     // of all meshes together
#define MAX_LEVELS 6          // of detail; level 0 is the map (with more, all maps would not fit into 64 KiB)
#define RAMP_POINTS 17        // control points of a colour ramp, at equal distances

struct ObjectData {
    // Camera ray of raster position (x, y), object space in units of R: it passes through the point P = point_0 + X
    // point_x + Y point_y and has the direction d' = direction_0 + X direction_x + Y direction_y, X = x - anchor_x, Y =
    // y - anchor_y. It starts at P - direction_0.w d'. Each value is the sum of its row and the _lo row after it.
    vec4 point_0, point_0_lo, point_x, point_x_lo, point_y, point_y_lo;
    vec4 direction_0, direction_0_lo, direction_x, direction_x_lo, direction_y, direction_y_lo;
    vec4 to_object_x, to_object_y, to_object_z;  // rows, world -> object in units of R
    vec4 to_world_x, to_world_y, to_world_z;     // rows, object in units of R -> world
    vec4 from_start, start_x, start_y;           // world: the object's centre seen from the ray's start at X = Y = 0,
                                                 // and that start's steps
    vec4 from_first;                       // world: the object's centre seen from object 0's; w: radius of a sphere
                                           // about it that holds a displaced sphere; others': negative
    vec4 albedo;                           // rgb; of a constant texture
    float anchor_x, anchor_y;              // raster
    float base, base_lo, scale;            // r = base + base_lo + scale * stored value, units of R
    float ramp_offset, ramp_scale;         // h = ramp_offset + ramp_scale * stored value
    float shell_squared;                   // of a sphere around everything, rounded outward
    float inner_squared;                   // disk: the squared inner radius
    float offset;                          // e: start of secondary rays above the hit, units of R
    int kind, ramp;                        // KIND_; index of the ramp, -1: none
    vec4 image_north, image_south;         // rgb: a displaced sphere's poles, unscaled
    int image, image_width, image_height;  // IMAGE_
    int image_y, image_layer;              // where texel row 0 lies in the images
    int image_centres_y;                   // row of `edges` for the texel columns' centres; the next: the rows'
    float image_shift;                     // turns from a longitude of 0 back to the image's left edge
    float pixel_size, pixel_growth;  // a pixel spans size + growth * distance from the ray's start at least, units of R
    int first_triangle, triangle_count;  // KIND_MESH
    float mean_radius;                   // of a displaced sphere, units of R; others': negative
    vec4 texture_scale;                  // rgb: factor of the ramp's or the image's colour
};

struct LightData {
    vec4 position;  // w = 0: unit direction towards the light; w = 1: world, seen from object 0's centre
    vec4 radiance;  // rgb: irradiance (distant), intensity (point), radiance (others)
    // shade_paths alone reads the rest. LIGHT_DISK: world vectors as long as its radius along its own x and y, and its
    // unit normal. LIGHT_IMAGE: the rows of world -> light.
    vec4 x_axis, y_axis, z_axis;
    int kind, object;     // LIGHT_; the object that shines, -1: none
    float share, shares;  // its chance to be drawn at a path's later vertices, and those of all before it and it
    float inner_squared;  // LIGHT_DISK: the squared share of the inner radius
    float measure;        // LIGHT_SPHERE: its radius; LIGHT_DISK: its area
    int two_sided;
    // LIGHT_IMAGE: size, place in the images, and in the tables: the rows' distribution, height + 1 values; each row's
    // own, width + 1 values; the texels' densities over the unit square.
    int width, height, image_y, image_layer, image;
    int table, pad0, pad1, pad2;
};

// shade_paths alone. Object k's is the one at k; MAX_OBJECTS + k is its regularized() one, if SPEC_REGULARIZE asks for
// it.
struct MaterialData {
    vec4 odd;          // checkerboard: rgb where the sum of the cells is odd; ObjectData::albedo is the other colour
    vec4 specular;     // mirror: rgb reflectance; plastic: rgb factor of the facets
    vec4 eta, k;       // conductor
    vec4 bounced;      // conductor: rgb F_ms / (pi (1 - E_mean)), see docs/light.md
    int kind;          // MATERIAL_
    int checkerboard;  // 1: there is one
    float u_scale, v_scale;
    float alpha;             // GGX
    float rough_a, rough_b;  // matte: Oren and Nayar's A and B
    int table;               // conductor: of its loss 1 - E in the tables
    int light;               // the light that the object is; -1: none
    int pad0, pad1, pad2;
};

// A triangle, units of R of its object. Corners that triangles share have the same bits.
struct TriangleData {
    vec4 a, b, c;  // corners; w: their texture coordinate u
    vec4 v;        // xyz: those corners' v
};

struct MapData {
    int width, rows;                                      // cells: columns (wrapping) and rows from pole to pole
    int heights_x, heights_y, layer;                      // where node (0, 0) lies in the heights image
    int bounds_y, bounds_layer, bounds_side, start_side;  // start_side: of the level where camera rays start
    int edges_y;                           // row of the longitude edges; the colatitude edges lie in the next
    int caps;                              // 1: the first and last rows are half as high (texel registration)
    float columns_per_turn, first_column;  // column of longitude phi = phi / 2pi * columns_per_turn - first_column
    float cells_per_radian_u, cells_per_radian_v;
    float cap_shift;  // node row of colatitude theta = theta * cells_per_radian_v + cap_shift
    // Of a cell's angular size; versin = 1 - cos; _cap: of the height of the rows that touch a pole.
    float tan_width, tan_height, sin_width, versin_width, sin_height, versin_height, sin_cap, versin_cap;
    float least_pixel;  // length of a pixel, units of R, from which this level of detail serves, for an error of one
                        // pixel
    // patch_curved alone reads these: SURFACE_; rows of each polar cap; where node row 0 lies in the nodes image;
    // whether shading normals are those of the nodes; ripples: radians of the sines a column and a row.
    int surface, cap_rows, nodes_y, nodes_layer, smooth_normals;
    float phase_u, phase_v;
    // A map in tiles has no heights image. A tile holds the nodes of 2^tile_shift x 2^tile_shift cells, those on its
    // far edges included. Row `table_y` + r, column c of layer 0 of the tiles image tells where tile (c, r) lies, in
    // tiles: c in 8 bits, r in 8, layer in 16; or NO_TILE. Tiles begin below row `tiles_y` of every layer.
    int tile_shift;                    // 0: the map is not in tiles
    int table_y, tiles_y, first_tile;  // first_tile: the number of tile (0, 0) among those of all maps
    int tile_words, samples;           // of a tile's row, as it lies in the image; SAMPLES_
    float north_pole, south_pole;      // stored values
};

struct RenderParams {
    int tile_x, tile_y;    // of the tile's first pixel, in film pixels
    int tile_x1, tile_y1;  // its end
    int film_x, film_y;    // raster position of the film's first pixel
    int sample_index;      // -1: the pixel's centre
    uint seed;
};

// The head of the list of pixels that follows it. Its first three numbers are those of an indirect dispatch, in rows of
// RETRY_ROW workgroups: no device must take more than 65,535 in a row (rule N2).
#define RETRY_ROW 1024
struct RetryHead {
    uint groups[3], count;
    uint given_up;  // pixels of whose searches one was ended by MAX_STEPS, in this list's pass
};

// A pixel of the list: x and y in 16 bits each, and SurfacePoint::safe_s of its camera ray. query.comp: a ray's index.
struct RetryPixel {
    uint pixel;
    float safe_s;
};

// The head of the list of pixels (query.comp: rays) that met a tile which is not on the device; the list follows, and
// after `capacity` entries that of those that are to be done again, `listed` of them: search_filter does these where
// there are any.
struct AbsentHead {
    uint count, capacity, listed, pad0;
};

// x and y in 16 bits each, or a ray's index; the tile's number.
struct AbsentPixel {
    uint pixel, tile;
};

// A ray in the object space of object 0, units of R: a point and a direction of any length, each a row and its _lo row.
// point.w: the ray starts this many directions before the point; direction.w: its length from there, in units of R.
// flags: 1 for a secondary ray.
struct ProbeRay {
    vec4 point, point_lo, direction, direction_lo;
    uint flags, pad0, pad1, pad2;
};

struct ProbeHit {
    vec4 position;  // object space; .w: its distance along the ray from the query's point
    vec4 normal;    // unit; .w: residual
    uint flags;     // bit 0: hit, 1: inside, 2: exhausted
    uint steps, pad0, pad1;
};

struct QueryParams {
    uint count;  // of the rays
    uint first;  // index of the first of them among all rays that were ever asked about: it chooses sample numbers
    uint seed, pad0;
};

// A ray of query.comp in the object space of one object, units of R: its point nearest the centre and its unit
// direction, each a row and its _lo row. It begins and ends at these distances from that point; both are finite.
struct QueryRay {
    vec4 point;         // .w: begin
    vec4 point_lo;      // .w: end
    vec4 direction;     // .w: 1 for a secondary ray, else 0
    vec4 direction_lo;  // .w: of object 0: the ray's number counted from QueryParams::first
};

// Its answer. flags: bit 0: hit, 1: inside, 2: the step limit ended the march; the rest: 1 + the object's index.
struct QueryHit {
    float px, py, pz;  // that object's space, units of R
    uint flags;
    float nx, ny, nz;  // world, unit, if PLANE_NX is asked for
    uint lit;          // if PLANE_LIT is
};

struct QueryLook {
    float red, green, blue;  // direct light
    float u, v;              // the shape's own
    float pad0, pad1, pad2;
};

#ifdef __cplusplus
static_assert(sizeof(QueryParams) == 16);
static_assert(sizeof(QueryRay) == 64);
static_assert(sizeof(QueryHit) == 32);
static_assert(sizeof(QueryLook) == 32);
static_assert(sizeof(ProbeRay) == 80);
static_assert(sizeof(ProbeHit) == 48);
static_assert(sizeof(ObjectData) == 26 * 16 + 24 * 4);
static_assert(sizeof(LightData) == 5 * 16 + 16 * 4);
static_assert(sizeof(MaterialData) == 5 * 16 + 12 * 4);
static_assert(sizeof(TriangleData) == 64);
static_assert(sizeof(MapData) == 40 * 4);
static_assert(sizeof(MapData) * MAX_OBJECTS * MAX_LEVELS <= 65536);
static_assert(sizeof(AbsentHead) == 16);
static_assert(sizeof(AbsentPixel) == 8);
static_assert(sizeof(RenderParams) == 32);
static_assert(sizeof(RetryHead) == 20);
static_assert(sizeof(RetryPixel) == 8);
}  // namespace dsphere::layout
#endif
#endif
