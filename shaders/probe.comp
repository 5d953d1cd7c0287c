#version 450
// A list of rays against object 0: what verify and the tests ask about rays that no camera makes.
#extension GL_GOOGLE_include_directive : require

#include "resources.glsl"

layout(local_size_x = PROBE_GROUP_SIZE) in;
layout(std430, binding = BINDING_FILM) readonly buffer Rays { ProbeRay rays[]; };
layout(std430, binding = BINDING_HITS) writeonly buffer Hits { ProbeHit hits[]; };

void main() {
    ObjectData object = objects[0];  // before all else, see uniforms.glsl
    MapData map = maps[0];
    uint index = gl_GlobalInvocationID.x;
    if (index >= uint(rays.length())) return;
    ProbeRay query = rays[index];
    Line line;
    line.x = makePair(query.point.x, query.point_lo.x);
    line.y = makePair(query.point.y, query.point_lo.y);
    line.z = makePair(query.point.z, query.point_lo.z);
    line.dx = makePair(query.direction.x, query.direction_lo.x);
    line.dy = makePair(query.direction.y, query.direction_lo.y);
    line.dz = makePair(query.direction.z, query.direction_lo.z);
    Ray ray = makeRay(line, query.point.w, query.direction.w, query.flags == 0u);
    ObjectHit hit = hitObject(object, map, ray, ~0);
    ProbeHit answer;
    answer.position = vec4(hit.p, hit.hit ? dot(hit.p, ray.d) - ray.s_point : 0.0);
    answer.normal = vec4(hit.n, hit.residual);
    answer.flags = (hit.hit ? 1u : 0u) | (hit.inside ? 2u : 0u) | (hit.exhausted ? 4u : 0u);
    answer.steps = uint(hit.steps);
    answer.pad0 = 0u;
    answer.pad1 = 0u;
    hits[index] = answer;
}
