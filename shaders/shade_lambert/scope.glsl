// Scenes of Lambert's surfaces under distant and point lights, without meshes.

const bool kPaths = false;
const int kTasks = 1;  // pixels that an invocation has

ObjectHit hitMesh(const ObjectData object, const Ray ray) {
    return noHit();
}
