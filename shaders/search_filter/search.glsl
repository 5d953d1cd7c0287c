// The exact marcher in single floats: what rounding could change is in doubt. Expects displaced.glsl and naive.glsl.

const bool kSingleFloats = true;  // whether a first ray is a float's bits
const bool kIsRetry = false;  // whether pixels and rays come from the list that the filter left
const bool kMarches = true;  // whether bounds tell where rays go
const int kPathTasks = kTurns;  // pixels that an invocation follows paths of

ObjectHit hitDisplaced(const ObjectData object, const MapData map, const Ray ray) {
    return hitDisplacedFiltered(object, map, ray);
}

bool displacedBlocks(const ObjectData object, const MapData map, const Ray ray, INOUT(Searches) searches) {
    return displacedBlocksFiltered(object, map, ray, searches);
}
