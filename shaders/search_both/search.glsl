// The exact marcher in single floats, and in full precision where those are in doubt. Expects displaced.glsl and naive.glsl.

const bool kSingleFloats = false;  // whether a first ray is a float's bits
const bool kIsRetry = false;  // whether pixels and rays come from the list that the filter left
const bool kMarches = true;  // whether bounds tell where rays go
const int kPathTasks = 1;  // pixels that an invocation follows paths of

ObjectHit hitDisplaced(const ObjectData object, const MapData map, const Ray ray) {
    ObjectHit hit = hitDisplacedFiltered(object, map, ray);
    if (hit.doubtful) hit = hitDisplacedFully(object, map, ray);
    return hit;
}

bool displacedBlocks(const ObjectData object, const MapData map, const Ray ray, INOUT(Searches) searches) {
    return displacedBlocksFiltered(object, map, ray, searches);
}
