// One shader variant at one precision. The build compiles this file once for each, with HOST_REAL, the names of the
// functions that it defines (HOST_FILL, and HOST_PROBE where it has one), and the folders of the shader variant to look
// for its includes in.

#include "host/kernel.h"

#include <glm/glm.hpp>
#include <glm/gtc/integer.hpp>

#include <bit>
#include <span>

// The dialect of shaders/resources.glsl.
#define INOUT(T) T&
#define OUT(T) T&
#define XY(v) vec2(v)
#define XYZ(v) vec3(v)
#define ROUND_AS_FILMED(v) v = vec3(glm::tvec3<float>(v))
#define precise

namespace dsphere::host {

namespace {

using namespace glm;
using namespace dsphere::layout;
using real = HOST_REAL;
using vec2 = glm::tvec2<real>;
using vec3 = glm::tvec3<real>;
using vec4 = glm::tvec4<real>;

float asFloat(std::uint32_t bits) {
    return std::bit_cast<float>(bits);
}

uint floatBitsToUint(const real x) {
    return std::bit_cast<std::uint32_t>(float(x));
}

real uintBitsToFloat(const uint bits) {
    return real(std::bit_cast<float>(bits));
}

// Scaled by the greatest component first, as Mesa's drivers have it: then normals are theirs bit for bit.
template <glm::length_t N>
glm::vec<N, real> normalize(const glm::vec<N, real>& v) {
    const glm::vec<N, real> size = abs(v);
    real greatest = size[0];
    for (glm::length_t i = 1; i < N; ++i) greatest = max(greatest, size[i]);
    if (greatest == real(0)) return v;
    const glm::vec<N, real> scaled = v / greatest;
    return scaled * inversesqrt(dot(scaled, scaled));
}

// Images of one kind of texel each.
struct Heights {
    const HostScene& scene;
};
struct BoundsImage {
    const HostScene& scene;
};
struct Edges {
    const HostScene& scene;
};
struct Images {
    const HostScene& scene;
};
struct Nodes {
    const HostScene& scene;
};
struct Tiles {};  // none: the scene reads any map's heights

vec4 imageLoad(const Heights& image, const ivec3& at) {
    return vec4(real(image.scene.height(at.x, at.y, at.z)));
}

vec4 imageLoad(const BoundsImage& image, const ivec3& at) {
    return vec4(real(image.scene.bound(at.x, at.y, at.z)));
}

vec4 imageLoad(const Edges& image, const ivec3& at) {
    return vec4(image.scene.edge(at.x, at.y));
}

uvec4 imageLoad(const Images& image, const ivec3& at) {
    return uvec4(image.scene.imageWord(at.x, at.y, at.z));
}

[[maybe_unused]] vec4 imageLoad(const Nodes& image, const ivec3& at) {
    const std::array<float, 4> node = image.scene.node(at.x, at.y, at.z);
    return vec4(node[0], node[1], node[2], node[3]);
}

uvec4 imageLoad(const Tiles&, const ivec3&) {
    return uvec4(0u);
}

uvec4 imageLoad(HostFilm& film, const ivec3& at) {
    return uvec4(film.at(at.x, at.y, at.z));
}

void imageStore(HostFilm& film, const ivec3& at, const uvec4& texel) {
    film.at(at.x, at.y, at.z) = texel.x;
}

[[maybe_unused]] uint atomicAdd(uint& counter, uint by) {
    const uint before = counter;
    counter += by;
    return before;
}

/// An invocation: the kernel's functions and globals are its members, specialization constants and bindings too.
struct Invocation {
    Invocation(const HostScene& scene, const Specialization& specialization, const RenderParams& tile,
               HostFilm& film_of, std::vector<RetryPixel>& list)
        : spec(specialization),
          heights{scene},
          bounds{scene},
          edges{scene},
          images{scene},
          nodes{scene},
          objects(scene.objects),
          maps(scene.maps),
          lights(scene.lights),
          materials(scene.materials),
          triangles(scene.packed().triangles),
          tables(scene.packed().tables.values),
          ramp_points(scene.packed().ramp_points),
          film(film_of),
          retry_pixels(list),
          pushed(tile) {}

