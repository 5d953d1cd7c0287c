#version 450
// target[i] = source[count - 1 - i] * kFactor + addend: every invocation reads what another group wrote before.
layout(local_size_x = 8) in;
layout(constant_id = 0) const uint kFactor = 1u;
layout(set = 0, binding = 0) readonly buffer Source { uint source[]; };
layout(set = 0, binding = 1) writeonly buffer Target { uint target[]; };
layout(push_constant) uniform Push { uint count; uint addend; };

void main() {
    uint i = gl_GlobalInvocationID.x;
    if (i < count) target[i] = source[count - 1u - i] * kFactor + addend;
}
