#version 450
// A film's planes as the colours that a window shows: sRGB codes, four bytes a pixel, for display on any device.
#extension GL_GOOGLE_include_directive : require

#include "displaylayout.h"

layout(local_size_x = DISPLAY_GROUP, local_size_y = DISPLAY_GROUP) in;
layout(binding = 0, r32ui) readonly uniform uimage2DArray film;
layout(std430, binding = 1) writeonly buffer Colours { uint colours[]; };
layout(push_constant) uniform Params { DisplayParams params; };
// A SHOW_. No parameter: lavapipe would set that into a copy of the shader, and compile it, at every dispatch.
layout(constant_id = 0) const int kShow = SHOW_COLOUR;

const vec3 kBackground = vec3(0.07, 0.07, 0.08);  // behind values, so that black can be one

float plane(ivec2 pixel, uint layer) {
    return uintBitsToFloat(imageLoad(film, ivec3(pixel, layer)).x);
}

vec3 planes(ivec2 pixel, uint layer) {
    return vec3(plane(pixel, layer), plane(pixel, layer + 1u), plane(pixel, layer + 2u));
}

// IEC 61966-2-1; NaN is black.
vec3 srgb(vec3 light) {
    vec3 l = vec3(light.x > 0.0 ? light.x : 0.0, light.y > 0.0 ? light.y : 0.0, light.z > 0.0 ? light.z : 0.0);
    vec3 low = 12.92 * l, high = 1.055 * pow(l, vec3(1.0 / 2.4)) - 0.055;
    return clamp(mix(high, low, lessThanEqual(l, vec3(0.0031308))), 0.0, 1.0);
}

// Dark blue, blue, green, yellow, red.
vec3 heat(float x) {
    float h = clamp(x, 0.0, 1.0);
    return clamp(vec3(1.5) - abs(4.0 * h - vec3(3.0, 2.0, 1.0)), 0.0, 1.0);
}

float share(float value) {
    return (value - params.low) / max(params.high - params.low, 1e-30);
}

vec3 colourOf(ivec2 pixel) {
    uint layer = params.layer;
    if (kShow == SHOW_COLOUR) return srgb(planes(pixel, layer) * params.gain);
    if (imageLoad(film, ivec3(pixel, params.id_layer)).x == 0u) return kBackground;
    if (kShow == SHOW_ALBEDO) return srgb(planes(pixel, layer));
    if (kShow == SHOW_NORMAL) return 0.5 + 0.5 * planes(pixel, layer);
    if (kShow == SHOW_UV) return vec3(plane(pixel, layer), plane(pixel, layer + 1u), 0.25);
    if (kShow == SHOW_DISTANCE) return vec3(1.0 - 0.9 * clamp(share(plane(pixel, layer)), 0.0, 1.0));
    if (kShow == SHOW_RESIDUAL) return heat(share(log2(max(plane(pixel, layer), 1e-30))));
    return heat(share(float(imageLoad(film, ivec3(pixel, layer)).x)));
}

void main() {
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (pixel.x >= params.width || pixel.y >= params.height) return;
    colours[pixel.y * params.width + pixel.x] = packUnorm4x8(vec4(colourOf(pixel), 1.0));
}
