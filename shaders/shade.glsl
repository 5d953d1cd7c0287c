// The scene's nearest hit along a ray, its colour, and what stands between it and a light. Loops over objects have the
// bounds of the scene.

// The nearest hit, made ready for shading. World space unless said otherwise.
struct SurfacePoint {
    bool hit, inside, exhausted, doubtful;
    int object, steps;
    int level;  // of detail that its map was marched at
    real safe_s;  // of a scene's only object: ObjectHit::safe_s
    real t;
    vec3 from_first;  // position seen from object 0's centre
    vec3 position, normal;
    vec3 smooth_normal;  // where patches are curved
    vec3 towards;  // from the ray's start
    vec2 uv;       // of a mesh
    vec3 object_position, start;  // object space, units of R; start: P', where secondary rays begin
    vec3 world_start;             // P'
    vec3 albedo;
    real h;  // height on the ramp
    int ramp;
    real residual;
};

// A picture's sample, or the planes of its centre.
struct Gathered {
    SurfacePoint point;  // that the camera's ray met
    vec3 albedo, colour;
    uint lit;
    real weight;  // of the camera's sample under a pixel filter: 1 unless the filter is negative in places
    Searches searches;
};

// Nothing gathered yet; `point` is left unset.
Gathered nothingGathered() {
    Gathered result;
    result.albedo = vec3(real(0));
    result.colour = vec3(real(0));
    result.lit = 0u;
    result.weight = real(1);
    result.searches.doubtful = false;
    result.searches.steps = 0;
    return result;
}

// Light from right beside its source, which grows without bound: sums of it stay finite.
vec3 finiteLight(const vec3 light) {
    return min(light, vec3(real(1e30)));
}

// Where light comes from a smoother surface than the true one, this is its normal.
vec3 shadingNormal(const SurfacePoint point) {
    return kCurved ? point.smooth_normal : point.normal;
}

// Whether the hit at distance t along `towards`, at `from_first` from object 0's centre, comes before the best so far. From
// afar t rounds to more than objects are apart; places near object 0 then tell them apart.
bool isNearer(const SurfacePoint best, const real t, const vec3 towards, const vec3 from_first) {
    if (!best.hit) return true;
    bool far = max(dot(from_first, from_first), dot(best.from_first, best.from_first)) < t * t;
    return far && !best.inside ? dot(towards, from_first - best.from_first) < real(0) : t < best.t;
}

// The coarsest level of object k's map that is off by kDetail pixels at most all along a camera's ray: where it enters
// the shell, pixels are smallest.
int levelFor(const int k, const ObjectData object, const Ray ray) {
    if (kDetail <= real(0)) return 0;
    real half_chord = sqrt(max(real(object.shell_squared) - ray.c2, real(0)));
    real distance = max(-half_chord - ray.s_min, real(0));
    real pixels = kDetail * (real(object.pixel_size) + distance * real(object.pixel_growth));
    int level = 0;
    for (int next = 1; next < MAX_LEVELS; ++next)
        level = pixels >= real(maps[next * MAX_OBJECTS + k].least_pixel) ? next : level;
    return level;
}

// Whether objects of the kinds meant are the main one alone.
bool meansMain(const int kinds) {
    return kOneObject || (kinds == kDisplaced && kOnlyDisplaced >= 0);
}

// Object k, one of the kinds meant.
ObjectData objectOf(const int k, const int kinds) {
    if (meansMain(kinds)) return main_object;
    if (kinds == kPlain && kOnlyPlain >= 0) return plain_object;
    return objects[k];
}

MapData mapOf(const int k, const int kinds, const int level) {
    if (meansMain(kinds) && kDetail <= real(0)) return main_map;
    return maps[level * MAX_OBJECTS + (meansMain(kinds) ? kMainObject : k)];
}

// Where a ray starts: it is the camera's, or one of a list, or starts on a surface.
struct Segment {
    uint index;           // of a list's ray
    vec2 raster, jitter;  // of a camera's: through a place of the picture
    real safe_s;  // of a first ray with a scene's only object: up to this s nothing is met
    bool camera;          // or of the list; the rest is of other rays
    int object, level;    // that it starts on, and of whose detail
    vec3 start;           // P', in that object's space
    vec3 world_start;     // P'
    vec3 from_first;      // P, world, from object 0's centre
    vec3 direction;       // world, unit
};

