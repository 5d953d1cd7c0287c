// The exact marcher in full precision, for what the filter left in doubt. Expects displaced.glsl and naive.glsl.

const bool kSingleFloats = false;  // whether a first ray is a float's bits
const bool kIsRetry = true;  // whether pixels and rays come from the list that the filter left
const bool kMarches = true;  // whether bounds tell where rays go
const int kPathTasks = 1;  // pixels that an invocation follows paths of

ObjectHit hitDisplaced(const ObjectData object, const MapData map, const Ray ray) {
    return hitDisplacedFully(object, map, ray);
}

bool displacedBlocks(const ObjectData object, const MapData map, const Ray ray, INOUT(Searches) searches) {
    return displacedBlocksFully(object, map, ray);
}
