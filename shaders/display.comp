#version 450
// A film's planes as the colours that a window shows: sRGB codes, four bytes a pixel, for display on any device.
#extension GL_GOOGLE_include_directive : require

#include "displaylayout.h"

layout(local_size_x = DISPLAY_GROUP, local_size_y = DISPLAY_GROUP) in;
layout(binding = 0, r32ui) readonly uniform uimage2DArray film;
layout(std430, binding = 1) writeonly buffer Colours { uint colours[]; };
layout(std430, binding = 2) readonly buffer World { DisplayObject objects[DISPLAY_OBJECTS]; };
layout(push_constant) uniform Params { DisplayParams pushed; };
DisplayParams params;
// A SHOW_. No parameter, which lavapipe would set into a copy of the shader and compile at every dispatch (rule L2).
layout(constant_id = 0) const int kShow = SHOW_COLOUR;

const vec3 kBackground = vec3(0.07, 0.07, 0.08);  // behind values, so that black can be one
const vec3 kLineColour = vec3(1.0, 0.82, 0.35);
const float kDegrees = 57.29577951;

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

float gainAt(ivec2 pixel) {
    bool before = pixel.y < params.ahead_y0 || (pixel.y < params.ahead_y1 && pixel.x < params.ahead_x);
    bool ahead = pixel.x < params.ahead_x0 || (pixel.x < params.ahead_x1 && before);
    return ahead ? params.gain_ahead : params.gain;
}

float share(float value) {
    return (value - params.low) / max(params.high - params.low, 1e-30);
}

// The number of the shape that a pixel shows, from 1 on; 0: none.
uint shapeAt(ivec2 pixel) {
    return imageLoad(film, ivec3(pixel, params.id_layer)).x;
}

vec3 inObject(DisplayObject object, vec3 place) {
    vec3 p = place - object.centre.xyz;
    return vec3(dot(object.to_object_x.xyz, p), dot(object.to_object_y.xyz, p), dot(object.to_object_z.xyz, p));
}

float heightAt(DisplayObject object, vec3 place) {
    return (length(inObject(object, place)) - object.to_object_x.w) * object.to_object_y.w + object.to_object_z.w;
}

// Which interval between lines a pixel lies in: of heights, or of longitude and latitude.
ivec2 intervalAt(ivec2 pixel, uint shape) {
    DisplayObject object = objects[shape - 1u];
    vec3 place = planes(pixel, params.place_layer);
    if (kShow == SHOW_HEIGHTS) return ivec2(floor(heightAt(object, place) / params.spacing), 0);
    vec3 d = normalize(inObject(object, place));
    return ivec2(floor(kDegrees * vec2(atan(d.x, d.z), asin(clamp(d.y, -1.0, 1.0))) / params.spacing));
}

// Lines run between pixels whose intervals differ.
bool isOnLine(ivec2 pixel, uint shape) {
    ivec2 own = intervalAt(pixel, shape);
    for (int k = 0; k < 2; ++k) {
        ivec2 next = min(pixel + ivec2(1 - k, k), ivec2(params.width, params.height) - 1);
        if (shapeAt(next) == shape && intervalAt(next, shape) != own) return true;
    }
    return false;
}

vec3 heightColour(ivec2 pixel, uint shape) {
    DisplayObject object = objects[shape - 1u];
    if (object.centre.w == 0.0) return vec3(0.3);
    vec3 place = planes(pixel, params.place_layer);
    float steepness = max(dot(planes(pixel, params.layer), normalize(place - object.centre.xyz)), 0.0);
    vec3 colour = mix(heat(share(heightAt(object, place))), vec3(1.0), 0.25) * mix(0.35, 1.0, steepness * steepness);
    return isOnLine(pixel, shape) ? 0.25 * colour : colour;
}

float slopeAt(ivec2 pixel, uint shape) {
    vec3 outward = normalize(planes(pixel, params.place_layer) - objects[shape - 1u].centre.xyz);
    return kDegrees * acos(clamp(dot(planes(pixel, params.layer), outward), -1.0, 1.0));
}

vec3 graticuleColour(ivec2 pixel, uint shape) {
    vec3 colour = srgb(planes(pixel, params.layer) * gainAt(pixel));
    return isOnLine(pixel, shape) ? mix(colour, kLineColour, 0.65) : colour;
}

vec3 colourOf(ivec2 pixel) {
    uint layer = params.layer;
    if (kShow == SHOW_COLOUR) return srgb(planes(pixel, layer) * gainAt(pixel));
    uint shape = shapeAt(pixel);
    if (shape == 0u) return kBackground;
    if (kShow == SHOW_HEIGHTS) return heightColour(pixel, shape);
    if (kShow == SHOW_SLOPE) return heat(share(slopeAt(pixel, shape)));
    if (kShow == SHOW_GRATICULE) return graticuleColour(pixel, shape);
    if (kShow == SHOW_ALBEDO) return srgb(planes(pixel, layer));
    if (kShow == SHOW_NORMAL) return 0.5 + 0.5 * planes(pixel, layer);
    if (kShow == SHOW_UV) return vec3(plane(pixel, layer), plane(pixel, layer + 1u), 0.25);
    if (kShow == SHOW_DISTANCE) return vec3(1.0 - 0.9 * clamp(share(plane(pixel, layer)), 0.0, 1.0));
    if (kShow == SHOW_RESIDUAL) return heat(share(log2(max(plane(pixel, layer), 1e-30))));
    return heat(share(float(imageLoad(film, ivec3(pixel, layer)).x)));
}

void main() {
    params = pushed;  // rule L3
    ivec2 pixel = ivec2(gl_GlobalInvocationID.xy);
    if (pixel.x >= params.width || pixel.y >= params.height) return;
    colours[pixel.y * params.width + pixel.x] = packUnorm4x8(vec4(colourOf(pixel), 1.0));
}
