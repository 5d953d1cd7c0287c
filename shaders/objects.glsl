// One object's ray and hit: from camera or surface to object space, and back to world. Expects search.glsl, scope.glsl and
// the constant kKinds (a bit per KIND_ of the scene: what no object needs is compiled away).

// x and y count pixels from the object's anchor, to the pixel's centre; the jitter of a sample within the pixel needs no
// more than a float's bits, and the filter as a whole none.
Pair cameraValue(const real base, const real base_lo, const real step_x, const real step_x_lo, const real step_y,
                 const real step_y_lo, const vec2 pixel, const vec2 jitter) {
    vec2 place = pixel + jitter;
    if (kSingleFloats)
        return makePair(base + (place.x * (step_x + step_x_lo) + (place.y * (step_y + step_y_lo) + base_lo)), real(0));
    real rest = base_lo + (jitter.x * step_x + jitter.y * step_y);
    return pairLinear(makePair(base, rest), pixel.x, makePair(step_x, step_x_lo), pixel.y,
                      makePair(step_y, step_y_lo));
}

Ray cameraRay(const ObjectData o, const vec2 pixel, const vec2 jitter) {
    Line line;
    line.x = cameraValue(o.point_0.x, o.point_0_lo.x, o.point_x.x, o.point_x_lo.x, o.point_y.x, o.point_y_lo.x, pixel,
                         jitter);
    line.y = cameraValue(o.point_0.y, o.point_0_lo.y, o.point_x.y, o.point_x_lo.y, o.point_y.y, o.point_y_lo.y, pixel,
                         jitter);
    line.z = cameraValue(o.point_0.z, o.point_0_lo.z, o.point_x.z, o.point_x_lo.z, o.point_y.z, o.point_y_lo.z, pixel,
                         jitter);
    line.dx = cameraValue(o.direction_0.x, o.direction_0_lo.x, o.direction_x.x, o.direction_x_lo.x, o.direction_y.x,
                          o.direction_y_lo.x, pixel, jitter);
    line.dy = cameraValue(o.direction_0.y, o.direction_0_lo.y, o.direction_x.y, o.direction_x_lo.y, o.direction_y.y,
                          o.direction_y_lo.y, pixel, jitter);
    line.dz = cameraValue(o.direction_0.z, o.direction_0_lo.z, o.direction_x.z, o.direction_x_lo.z, o.direction_y.z,
                          o.direction_y_lo.z, pixel, jitter);
    return makeRay(line, o.direction_0.w, kInfinity, true);
}

// From p towards p + offset, which ends it if `ends`.
Ray secondaryRay(const vec3 p, const vec3 offset, const bool ends) {
    Line line;
    line.x = makePair(p.x, real(0));
    line.y = makePair(p.y, real(0));
    line.z = makePair(p.z, real(0));
    line.dx = makePair(offset.x, real(0));
    line.dy = makePair(offset.y, real(0));
    line.dz = makePair(offset.z, real(0));
    return makeRay(line, real(0), ends ? length(offset) : kInfinity, false);
}

vec3 rowsTimesPoint(const vec4 x, const vec4 y, const vec4 z, const vec3 p) {
    return vec3(dot(vec3(x), p) + x.w, dot(vec3(y), p) + y.w, dot(vec3(z), p) + z.w);
}

vec3 rowsTimesVector(const vec4 x, const vec4 y, const vec4 z, const vec3 v) {
    return vec3(dot(vec3(x), v), dot(vec3(y), v), dot(vec3(z), v));
}

vec3 objectFromWorldPoint(const ObjectData object, const vec3 p) {
    return rowsTimesPoint(vec4(object.to_object_x), vec4(object.to_object_y), vec4(object.to_object_z), p);
}

vec3 objectFromWorldVector(const ObjectData object, const vec3 v) {
    return rowsTimesVector(vec4(object.to_object_x), vec4(object.to_object_y), vec4(object.to_object_z), v);
}

vec3 worldFromObjectPoint(const ObjectData object, const vec3 p) {
    return rowsTimesPoint(vec4(object.to_world_x), vec4(object.to_world_y), vec4(object.to_world_z), p);
}

// Normals go by the transpose of world -> object.
vec3 worldNormal(const ObjectData object, const vec3 n) {
    return normalize(n.x * vec3(object.to_object_x) + n.y * vec3(object.to_object_y) + n.z * vec3(object.to_object_z));
}

// World vector from the object's centre.
vec3 fromCentre(const ObjectData object, const vec3 p) {
    return rowsTimesVector(vec4(object.to_world_x), vec4(object.to_world_y), vec4(object.to_world_z), p);
}