// A ray that starts on no surface, but for where it runs.
Segment firstSegment(const real safe_s) {
    Segment segment;
    segment.index = 0u;
    segment.raster = vec2(real(0));
    segment.jitter = vec2(real(0));
    segment.safe_s = safe_s;
    segment.camera = true;
    segment.object = 0;
    segment.level = 0;
    segment.start = vec3(real(0));
    segment.world_start = vec3(real(0));
    segment.from_first = vec3(real(0));
    segment.direction = vec3(real(0));
    return segment;
}

// firstRay(), firstTowards(), firstDirection() and firstStart() of such a ray.
#include "firstray.glsl"

// P' in the space of object k; `start`: in that of object `from`.
vec3 startFor(const int k, const ObjectData object, const int from, const vec3 start, const vec3 world_start) {
    if (kOneObject || k == from) return start;
    return objectFromWorldPoint(object, world_start);
}

Ray segmentRay(const Segment segment, const int k, const ObjectData object) {
    if (kPaths && !segment.camera)
        return secondaryRay(startFor(k, object, segment.object, segment.start, segment.world_start),
                            objectFromWorldVector(object, segment.direction), false);
    return firstRay(segment, k, object);
}

// A retried first ray starts where the filter's certainty ended.
void startClear(INOUT(Ray) ray, const Segment segment) {
    if (!kIsRetry) return;
    if (kOneObject && segment.safe_s > ray.s_min) {
        ray.s_min = segment.safe_s;
        ray.may_start_inside = false;
    }
}

// P' stands on the level that the ray before met; rays from it meet other objects' maps themselves.
int segmentLevel(const Segment segment, const int k, const ObjectData object, const Ray ray) {
    if (kPaths && !segment.camera) return k == segment.object ? segment.level : 0;
    return levelFor(k, object, ray);
}

vec3 towardsHit(const Segment segment, const int k, const ObjectData object, const vec3 p, const vec3 from_first) {
    if (kPaths && !segment.camera) return from_first - segment.from_first;
    return firstTowards(segment, k, object, p);
}

// World, unit.
vec3 segmentDirection(const Segment segment) {
    if (kPaths && !segment.camera) return segment.direction;
    return firstDirection(segment);
}

// World, from object 0's centre.
vec3 segmentStart(const Segment segment) {
    if (kPaths && !segment.camera) return segment.from_first;
    return firstStart(segment);
}

// A bit an object: displaced spheres that a ray may meet. The loop that marches through them has an iteration for each that
// some ray of a group may meet, and none for the other objects: most groups take one or none.
struct Candidates {
    uint low, high;
};

bool isLeft(const Candidates candidates) {
    return (candidates.low | candidates.high) != 0u;
}

int takeFirst(INOUT(Candidates) candidates) {
    bool in_low = candidates.low != 0u;
    int k = in_low ? findLSB(candidates.low) : 32 + findLSB(candidates.high);
    candidates.high = in_low ? candidates.high : candidates.high & (candidates.high - 1u);
    candidates.low = candidates.low & (candidates.low - 1u);
    return k;
}

// Whether a ray (start from object 0's centre, direction unit, world) may enter a sphere: never a false no, by a margin far
// above what the ray's rounding comes to. Spheres of negative radius are never met: those of other objects, so that no
// kind has to be asked for, see uniforms.glsl.
bool mayMeet(const vec4 sphere, const vec3 start, const vec3 direction) {
    vec3 towards = XYZ(sphere) - start;
    real along = dot(towards, direction);
    vec3 beside = towards - along * direction;
    real reach = sphere.w + real(1e-5) * (length(start) + length(towards));
    return along > -reach && dot(beside, beside) < reach * abs(reach);
}

void addIfNear(INOUT(Candidates) candidates, const int k, const vec3 start, const vec3 direction) {
    uint bit = mayMeet(objectOf(k, kDisplaced).from_first, start, direction) ? 1u << (k & 31) : 0u;
    candidates.low |= k < 32 ? bit : 0u;
    candidates.high |= k < 32 ? 0u : bit;
}

Candidates displacedNear(const vec3 start, const vec3 direction) {
    Candidates candidates;
    candidates.low = 0u;
    candidates.high = 0u;
    if (kOnlyDisplaced >= 0)
        addIfNear(candidates, kOnlyDisplaced, start, direction);
    else {
        int k = 0;
        [[dont_unroll]] do {  // rule L9
            addIfNear(candidates, k, start, direction);
        } while (++k < kObjectCount);
    }
    return candidates;
}

