// The baselines of every comparison. Naive is the marcher that this program replaces: steps of |p| - r along o + t d in
// float, a hit when the step falls under a threshold, a miss when it exceeds |o|, finite-difference normals. It leaves
// holes where the surface is steep and rings where the camera is far, by design. Lipschitz is what makes such steps safe:
// sphere tracing (Hart 1996) with a bound of the gradient. Expects march.glsl, ObjectHit, kMarcher, kThreshold, kStride.

const int kNaiveSteps = 4000;
const int kLipschitzSteps = 12000;  // with its shadow ray well below the back-edges of layout.h
const real kNaiveDifference = real(1e-3);

// Where a point stands over the map, from a global u and v in float.
struct NaivePlace {
    ivec2 cell;
    Patch quad;
    PatchPoint at;  // g = |p| - r
};

NaivePlace naivePlace(const ObjectData object, const MapData map, const vec3 p) {
    NaivePlace place;
    place.cell = locateCell(map, p);
    real column = atan2Precise(p.x, p.z) * (real(0.5) / kPi) * real(map.columns_per_turn) - real(map.first_column);
    real theta = atan2Precise(sqrt(p.x * p.x + p.z * p.z), p.y);
    int row = place.cell.y;
    real north = row == 0 ? real(0) : (real(row) - real(map.cap_shift)) / real(map.cells_per_radian_v);
    place.quad = fetchPatch(map, real(object.scale), place.cell);
    place.at.fu = column - floor(column);
    place.at.fv = clamp((theta - north) * cellsPerRadianV(map, row), real(0), real(1));
    place.at.g = length(p) - (real(object.base) + patchValue(place.quad, place.at.fu, place.at.fv));
    return place;
}

real naiveDistance(const ObjectData object, const MapData map, const vec3 p) {
    return naivePlace(object, map, p).at.g;
}

vec3 naiveSurface(const ObjectData object, const MapData map, const vec3 direction) {
    vec3 w = normalize(direction);
    return w * (real(1) - naiveDistance(object, map, w));
}

vec3 naiveNormal(const ObjectData object, const MapData map, const vec3 p) {
    vec3 w = normalize(p);
    vec3 east = normalize(vec3(w.z, real(0), -w.x) + vec3(real(1e-20), real(0), real(0)));
    vec3 south = cross(east, w);
    vec3 here = naiveSurface(object, map, w);
    vec3 along_east = naiveSurface(object, map, w + kNaiveDifference * east) - here;
    vec3 along_south = naiveSurface(object, map, w + kNaiveDifference * south) - here;
    vec3 n = normalize(cross(along_south, along_east));
    return dot(n, w) < real(0) ? -n : n;
}

ObjectHit hitNaive(const ObjectData object, const MapData map, const Ray ray) {
    ObjectHit hit = noHit();
    vec3 origin = ray.c + ray.s_min * ray.d;
    real give_up = length(origin) + real(1e-3);
    real t = real(0);
    if (kMarcher == MARCHER_NAIVE_SHELL) {
        real margin = real(object.shell_squared) - ray.c2;
        if (margin <= real(0)) return hit;
        t = max(-sqrt(margin) - ray.s_min, real(0));
    }
    while (hit.steps < 4 * kNaiveSteps) {
        vec3 p = origin + t * ray.d;
        real stride = naiveDistance(object, map, p);
        hit.steps += 4;
        hit.hit = stride < real(kThreshold);
        hit.p = p;
        hit.residual = stride;
        t += stride;
        if (hit.hit || !(stride <= give_up && ray.s_min + t < ray.s_max)) break;
    }
    if (hit.hit) hit.n = naiveNormal(object, map, hit.p);
    return hit;
}

// Outside the surface f = |p| - r changes by at most 1 / kStride per unit of length, so no step of kStride f passes a
// root. From shell to shell, along c + s d, whose positions stay exact at any distance of the camera.
ObjectHit hitLipschitz(const ObjectData object, const MapData map, const Ray ray) {
    ObjectHit hit = noHit();
    real margin = real(object.shell_squared) - ray.c2;
    if (margin <= real(0)) return hit;
    real s = max(-sqrt(margin), ray.s_min);
    real end = min(sqrt(margin), ray.s_max);
    bool going = s < end;
    while (s < end && hit.steps < 4 * kLipschitzSteps) {
        hit.p = ray.c + s * ray.d;
        hit.residual = naiveDistance(object, map, hit.p);
        hit.steps += 4;
        hit.hit = hit.residual < real(kThreshold);
        s += real(kStride) * hit.residual;
        going = !hit.hit && s < end;
        if (!going) break;
    }
    hit.exhausted = going;
    if (hit.hit) {
        NaivePlace place = naivePlace(object, map, hit.p);
        hit.n = normalize(patchGradient(map, place.quad, place.at, place.cell.y, hit.p));
    }
    return hit;
}

ObjectHit hitBaseline(const ObjectData object, const MapData map, const Ray ray) {
    ObjectHit hit;
    if (kMarcher == MARCHER_LIPSCHITZ) hit = hitLipschitz(object, map, ray);
    if (kMarcher != MARCHER_LIPSCHITZ) hit = hitNaive(object, map, ray);
    if (hit.hit) {
        NaivePlace place = naivePlace(object, map, hit.p);
        hit.stored = patchValue(fetchPatch(map, real(1), place.cell), place.at.fu, place.at.fv);
    }
    return hit;
}

// Of secondary rays above the hit. Moving by e along the normal raises f by e at least: a baseline's start must stand
// above its own threshold, or all would lie in shadow.
real startOffset(const ObjectData object) {
    return kMarcher == MARCHER_EXACT ? real(object.offset) : max(real(object.offset), real(2) * real(kThreshold));
}
