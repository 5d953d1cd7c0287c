#version 450
// A list of rays, or of those to retry: their nearest hits, and the lights seen from there.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require

#include "resources.glsl"
#include "retrylist.glsl"
#include "absentlist.glsl"

layout(push_constant) uniform Params { QueryParams pushed; };
QueryParams params;

const bool kWantsColour = (kPlanes & 7u << PLANE_R) != 0u;
const bool kWantsNormal = (kPlanes & 1u << PLANE_NX) != 0u;
const bool kWantsPlace = (kPlanes & 1u << PLANE_U) != 0u;
const bool kWantsLight = (kPlanes & (7u << PLANE_R | 1u << PLANE_LIT)) != 0u;

#include "uniforms.glsl"
#include "sample.glsl"
#include "shade.glsl"
#include "lighting.glsl"
#include "retry.glsl"

layout(local_size_x = GROUP_SIZE_X * GROUP_SIZE_Y) in;
layout(std430, binding = BINDING_ANSWERS) writeonly buffer Answers { QueryHit answers[]; };
layout(std430, binding = BINDING_LOOKS) writeonly buffer Looks { QueryLook looks[]; };

// Lavapipe writes lane by lane, so only what is asked for.
void put(const uint index, const SurfacePoint point, const uint lit) {
    uint flags = point.hit ? 1u | uint(point.object + 1) << 3 : 0u;
    flags |= (point.inside ? 2u : 0u) | (point.exhausted ? 4u : 0u);
    answers[index].px = point.object_position.x;
    answers[index].py = point.object_position.y;
    answers[index].pz = point.object_position.z;
    answers[index].flags = flags;
    if (kWantsNormal) {
        answers[index].nx = point.normal.x;
        answers[index].ny = point.normal.y;
        answers[index].nz = point.normal.z;
    }
    if (kWantsLight) answers[index].lit = lit;
}

void putLook(const uint index, const SurfacePoint point, const vec3 colour) {
    vec2 uv = kWantsPlace && point.hit ? pointUv(point, kKinds) : vec2(0.0);
    QueryLook look;
    look.red = colour.x;
    look.green = colour.y;
    look.blue = colour.z;
    look.u = uv.x;
    look.v = uv.y;
    look.pad0 = 0.0;
    look.pad1 = 0.0;
    look.pad2 = 0.0;
    looks[index] = look;
}

// An invocation's ray of the list, if it `exists`; nothing is met up to `safe_s`.
struct Place {
    uint index;
    float safe_s;
    bool exists;
};

Place findPlace() {
    Place place;
    if (kIsRetry) {
        RetryPixel found = findRetry(place.exists);
        place.index = found.pixel;
        place.safe_s = found.safe_s;
        return place;
    }
    place.index = gl_GlobalInvocationID.x;
    place.exists = place.index < params.count;
    place.safe_s = -kInfinity;
    if (kTiles != 0) {
        bool in_list;
        uint index = findListed(in_list);
        bool listed = takesListed();
        place.index = listed ? index : place.index;
        place.exists = listed ? in_list : place.exists;
    }
    return place;
}

void main() {
    readUniforms();
    Place place = findPlace();
    if (!place.exists) return;
    uint index = place.index;
    Segment segment = listedSegment(index, place.safe_s);
    uint number = uint(listedRay(segment, 0).direction_lo.w);  // in the caller's order
    Gathered result = gatherListed(segment, pixelKey(int(params.first + number), 0, params.seed));
    if (missesTile()) {
        leaveForTile(index);
        return;
    }
    if (result.searches.doubtful) {
        leaveForRetry(index, result.point.safe_s);
        return;
    }
    put(index, result.point, result.lit);
    if (kWantsColour || kWantsPlace) putLook(index, result.point, result.colour);
}
