// The marchers that the exact one is compared with. Expects displaced.glsl and naive.glsl.

const bool kSingleFloats = true;  // whether a first ray is a float's bits
const bool kIsRetry = false;  // whether pixels and rays come from the list that the filter left
const bool kMarches = false;  // whether bounds tell where rays go
const int kPathTasks = kTurns;  // pixels that an invocation follows paths of

ObjectHit hitDisplaced(const ObjectData object, const MapData map, const Ray ray) {
    ObjectHit hit = hitBaseline(object, map, ray);
    hit.shading_n = hit.n;
    return hit;
}

bool displacedBlocks(const ObjectData object, const MapData map, const Ray ray, INOUT(Searches) searches) {
    return hitBaseline(object, map, ray).hit;
}