// Keeps a hit of object k, if it is the nearest so far.
void takeHit(INOUT(SurfacePoint) best, const int k, const ObjectData object, const int level, const Segment segment,
             INOUT(ObjectHit) hit) {
    ROUND_AS_FILMED(hit.p);
    best.steps += hit.steps;
    best.exhausted = best.exhausted || hit.exhausted;
    best.doubtful = best.doubtful || hit.doubtful;
    if (kOneObject) best.safe_s = hit.safe_s;
    vec3 from_first = fromCentre(object, hit.p) + XYZ(object.from_first);
    vec3 towards = towardsHit(segment, k, object, hit.p, from_first);
    real t = hit.inside ? real(0) : length(towards);
    if (hit.hit && (kOneObject || isNearer(best, t, towards, from_first))) {
        best.hit = true;
        best.inside = hit.inside;
        best.object = k;
        best.level = level;
        best.t = t;
        best.from_first = from_first;
        best.position = worldFromObjectPoint(object, hit.p);
        best.normal = worldNormal(object, hit.n);
        best.smooth_normal = kCurved ? worldNormal(object, hit.shading_n) : best.normal;
        best.towards = towards;
        best.uv = hit.uv;
        best.object_position = hit.p;
        best.start = hit.p + startOffset(object) * hit.n;
        best.world_start = worldFromObjectPoint(object, best.start);
        best.albedo = XYZ(object.albedo);
        best.h = real(object.ramp_offset) + real(object.ramp_scale) * hit.stored;
        best.ramp = object.ramp;
        best.residual = abs(hit.residual);
    }
}

// Where a first ray or a path's meets object k, if it is of the kinds meant.
void considerObject(INOUT(SurfacePoint) best, const int k, const Segment segment, const int kinds) {
    ObjectData object = objectOf(k, kinds);
    Ray ray = segmentRay(segment, k, object);
    int level = segmentLevel(segment, k, object, ray);
    startClear(ray, segment);  // after the level, which goes by where the ray enters the shell
    ObjectHit hit = hitObject(object, mapOf(k, kinds, level), ray, kinds);
    takeHit(best, k, object, level, segment, hit);
}

SurfacePoint noPoint() {
    SurfacePoint point;
    point.hit = false;
    point.inside = false;
    point.exhausted = false;
    point.doubtful = false;
    point.object = -1;
    point.steps = 0;
    point.level = 0;
    point.safe_s = -kInfinity;
    point.ramp = -1;  // so that it is not the object's alone (rule L2)
    point.t = kInfinity;
    return point;
}

SurfacePoint nearestHit(const Segment segment) {
    SurfacePoint best = noPoint();
    // Not even a loop of one iteration is free: it stands between the driver and what it could do once (rule L3).
    if (kOneObject) {
        considerObject(best, 0, segment, ~0);
        return best;
    }
    Candidates candidates = displacedNear(segmentStart(segment), segmentDirection(segment));
    if (kOnlyPlain >= 0)
        considerObject(best, kOnlyPlain, segment, kPlain);
    else if ((kKinds & kPlain) != 0) {
        int k = 0;
        [[dont_unroll]] do {
            considerObject(best, k, segment, kPlain);
        } while (++k < kObjectCount);
    }
    while (isLeft(candidates)) {
        considerObject(best, takeFirst(candidates), segment, kDisplaced);
        if (!isLeft(candidates)) break;
    }
    return best;
}

// Of an object that is of one of the `possible` kinds.
vec2 pointUv(const SurfacePoint point, const int possible) {
    if (kPaths && isAmong(objects[point.object].kind, KIND_MESH, possible)) return point.uv;
    return surfaceUv(objects[point.object], point.object_position, possible);
}

vec3 pointImageColour(const SurfacePoint point) {
    if (kPaths && isAmong(objects[point.object].kind, KIND_MESH, kImages)) return imageColourAt(objects[point.object], point.uv);
    return imageColour(objects[point.object], point.object_position);
}

vec3 checkerColour(const SurfacePoint point) {
    MaterialData material = materials[point.object];
    vec2 cell = floor(pointUv(point, kCheckerboards) * vec2(material.u_scale, material.v_scale));
    return mod(cell.x + cell.y, real(2)) < real(0.5) ? point.albedo : XYZ(material.odd);
}