// World vector from the ray's start: the hit is near the object's centre, whose offset from the start the host gave.
// o + t d instead would cancel; a t from the ray parameter would carry three more roundings.
vec3 fromRayStart(const ObjectData object, const vec3 p, const vec2 pixel) {
    vec3 moved = pixel.x * vec3(object.start_x) + pixel.y * vec3(object.start_y);
    return fromCentre(object, p) + (vec3(object.from_start) - moved);
}

ObjectHit hitUnitSphere(const Ray ray) {
    ObjectHit hit = noHit();
    real margin = real(1) - ray.c2;
    real half_chord = sqrt(max(margin, real(0)));
    bool enters = margin > real(0) && -half_chord >= ray.s_min && -half_chord < ray.s_max;
    bool starts_within = margin > real(0) && ray.s_min > -half_chord && ray.s_min < half_chord;
    hit.inside = starts_within && ray.may_start_inside;
    hit.hit = enters || hit.inside || (starts_within && ray.s_min < real(0));
    hit.p = ray.c + (enters ? -half_chord : ray.s_min) * ray.d;
    hit.n = normalize(hit.p);
    hit.residual = length(hit.p) - real(1);
    return hit;
}

// Radius 1 in the plane z = base.
ObjectHit hitRing(const ObjectData object, const Ray ray) {
    ObjectHit hit = noHit();
    real s = (real(object.base) - ray.c.z) / ray.d.z;
    vec3 p = ray.c + s * ray.d;
    real rho2 = p.x * p.x + p.y * p.y;
    bool after_start = ray.may_start_inside ? s >= ray.s_min : s > ray.s_min;
    hit.hit = after_start && s < ray.s_max && rho2 <= real(1) && rho2 >= real(object.inner_squared);
    hit.p = vec3(p.x, p.y, real(object.base));
    hit.n = vec3(real(0), real(0), ray.d.z > real(0) ? real(-1) : real(1));
    return hit;
}

bool isKind(const ObjectData object, const int kind) {
    return isAmong(object.kind, kind, kKinds);
}

// Which of a scene's objects are meant: displaced spheres, whose march is long, or the others.
const int kDisplaced = 1 << KIND_DISPLACED;
const int kPlain = ~kDisplaced;

// Whether an object is of that kind and the kind is meant. Loops over displaced spheres meet no others, nor does who asks
// for the only plain object.
bool isKindMeant(const ObjectData object, const int kind, const int kinds) {
    bool all_meant = kinds == kDisplaced || (kinds == kPlain && kOnlyPlain >= 0);
    return (kinds & 1 << kind) != 0 && isAmong(object.kind, kind, all_meant ? kKinds & kinds : kKinds);
}

// Of an object of the kinds meant; nothing of others.
ObjectHit hitObject(const ObjectData object, const MapData map, const Ray ray, const int kinds) {
    ObjectHit hit = noHit();
    if (isKindMeant(object, KIND_DISPLACED, kinds)) hit = hitDisplaced(object, map, ray);
    if ((kinds & kPlain) == 0) return hit;
    if (isKindMeant(object, KIND_SPHERE, kinds)) hit = hitUnitSphere(ray);
    if (isKindMeant(object, KIND_DISK, kinds)) hit = hitRing(object, ray);
    if (kPaths && isKindMeant(object, KIND_MESH, kinds)) hit = hitMesh(object, ray);
    if (!isKindMeant(object, KIND_DISPLACED, kinds)) hit.shading_n = hit.n;
    return hit;
}

// Whether a ray that starts on the object meets it nowhere, as its bounds tell.
bool escapesObject(const ObjectData object, const MapData map, const Ray ray) {
    return kMarches && isKind(object, KIND_DISPLACED) && escapes(ray, map);
}

// Any hit: no root is refined, no normal found.
bool blocks(const ObjectData object, const MapData map, const Ray ray, const int kinds, INOUT(Searches) searches) {
    bool blocked = false;
    if (isKindMeant(object, KIND_DISPLACED, kinds)) blocked = displacedBlocks(object, map, ray, searches);
    if ((kinds & kPlain) == 0) return blocked;
    if (isKindMeant(object, KIND_SPHERE, kinds)) blocked = hitUnitSphere(ray).hit;
    if (isKindMeant(object, KIND_DISK, kinds)) blocked = hitRing(object, ray).hit;
    if (kPaths && isKindMeant(object, KIND_MESH, kinds)) blocked = hitMesh(object, ray).hit;
    return blocked;
}
