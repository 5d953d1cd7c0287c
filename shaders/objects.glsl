// One object's ray and hit: from camera or surface to object space, and back to world. Expects march.glsl, naive.glsl
// and the constants kMarcher and kKinds (a bit per KIND_ of the scene: what no object needs is compiled away).

// The ray of unit direction d (any length) and moment m = o x d.
Ray momentRay(vec3 direction, vec3 moment, real along) {
    real inverse_length = real(1) / length(direction);
    Ray ray;
    ray.d = direction * inverse_length;
    vec3 m = moment * inverse_length;
    precise vec3 c = cross(ray.d, m);
    ray.c = c;
    ray.c2 = dot(c, c);
    ray.s_min = along * inverse_length;
    ray.s_max = kInfinity;
    ray.may_start_inside = true;
    return ray;
}

// x and y count pixels from the object's anchor.
Ray cameraRay(ObjectData object, real x, real y) {
    precise vec4 direction = vec4(object.direction_0) + x * vec4(object.direction_x) + y * vec4(object.direction_y);
    precise vec4 moment = vec4(object.moment_0) + x * vec4(object.moment_x) + y * vec4(object.moment_y);
    return momentRay(vec3(direction), vec3(moment), direction.w);
}

// From p towards p + offset, which ends it if `ends`.
Ray secondaryRay(vec3 p, vec3 offset, bool ends) {
    precise vec3 moment = cross(p, offset);
    Ray ray = momentRay(offset, moment, dot(p, offset));
    ray.s_max = ends ? ray.s_min + length(offset) : kInfinity;
    ray.may_start_inside = false;
    return ray;
}

vec3 rowsTimesPoint(vec4 x, vec4 y, vec4 z, vec3 p) {
    return vec3(dot(vec3(x), p) + x.w, dot(vec3(y), p) + y.w, dot(vec3(z), p) + z.w);
}

vec3 rowsTimesVector(vec4 x, vec4 y, vec4 z, vec3 v) {
    return vec3(dot(vec3(x), v), dot(vec3(y), v), dot(vec3(z), v));
}

vec3 objectFromWorldPoint(ObjectData object, vec3 p) {
    return rowsTimesPoint(vec4(object.to_object_x), vec4(object.to_object_y), vec4(object.to_object_z), p);
}

vec3 objectFromWorldVector(ObjectData object, vec3 v) {
    return rowsTimesVector(vec4(object.to_object_x), vec4(object.to_object_y), vec4(object.to_object_z), v);
}

vec3 worldFromObjectPoint(ObjectData object, vec3 p) {
    return rowsTimesPoint(vec4(object.to_world_x), vec4(object.to_world_y), vec4(object.to_world_z), p);
}

// Normals go by the transpose of world -> object.
vec3 worldNormal(ObjectData object, vec3 n) {
    return normalize(n.x * vec3(object.to_object_x) + n.y * vec3(object.to_object_y) + n.z * vec3(object.to_object_z));
}

// Distance from the camera: the hit is near the object's centre, whose offset from the camera the host gave. o + t d
// instead would cancel; a t from the ray parameter would carry three more roundings.
real cameraDistance(ObjectData object, vec3 p) {
    vec3 offset = rowsTimesVector(vec4(object.to_world_x), vec4(object.to_world_y), vec4(object.to_world_z), p);
    return length(offset + vec3(object.from_camera));
}

ObjectHit hitUnitSphere(Ray ray) {
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
ObjectHit hitRing(ObjectData object, Ray ray) {
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

ObjectHit hitDisplaced(ObjectData object, MapData map, Ray ray) {
    ObjectHit hit = noHit();
    Walk walk = march(ray, map, real(object.base), real(object.scale), real(object.shell_squared));
    hit.hit = walk.hit;
    hit.inside = walk.inside;
    hit.exhausted = walk.exhausted;
    hit.steps = walk.steps;
    if (walk.hit) {
        Crossing crossing = refine(ray, map, real(object.base), real(object.scale), walk);
        hit.p = crossing.p;
        hit.n = normalize(crossing.gradient);
        hit.residual = crossing.at.g;
        hit.stored = storedAt(map, walk.cell, crossing.at);
        hit.steps += 4;
    }
    return hit;
}

bool sceneHas(int kind) {
    return (kKinds & (1 << kind)) != 0;
}

ObjectHit hitObject(ObjectData object, MapData map, Ray ray) {
    ObjectHit hit = noHit();
    if (sceneHas(KIND_DISPLACED) && object.kind == KIND_DISPLACED) {
        if (kMarcher == MARCHER_EXACT) hit = hitDisplaced(object, map, ray);
        if (kMarcher != MARCHER_EXACT) hit = hitNaive(object, map, ray);
    }
    if (sceneHas(KIND_SPHERE) && object.kind == KIND_SPHERE) hit = hitUnitSphere(ray);
    if (sceneHas(KIND_DISK) && object.kind == KIND_DISK) hit = hitRing(object, ray);
    return hit;
}

// Any hit: no root is refined, no normal found.
bool blocks(ObjectData object, MapData map, Ray ray) {
    bool blocked = false;
    if (sceneHas(KIND_DISPLACED) && object.kind == KIND_DISPLACED) {
        if (kMarcher == MARCHER_EXACT)
            blocked = march(ray, map, real(object.base), real(object.scale), real(object.shell_squared)).hit;
        if (kMarcher != MARCHER_EXACT) blocked = hitNaive(object, map, ray).hit;
    }
    if (sceneHas(KIND_SPHERE) && object.kind == KIND_SPHERE) blocked = hitUnitSphere(ray).hit;
    if (sceneHas(KIND_DISK) && object.kind == KIND_DISK) blocked = hitRing(object, ray).hit;
    return blocked;
}
