#version 450
// A list of rays against object 0: what verify and the tests ask about rays that no camera makes.
#extension GL_GOOGLE_include_directive : require

#include "resources.glsl"

layout(local_size_x = PROBE_GROUP_SIZE) in;
layout(std430, binding = BINDING_FILM) readonly buffer Rays { ProbeRay rays[]; };
layout(std430, binding = BINDING_HITS) writeonly buffer Hits { ProbeHit hits[]; };

void main() {
    uint index = gl_GlobalInvocationID.x;
    if (index >= uint(rays.length())) return;
    ProbeRay query = rays[index];
    Ray ray = momentRay(query.direction.xyz, query.moment.xyz, query.direction.w);
    ray.s_max = query.moment.w;
    ray.may_start_inside = query.flags == 0u;
    ObjectHit hit = hitObject(objects[0], maps[0], ray);
    ProbeHit answer;
    answer.position = vec4(hit.p, hit.hit ? dot(hit.p, ray.d) : 0.0);
    answer.normal = vec4(hit.n, hit.residual);
    answer.flags = (hit.hit ? 1u : 0u) | (hit.inside ? 2u : 0u) | (hit.exhausted ? 4u : 0u);
    answer.steps = uint(hit.steps);
    answer.pad0 = 0u;
    answer.pad1 = 0u;
    hits[index] = answer;
}