    const Specialization& spec;
    const int kMarcher = int(spec[SPEC_MARCHER]), kLightCount = int(spec[SPEC_LIGHT_COUNT]);
    const int kObjectCount = int(spec[SPEC_OBJECT_COUNT]), kKinds = int(spec[SPEC_KINDS]);
    const bool kOneObject = kObjectCount == 1;
    const int kOnlyDisplaced = int(spec[SPEC_ONLY_DISPLACED]), kOnlyPlain = int(spec[SPEC_ONLY_PLAIN]);
    const uint kPlanes = spec[SPEC_PLANES], kRetryStride = spec[SPEC_RETRY_STRIDE];
    const int kImages = int(spec[SPEC_IMAGES]), kRamps = int(spec[SPEC_RAMPS]),
              kLightKinds = int(spec[SPEC_LIGHT_KINDS]), kInfiniteLight = int(spec[SPEC_INFINITE_LIGHT]);
    const int kSurfaces = int(spec[SPEC_SURFACES]), kMaterials = int(spec[SPEC_MATERIALS]);
    const int kTurns = int(spec[SPEC_TURNS]), kCheckerboards = int(spec[SPEC_CHECKERBOARDS]),
              kRoughMattes = int(spec[SPEC_ROUGH_MATTES]);
    const int kMaxDepth = int(spec[SPEC_MAX_DEPTH]), kDiffusePaths = int(spec[SPEC_DIFFUSE_PATHS]);
    const int kRegularize = int(spec[SPEC_REGULARIZE]), kFilter = int(spec[SPEC_FILTER]);
    const int kShadows = int(spec[SPEC_SHADOWS]), kHideDistance = int(spec[SPEC_HIDE_DISTANCE]);
    const real kClamp = real(asFloat(spec[SPEC_CLAMP]));
    const real kRadiusX = real(asFloat(spec[SPEC_RADIUS_X])), kRadiusY = real(asFloat(spec[SPEC_RADIUS_Y]));
    const real kThreshold = real(asFloat(spec[SPEC_THRESHOLD])), kStride = real(asFloat(spec[SPEC_STRIDE]));
    const real kDetail = real(asFloat(spec[SPEC_DETAIL]));
    static constexpr int kTiles = 0;

    const Heights heights;
    const BoundsImage bounds;
    const Edges edges;
    const Images images;
    const Nodes nodes;
    const Tiles tiles = {};
    const std::span<const ObjectData> objects;
    const std::span<const MapData> maps;
    const std::span<const LightData> lights;
    const std::span<const MaterialData> materials;
    const std::span<const TriangleData> triangles;
    const std::span<const float> tables;
    const std::span<const layout::vec4> ramp_points;
    HostFilm& film;
    RetryHead retry = {{0, 1, 1}, 0, 0};
    std::vector<RetryPixel>& retry_pixels;
    AbsentHead absent = {};  // always empty, as no tile is ever absent
    std::vector<AbsentPixel> absent_pixels;
    const RenderParams& pushed;
    RenderParams params;
    uvec3 gl_WorkGroupID = uvec3(0u), gl_LocalInvocationID = uvec3(0u), gl_NumWorkGroups = uvec3(1u);
    uint gl_LocalInvocationIndex = 0;

#include "shaders/marcher.glsl"

#include "shaders/kernel.glsl"
#ifdef HOST_PROBE
#include "shaders/probe.glsl"
#endif

    void runGroup(const uint x, const uint y) {
        gl_WorkGroupID = uvec3(x, y, 0u);
        for (gl_LocalInvocationIndex = 0; gl_LocalInvocationIndex < GROUP_SIZE_X * GROUP_SIZE_Y;
             ++gl_LocalInvocationIndex) {
            gl_LocalInvocationID =
                uvec3(gl_LocalInvocationIndex % GROUP_SIZE_X, gl_LocalInvocationIndex / GROUP_SIZE_X, 0u);
            main();
        }
    }
};

uint groupsOf(uint items, uint size) {
    return (items + size - 1) / size;
}

}  // namespace

std::uint32_t HOST_FILL(const HostScene& scene, const Specialization& specialization, const RenderParams& tile,
                        HostFilm& film, std::vector<RetryPixel>& list) {
    Invocation invocation(scene, specialization, tile, film, list);
    if (invocation.kIsRetry) {
        invocation.retry.count = uint(list.size());
        for (uint group = 0; group < groupsOf(uint(list.size()), GROUP_SIZE_X * GROUP_SIZE_Y); ++group)
            invocation.runGroup(group % RETRY_ROW, group / RETRY_ROW);
        return invocation.retry.given_up;
    }
    const uint width = uint(tile.tile_x1 - tile.tile_x), height = uint(tile.tile_y1 - tile.tile_y);
    list.resize(std::size_t(width) * height);
    for (uint y = 0; y < groupsOf(height, GROUP_SIZE_Y); ++y)
        for (uint x = 0; x < groupsOf(width, GROUP_SIZE_X); ++x) invocation.runGroup(x, y);
    list.resize(invocation.retry.count);
    return invocation.retry.given_up;
}

#ifdef HOST_PROBE
void HOST_PROBE(const HostScene& scene, const Specialization& specialization, std::span<const ProbeRay> rays,
                std::span<ProbeHit> hits) {
    const RenderParams no_tile = {};
    HostFilm no_film;
    std::vector<RetryPixel> no_list;
    Invocation invocation(scene, specialization, no_tile, no_film, no_list);
    for (std::size_t i = 0; i < rays.size(); ++i)
        hits[i] = invocation.probeObject(scene.objects[0], scene.maps[0], rays[i]);
}
#endif

}  // namespace dsphere::host
