#version 450
// The kernel on the device.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require

#include "resources.glsl"
#include "retrylist.glsl"
#include "absentlist.glsl"

layout(push_constant) uniform Params { RenderParams pushed; };
RenderParams params;
layout(local_size_x = GROUP_SIZE_X, local_size_y = GROUP_SIZE_Y) in;
layout(binding = BINDING_FILM, r32ui) uniform uimage2DArray film;

#include "kernel.glsl"
