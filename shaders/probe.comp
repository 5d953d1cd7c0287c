#version 450
// A list of rays against object 0: what verify and the tests ask about rays that no camera makes.
#extension GL_GOOGLE_include_directive : require

#include "resources.glsl"
#include "probe.glsl"

layout(local_size_x = PROBE_GROUP_SIZE) in;
layout(std430, binding = BINDING_FILM) readonly buffer Rays { ProbeRay rays[]; };
layout(std430, binding = BINDING_HITS) writeonly buffer Hits { ProbeHit hits[]; };

void main() {
    ObjectData object = objects[0];  // before all else, see uniforms.glsl
    MapData map = maps[0];
    uint index = gl_GlobalInvocationID.x;
    if (index >= uint(rays.length())) return;
    hits[index] = probeObject(object, map, rays[index]);
}
