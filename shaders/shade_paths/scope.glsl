// Scenes of all materials, lights and shapes.

const bool kPaths = true;
const int kTasks = kPathTasks;  // pixels that an invocation has

#include "mesh.glsl"
