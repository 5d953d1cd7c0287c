// The scene's nearest hit, its shadows and direct light. Loops over objects and lights have the bounds of the scene.

// The nearest hit, made ready for shading. World space unless said otherwise.
struct SurfacePoint {
    bool hit, inside, exhausted, doubtful;
    int object, steps;
    int level;  // of detail that its map was marched at
    float t;
    vec3 from_first;  // position seen from object 0's centre
    vec3 position, normal;
#ifdef WITH_CURVED
    vec3 smooth_normal;
#endif
    vec3 object_position, start;  // object space, units of R; start: P', where secondary rays begin
    vec3 albedo;
    float h;  // height on the ramp
    int ramp;
    float residual;
};

// Where light comes from a smoother surface than the true one, this is its normal.
vec3 shadingNormal(SurfacePoint point) {
#ifdef WITH_CURVED
    return point.smooth_normal;
#else
    return point.normal;
#endif
}

// Whether the hit at distance t along `towards`, at `from_first` from object 0's centre, comes before the best so far. From
// afar t rounds to more than objects are apart; places near object 0 then tell them apart.
bool isNearer(SurfacePoint best, float t, vec3 towards, vec3 from_first) {
    if (!best.hit) return true;
    bool far = max(dot(from_first, from_first), dot(best.from_first, best.from_first)) < t * t;
    return far && !best.inside ? dot(towards, from_first - best.from_first) < 0.0 : t < best.t;
}

// The coarsest level of object k's map that is off by kDetail pixels at most all along a camera's ray: where it enters
// the shell, pixels are smallest.
int levelFor(int k, ObjectData object, Ray ray) {
    if (kDetail <= 0.0) return 0;
    float half_chord = sqrt(max(object.shell_squared - ray.c2, 0.0));
    float distance = max(-half_chord - ray.s_min, 0.0);
    float pixels = kDetail * (object.pixel_size + distance * object.pixel_growth);
    int level = 0;
    for (int next = 1; next < MAX_LEVELS; ++next)
        level = pixels >= maps[next * MAX_OBJECTS + k].least_pixel ? next : level;
    return level;
}

MapData mapOf(int k, int level) {
    return maps[level * MAX_OBJECTS + k];
}

// Keeps object k's hit if it is the nearest so far.
void considerObject(inout SurfacePoint best, int k, vec2 raster, vec2 jitter) {
    ObjectData object = objects[k];
    vec2 pixel = raster - vec2(object.anchor_x, object.anchor_y);
    Ray ray = cameraRay(object, pixel, jitter);
    int level = levelFor(k, object, ray);
    ObjectHit hit = hitObject(object, mapOf(k, level), ray);
    best.steps += hit.steps;
    best.exhausted = best.exhausted || hit.exhausted;
    best.doubtful = best.doubtful || hit.doubtful;
    vec3 towards = fromRayStart(object, hit.p, pixel + jitter);
    float t = hit.inside ? 0.0 : length(towards);
    vec3 from_first = fromCentre(object, hit.p) + object.from_first.xyz;
    if (hit.hit && (kObjectCount == 1 || isNearer(best, t, towards, from_first))) {
        best.hit = true;
        best.inside = hit.inside;
        best.object = k;
        best.level = level;
        best.t = t;
        best.from_first = from_first;
        best.position = worldFromObjectPoint(object, hit.p);
        best.normal = worldNormal(object, hit.n);
#ifdef WITH_CURVED
        best.smooth_normal = worldNormal(object, hit.shading_n);
#endif
        best.object_position = hit.p;
        best.start = hit.p + startOffset(object) * hit.n;
        best.albedo = object.albedo.rgb;
        best.h = object.ramp_offset + object.ramp_scale * hit.stored;
        best.ramp = object.ramp;
        best.residual = abs(hit.residual);
    }
}

