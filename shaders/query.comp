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
const bool kWantsPlace = (kPlanes & 1u << PLANE_U) != 0u;
const bool kWantsLight = kWantsColour || (kPlanes & 1u << PLANE_LIT) != 0u;

#include "uniforms.glsl"
#include "sample.glsl"
#include "shade.glsl"
#include "lighting.glsl"
#include "retry.glsl"

layout(local_size_x = GROUP_SIZE_X * GROUP_SIZE_Y) in;
layout(std430, binding = BINDING_ANSWERS) writeonly buffer Answers { QueryHit answers[]; };
layout(std430, binding = BINDING_LOOKS) writeonly buffer Looks { QueryLook looks[]; };

void put(const uint index, const SurfacePoint point, const uint lit) {
    QueryHit answer;
    answer.px = point.object_position.x;
    answer.py = point.object_position.y;
    answer.pz = point.object_position.z;
    answer.flags = point.hit ? 1u | uint(point.object + 1) << 3 : 0u;
    answer.flags |= (point.inside ? 2u : 0u) | (point.exhausted ? 4u : 0u);
    answer.nx = point.normal.x;
    answer.ny = point.normal.y;
    answer.nz = point.normal.z;
    answer.lit = lit;
    answers[index] = answer;
}

void putLook(const uint index, const SurfacePoint point, const vec3 colour) {
    vec2 uv = kWantsPlace && point.hit ? pointUv(point) : vec2(0.0);
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

// An invocation's ray of the list, if it `exists`; nothing is met up to `clear`.
struct Place {
    uint index;
    float clear;
    bool exists;
};

Place findPlace() {
    Place place;
    if (kIsRetry) {
        RetryPixel found = findRetry(place.exists);
        place.index = found.pixel;
        place.clear = found.clear;
        return place;
    }
    place.index = gl_GlobalInvocationID.x;
    place.exists = place.index < params.count;
    place.clear = -kInfinity;
    if (kListed != 0) place.index = findListed(place.exists);
    return place;
}

void main() {
    readUniforms();
    Place place = findPlace();
    if (!place.exists) return;
    uint index = place.index;
    uint key = pixelKey(int(params.first + index), 0, params.seed);
    Gathered result = gatherListed(listedSegment(index, place.clear), key);
    if (missesTile()) {
        leaveForTile(index);
        return;
    }
    if (result.searches.doubtful) {
        leaveForRetry(index, result.point.clear);
        return;
    }
    put(index, result.point, result.lit);
    if (kWantsColour || kWantsPlace) putLook(index, result.point, result.colour);
}
