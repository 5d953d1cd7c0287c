#version 450
// The window's triangles: texture times colour, both sRGB codes, blended as codes.

layout(binding = 0) uniform sampler2D image;
layout(push_constant) uniform Params {
    vec2 scale, shift;
    vec2 greatest_uv;
};
layout(location = 0) in vec2 fragment_uv;
layout(location = 1) in vec4 fragment_colour;
layout(location = 0) out vec4 result;

void main() {
    result = fragment_colour * texture(image, min(fragment_uv, greatest_uv));
}