SurfacePoint nearestHit(vec2 raster, vec2 jitter) {
    SurfacePoint best;
    best.hit = false;
    best.inside = false;
    best.exhausted = false;
    best.doubtful = false;
    best.object = -1;
    best.steps = 0;
    best.level = 0;
    best.t = kInfinity;
    for (int k = 0; k < kObjectCount; ++k) considerObject(best, k, raster, jitter);
    return best;
}

vec3 albedoOf(SurfacePoint point) {
    if (kImages != 0 && objects[point.object].image != IMAGE_NONE)
        return imageColour(objects[point.object], point.object_position);
    if (point.ramp < 0) return point.albedo;
    float place = clamp(point.h, 0.0, 1.0) * float(RAMP_POINTS - 1);
    int k = min(int(place), RAMP_POINTS - 2);
    int first = point.ramp * RAMP_POINTS + k;
    return mix(ramp_points[first].rgb, ramp_points[first + 1].rgb, place - float(k));
}

// Whether object k is between P' and the light, `towards` which ends there or goes on for ever.
bool shades(int k, SurfacePoint point, LightData light, bool ends, inout bool doubtful) {
    ObjectData object = objects[k];
    vec3 start = point.start;
    if (kObjectCount > 1 && k != point.object)
        start = objectFromWorldPoint(object, worldFromObjectPoint(objects[point.object], point.start));
    vec3 offset = ends ? objectFromWorldVector(object, light.position.xyz - object.from_first.xyz) - start
                       : objectFromWorldVector(object, light.position.xyz);
    // P' stands on the level that the camera's ray met; other objects throw the shadows of their maps.
    MapData map = mapOf(k, k == point.object ? point.level : 0);
    return blocks(object, map, secondaryRay(start, offset, ends), doubtful);
}

// Whether the light is seen from P'. `doubtful` is set where another precision must decide.
bool isLit(SurfacePoint point, LightData light, inout bool doubtful) {
    bool ends = light.position.w > 0.5;
    vec3 towards = ends ? light.position.xyz - point.from_first : light.position.xyz;
    bool lit = dot(towards, point.normal) > 0.0;
    for (int k = 0; k < kObjectCount && lit; ++k) lit = !shades(k, point, light, ends, doubtful);
    return lit;
}

uint visibleLights(SurfacePoint point, inout bool doubtful) {
    uint mask = 0u;
    for (int k = 0; k < kLightCount; ++k) mask |= isLit(point, lights[k], doubtful) ? 1u << k : 0u;
    return mask;
}

#ifdef WITH_CURVED
// A facet that turns away from the light is dark however its shading normal stands: fades to that instead of breaking off
// (Chiang, Li and Burley 2019, "Taming the shadow terminator"). 1 where both normals are one.
float terminatorShare(float cosine, float shading_cosine, float between) {
    float share = clamp(cosine / max(shading_cosine * between, 1e-6), 0.0, 1.0);
    return share * (1.0 + share * (1.0 - share));
}
#endif

// Radiance that a Lambertian surface of albedo pi sends off because of a light.
vec3 lightFrom(LightData light, SurfacePoint point) {
    vec3 towards = light.position.xyz - light.position.w * point.from_first;
    float square = dot(towards, towards);
    float cosine = max(dot(towards, shadingNormal(point)) * inversesqrt(square), 0.0);
#ifdef WITH_CURVED
    cosine *= terminatorShare(dot(towards, point.normal) * inversesqrt(square), cosine, dot(point.normal, point.smooth_normal));
#endif
    return light.radiance.rgb * (light.position.w > 0.5 ? cosine / square : cosine);
}

// Lambert: albedo / pi times the irradiance of the visible lights.
vec3 directLight(SurfacePoint point, vec3 albedo, uint lit) {
    vec3 sum = vec3(0.0);
    for (int k = 0; k < kLightCount; ++k)
        if ((lit & (1u << k)) != 0u) sum += lightFrom(lights[k], point);
    return albedo * sum / kPi;
}
