#version 450
// The window's triangles: positions in pixels.

layout(location = 0) in vec2 position;
layout(location = 1) in vec2 uv;
layout(location = 2) in vec4 colour;
layout(push_constant) uniform Params {
    vec2 scale, shift;  // from pixels to clip space
    vec2 greatest_uv;   // of the part of the texture that is in use
};
layout(location = 0) out vec2 fragment_uv;
layout(location = 1) out vec4 fragment_colour;

void main() {
    fragment_uv = uv;
    fragment_colour = colour;
    gl_Position = vec4(position * scale + shift, 0.0, 1.0);
}
