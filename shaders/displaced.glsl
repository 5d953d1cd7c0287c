// The exact marcher's hits of one displaced sphere, in single floats and in full precision. Expects march.glsl, filter.glsl
// and ObjectHit.

// What a pixel's searches came to: whether another precision must decide, and their steps.
struct Searches {
    bool doubtful;
    int steps;
};

Pair basePair(const ObjectData object) {
    return makePair(real(object.base), real(object.base_lo));
}

void takeCrossing(INOUT(ObjectHit) hit, const MapData map, const Ray ray, const Crossing crossing, const ivec2 cell) {
    hit.p = crossing.p;
    // At the very centre, where only a start inside can hit, no direction is outward.
    hit.n = dot(crossing.gradient, crossing.gradient) > real(0) ? normalize(crossing.gradient) : -ray.d;
    hit.residual = crossing.at.g;
    hit.stored = patchValue(fetchPatch(map, real(1), cell), crossing.at.fu, crossing.at.fv);
    hit.steps += 4;
}

ObjectHit hitDisplacedFiltered(const ObjectData object, const MapData map, const Ray ray) {
    ObjectHit hit = noHit();
    Filtered answer = filterMarch(ray, map, real(object.base), real(object.scale), real(object.shell_squared));
    hit.hit = answer.hit;
    hit.inside = answer.inside;
    hit.doubtful = answer.doubtful;
    hit.steps = answer.steps;
    hit.safe_s = safeUntil(answer);
    if (answer.hit) {
        Crossing crossing = filterRefine(ray, map, basePair(object), real(object.scale), answer);
        takeCrossing(hit, map, ray, crossing, answer.cell);
        hit.shading_n = smoothNormal(map, real(object.scale), crossing.at, answer.cell, crossing.p, hit.n);
    }
    return hit;
}

ObjectHit hitDisplacedFully(const ObjectData object, const MapData map, const Ray ray) {
    ObjectHit hit = noHit();
    ExactWalk walk = march(ray, map, basePair(object), real(object.scale), real(object.shell_squared));
    hit.hit = walk.hit;
    hit.inside = walk.inside;
    hit.exhausted = walk.exhausted;
    hit.steps = walk.steps;
    if (walk.hit) {
        Crossing crossing = refine(ray, map, real(object.scale), walk);
        takeCrossing(hit, map, ray, crossing, walk.frame.cell);
        hit.shading_n = smoothNormal(map, real(object.scale), crossing.at, walk.frame.cell, crossing.p, hit.n);
    }
    return hit;
}

// Whether the ray meets it: no root is refined, no normal found.
bool displacedBlocksFiltered(const ObjectData object, const MapData map, const Ray ray, INOUT(Searches) searches) {
    Filtered answer = filterMarch(ray, map, real(object.base), real(object.scale), real(object.shell_squared));
    searches.doubtful = searches.doubtful || answer.doubtful;
    searches.steps += answer.steps;
    return answer.hit;
}

bool displacedBlocksFully(const ObjectData object, const MapData map, const Ray ray) {
    return march(ray, map, basePair(object), real(object.scale), real(object.shell_squared)).hit;
}