// What tells images and checkerboards apart is read by the hit's own index, lest a branch depend on uniform data alone: see
// uniforms.glsl.
vec3 albedoOf(const SurfacePoint point) {
    if (kImages != 0 && objects[point.object].image != IMAGE_NONE)
        return pointImageColour(point);
    if (kPaths) {
        if (kCheckerboards != 0 && materials[point.object].checkerboard != 0) return checkerColour(point);
    }
    if (kRamps == 0 || point.ramp < 0) return point.albedo;
    real place = clamp(point.h, real(0), real(1)) * real(RAMP_POINTS - 1);
    int k = min(int(place), RAMP_POINTS - 2);
    int first = point.ramp * RAMP_POINTS + k;
    vec3 colour = mix(XYZ(ramp_points[first]), XYZ(ramp_points[first + 1]), place - real(k));
    return min(colour * XYZ(objectOf(point.object, ~0).texture_scale), vec3(real(1)));
}

// From P' in the space of object k to a light: at `place`, seen from object 0's centre, if the ray `ends` there; in the
// direction `place` if it goes on for ever.
Ray shadowRay(const int k, const ObjectData object, const SurfacePoint point, const vec3 place, const bool ends) {
    vec3 start = startFor(k, object, point.object, point.start, point.world_start);
    vec3 offset = ends ? objectFromWorldVector(object, place - XYZ(object.from_first)) - start
                       : objectFromWorldVector(object, place);
    return secondaryRay(start, offset, ends);
}

// Whether object k is between P' and a light.
bool shades(const int k, const SurfacePoint point, const vec3 place, const bool ends, const int kinds,
            INOUT(Searches) searches) {
    ObjectData object = objectOf(k, kinds);
    // P' stands on the level that the camera's ray met; other objects throw the shadows of their maps.
    MapData map = mapOf(k, kinds, k == point.object ? point.level : 0);
    return blocks(object, map, shadowRay(k, object, point, place, ends), kinds, searches);
}

// Whether an object other than `except` stands between; `except` is -1, or a plain object that is the light itself.
bool isShaded(const SurfacePoint point, const vec3 place, const bool ends, const int except, INOUT(Searches) searches) {
    if (kOneObject) return shades(0, point, place, ends, ~0, searches) && except != 0;
    bool shaded = false;
    if (kOnlyPlain >= 0)
        shaded = shades(kOnlyPlain, point, place, ends, kPlain, searches) && except != kOnlyPlain;
    else if ((kKinds & kPlain) != 0) {
        [[dont_unroll]] for (int k = 0; k < kObjectCount; ++k) {
            if (k != except) shaded = shades(k, point, place, ends, kPlain, searches);
            if (shaded || k + 1 == kObjectCount) break;
        }
    }
    Candidates candidates = displacedNear(point.from_first, normalize(ends ? place - point.from_first : place));
    while (!shaded && isLeft(candidates)) {
        shaded = shades(takeFirst(candidates), point, place, ends, kDisplaced, searches);
        if (shaded || !isLeft(candidates)) break;
    }
    return shaded;
}

// Stands in for shadow rays where kShadows is 0: the share of the light from `towards` (unit, world) that is left at a point
// of a displaced sphere. Light fades at the horizon of the mean sphere, which lies the lower, the higher the point is. Where
// `mean_radius` is negative, as other shapes have it, the share is 1.
const real kHorizonWidth = real(0.1);  // the sine of the angles over which light fades

real horizonShare(const SurfacePoint point, const vec3 towards) {
    ObjectData object = objectOf(point.object, ~0);
    real cosine = min(real(object.mean_radius) / length(point.object_position), real(1));
    real dip = sqrt(real(1) - cosine * abs(cosine));  // its sine; above 1 without a horizon
    real sine = dot(normalize(point.from_first - XYZ(object.from_first)), towards) + dip;
    return clamp(real(0.5) + sine / kHorizonWidth, real(0), real(1));
}

// A facet that turns away from the light is dark however its shading normal stands: fades to that instead of breaking off
// (Chiang, Li and Burley 2019, "Taming the shadow terminator"). 1 where both normals are one.
real terminatorShare(const real cosine, const real shading_cosine, const real between) {
    real share = clamp(cosine / max(shading_cosine * between, real(1e-6)), real(0), real(1));
    return share * (real(1) + share * (real(1) - share));
}
