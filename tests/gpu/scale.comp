#version 450
// Multiplies every texel of every layer by a factor, in place.
layout(local_size_x = 8, local_size_y = 8) in;
layout(set = 0, binding = 0, r32f) uniform image2DArray texels;
layout(set = 0, binding = 1) uniform Parameters { float factor; };

void main() {
    ivec3 at = ivec3(gl_GlobalInvocationID);
    if (any(greaterThanEqual(at, imageSize(texels)))) return;
    imageStore(texels, at, imageLoad(texels, at) * factor);
}
