#version 450
// One pixel of one tile: its ray, the nearest hit, the film's planes.
#extension GL_GOOGLE_include_directive : require

#include "resources.glsl"
#include "sample.glsl"
#include "shade.glsl"

layout(local_size_x = GROUP_SIZE_X, local_size_y = GROUP_SIZE_Y) in;
layout(binding = BINDING_FILM, r32ui) uniform uimage2DArray film;
layout(push_constant) uniform Params { RenderParams params; };

const uint kColourPlanes = 7u << PLANE_R;

bool wants(int plane) {
    return (kPlanes & (1u << plane)) != 0u;
}

// Layers hold the planes of the mask in order. Images keep bits as they are, so floats travel as bits.
void put(ivec2 pixel, int plane, uint bits) {
    if (wants(plane)) imageStore(film, ivec3(pixel, bitCount(kPlanes & ((1u << plane) - 1u))), uvec4(bits));
}

void put(ivec2 pixel, int plane, float value) {
    put(pixel, plane, floatBitsToUint(value));
}

void put(ivec2 pixel, int plane, vec3 value) {
    put(pixel, plane, value.x);
    put(pixel, plane + 1, value.y);
    put(pixel, plane + 2, value.z);
}

vec3 storedColour(ivec2 pixel) {
    return vec3(uintBitsToFloat(imageLoad(film, ivec3(pixel, 0)).x), uintBitsToFloat(imageLoad(film, ivec3(pixel, 1)).x),
                uintBitsToFloat(imageLoad(film, ivec3(pixel, 2)).x));
}

void putGeometry(ivec2 pixel, SurfacePoint point) {
    vec3 nothing = vec3(0.0);
    vec3 p = point.hit ? point.object_position : nothing;
    put(pixel, PLANE_T, point.hit ? point.t : uintBitsToFloat(0x7f800000u));
    put(pixel, PLANE_PX, point.hit ? point.position : nothing);
    put(pixel, PLANE_NX, point.hit ? point.normal : nothing);
    put(pixel, PLANE_NSX, point.hit ? point.normal : nothing);
    if (wants(PLANE_U) || wants(PLANE_V)) {
        vec2 uv = point.hit ? surfaceUv(objects[point.object], p) : vec2(0.0);
        put(pixel, PLANE_U, uv.x);
        put(pixel, PLANE_V, uv.y);
    }
    put(pixel, PLANE_ID, uint(point.object + 1));
    put(pixel, PLANE_STEPS, uint(point.steps));
    put(pixel, PLANE_RESIDUAL, point.hit ? point.residual : 0.0);
    put(pixel, PLANE_OBJECT_PX, p);
    put(pixel, PLANE_START_X, point.hit ? point.start : nothing);
    put(pixel, PLANE_FLAGS, (point.inside ? 1u : 0u) | (point.exhausted ? 2u : 0u));
}

void main() {
    ivec2 pixel = ivec2(params.tile_x, params.tile_y) + ivec2(gl_GlobalInvocationID.xy);
    if (pixel.x >= params.tile_x1 || pixel.y >= params.tile_y1) return;
    ivec2 raster = pixel + ivec2(params.film_x, params.film_y);
    bool centre = params.sample_index < 0;
    vec2 jitter = centre ? vec2(0.0) : samplePosition(raster.x, raster.y, params.sample_index, params.seed);
    SurfacePoint point = nearestHit(vec2(raster), jitter);
    putGeometry(pixel, point);
    if ((kPlanes & (kColourPlanes | (7u << PLANE_ALBEDO_R) | (1u << PLANE_LIT))) == 0u) return;

    vec3 albedo = vec3(0.0);
    vec3 colour = vec3(0.0);
    uint lit = 0u;
    if (point.hit) {
        albedo = albedoOf(point);
        lit = visibleLights(point);
        colour = directLight(point, albedo, lit);
    }
    put(pixel, PLANE_ALBEDO_R, albedo);
    put(pixel, PLANE_LIT, lit);
    if ((kPlanes & kColourPlanes) != 0u)
        put(pixel, PLANE_R, params.sample_index > 0 ? storedColour(pixel) + colour : colour);
}
