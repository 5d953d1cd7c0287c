// The baseline of every comparison: the marcher that this program replaces. Steps of |p| - r along o + t d in float, a
// hit when the step falls under a threshold, a miss when it exceeds |o|, finite-difference normals. It leaves holes
// where the surface is steep and rings where the camera is far, by design. Expects march.glsl and ObjectHit.

const real kNaiveThreshold = real(3e-6);
const int kNaiveSteps = 4000;
const real kNaiveDifference = real(1e-3);

// |p| - r with the patch found from a global u and v in float.
real naiveDistance(ObjectData object, MapData map, vec3 p) {
    ivec2 cell = locateCell(map, p);
    real column = atan2Precise(p.x, p.z) * (real(0.5) / kPi) * real(map.columns_per_turn) - real(map.first_column);
    real theta = atan2Precise(sqrt(p.x * p.x + p.z * p.z), p.y);
    real north = cell.y == 0 ? real(0) : (real(cell.y) - real(map.cap_shift)) / real(map.cells_per_radian_v);
    real fv = clamp((theta - north) * cellsPerRadianV(map, cell.y), real(0), real(1));
    real r = real(object.base) + patchValue(fetchPatch(map, real(object.scale), cell), column - floor(column), fv);
    return length(p) - r;
}

vec3 naiveSurface(ObjectData object, MapData map, vec3 direction) {
    vec3 w = normalize(direction);
    return w * (real(1) - naiveDistance(object, map, w));
}

vec3 naiveNormal(ObjectData object, MapData map, vec3 p) {
    vec3 w = normalize(p);
    vec3 east = normalize(vec3(w.z, real(0), -w.x) + vec3(real(1e-20), real(0), real(0)));
    vec3 south = cross(east, w);
    vec3 here = naiveSurface(object, map, w);
    vec3 along_east = naiveSurface(object, map, w + kNaiveDifference * east) - here;
    vec3 along_south = naiveSurface(object, map, w + kNaiveDifference * south) - here;
    vec3 n = normalize(cross(along_south, along_east));
    return dot(n, w) < real(0) ? -n : n;
}

ObjectHit hitNaive(ObjectData object, MapData map, Ray ray) {
    ObjectHit hit = noHit();
    vec3 origin = ray.c + ray.s_min * ray.d;
    real give_up = length(origin) + real(1e-3);
    real t = real(0);
    if (kMarcher == MARCHER_NAIVE_SHELL) {
        real margin = real(object.shell_squared) - ray.c2;
        if (margin <= real(0)) return hit;
        t = max(-sqrt(margin) - ray.s_min, real(0));
    }
    bool going = true;
    while (going && hit.steps < 4 * kNaiveSteps) {
        vec3 p = origin + t * ray.d;
        real stride = naiveDistance(object, map, p);
        hit.steps += 4;
        hit.hit = stride < kNaiveThreshold;
        hit.p = p;
        hit.residual = stride;
        t += stride;
        going = !hit.hit && stride <= give_up && ray.s_min + t < ray.s_max;
    }
    if (hit.hit) hit.n = naiveNormal(object, map, hit.p);
    return hit;
}
