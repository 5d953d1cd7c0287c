#version 450
#extension GL_GOOGLE_include_directive : require
// Writes every field of every struct of layout.h, in order, as words: what the host fed must come back.
#include "layout.h"
#include "fields.h"
layout(local_size_x = 1) in;
layout(set = 0, binding = 0, std140) uniform Objects { ObjectData objects[2]; };
layout(set = 0, binding = 1, std140) uniform Maps { MapData maps[2]; };
layout(set = 0, binding = 2, std140) uniform Lights { LightData lights[2]; };
layout(set = 0, binding = 3, std140) uniform Materials { MaterialData materials[2]; };
layout(set = 0, binding = 4, std140) uniform Triangles { TriangleData triangles[2]; };
layout(set = 0, binding = 5, std430) readonly buffer Rays { ProbeRay rays[]; };
layout(set = 0, binding = 6, std430) readonly buffer Hits { ProbeHit hits[]; };
layout(set = 0, binding = 7, std430) writeonly buffer Words { uint words[]; };
layout(push_constant) uniform Push { RenderParams params; };

uint next = 0u;

void word(uint value) {
    words[next] = value;
    next += 1u;
}

void words4(vec4 value) {
    for (int k = 0; k < 4; ++k) word(floatBitsToUint(value[k]));
}

#define V(name) words4(subject.name);
#define F(name) word(floatBitsToUint(subject.name));
#define I(name) word(uint(subject.name));
#define U(name) word(subject.name);

void writeObject(ObjectData subject) { OBJECT_FIELDS(V, F, I) }
void writeMap(MapData subject) { MAP_FIELDS(F, I) }
void writeLight(LightData subject) { LIGHT_FIELDS(V, F, I) }
void writeMaterial(MaterialData subject) { MATERIAL_FIELDS(V, F, I) }
void writeTriangle(TriangleData subject) { TRIANGLE_FIELDS(V) }
void writeRay(ProbeRay subject) { PROBE_RAY_FIELDS(V, U) }
void writeHit(ProbeHit subject) { PROBE_HIT_FIELDS(V, U) }
void writeParams(RenderParams subject) { PARAMS_FIELDS(I, U) }

void main() {
    for (int k = 0; k < 2; ++k) {
        writeObject(objects[k]);
        writeMap(maps[k]);
        writeLight(lights[k]);
        writeMaterial(materials[k]);
        writeTriangle(triangles[k]);
        writeRay(rays[k]);
        writeHit(hits[k]);
    }
    writeParams(params);
}
