// Direct light on Lambertian surfaces from distant and point lights. Expects shade.glsl.

// Whether P faces the light.
bool facesLight(const SurfacePoint point, const LightData light) {
    vec3 towards = isLight(light, LIGHT_POINT) ? XYZ(light.position) - point.from_first : XYZ(light.position);
    return dot(towards, point.normal) > real(0);
}

// Whether the light is seen from P'.
bool isLit(const SurfacePoint point, const LightData light, INOUT(Searches) searches) {
    return facesLight(point, light) &&
           !isShaded(point, XYZ(light.position), isLight(light, LIGHT_POINT), -1, searches);
}

uint visibleLights(const SurfacePoint point, INOUT(Searches) searches) {
    if (kLightCount == 1) return isLit(point, only_light, searches) ? 1u : 0u;
    uint mask = 0u;
    if (kLightCount == 0) return mask;
    int k = 0;
    do {
        mask |= isLit(point, lights[k], searches) ? 1u << k : 0u;
    } while (++k < kLightCount);
    return mask;
}

// Radiance that a Lambertian surface of albedo pi sends off because of a light.
vec3 lightFrom(const LightData light, const SurfacePoint point) {
    vec3 towards = XYZ(light.position) - real(light.position.w) * point.from_first;
    real square = dot(towards, towards);
    real cosine = max(dot(towards, shadingNormal(point)) * inversesqrt(square), real(0));
    if (kCurved)
        cosine *= terminatorShare(dot(towards, point.normal) * inversesqrt(square), cosine,
                                  dot(point.normal, point.smooth_normal));
    if (kShadows == 0) cosine *= horizonShare(point, towards * inversesqrt(square));
    if (!(square > real(0))) return vec3(real(0));  // a light on the surface itself
    return finiteLight(XYZ(light.radiance) * (isLight(light, LIGHT_POINT) ? cosine / square : cosine));
}

// Lambert: albedo / pi times the irradiance of the visible lights.
vec3 directLight(const SurfacePoint point, const vec3 albedo, const uint lit) {
    if (kLightCount == 1) return lit != 0u ? albedo * lightFrom(only_light, point) / kPi : vec3(real(0));
    vec3 sum = vec3(real(0));
    for (int k = 0; k < kLightCount; ++k)
        if ((lit & (1u << k)) != 0u) sum += lightFrom(lights[k], point);
    return albedo * sum / kPi;
}

LightData lightOf(const int k) {
    if (kLightCount == 1) return only_light;
    return lights[k];
}

// The light of a hit whose visible lights are known.
void addLight(INOUT(Gathered) result) {
    result.albedo = albedoOf(result.point);
    result.lit = kShadows == 0 ? ~0u : result.lit;
    result.colour = directLight(result.point, result.albedo, result.lit);
}

// gatherDirect() of a scene's only object: one loop through the first ray and those to the lights that have to be searched for. So the
// search stands once, which drivers compile sooner, and a group of lanes ends after the first where no light needs one (rule L14).
Gathered gatherInOneLoop(const Segment segment) {
    Gathered result = nothingGathered();
    SurfacePoint point = noPoint();
    ObjectData object = objectOf(0, ~0);
    Ray ray = segmentRay(segment, 0, object);
    int level = segmentLevel(segment, 0, object, ray);
    startClear(ray, segment);
    int turn = 0;  // the first ray's, then light `turn - 1`'s
    while (turn <= kLightCount) {
        MapData map = mapOf(0, ~0, level);
        ObjectHit hit = hitObject(object, map, ray, ~0);
        if (turn == 0)
            takeHit(point, 0, object, level, segment, hit);
        else
            result.lit |= hit.hit ? 0u : 1u << (turn - 1);
        point.doubtful = point.doubtful || hit.doubtful;
        if (!kWantsLight || kShadows == 0 || !point.hit || point.doubtful) break;
        bool needs_search = false;
        while (turn < kLightCount) {
            LightData light = lightOf(turn);
            ray = shadowRay(0, object, point, XYZ(light.position), isLight(light, LIGHT_POINT));
            bool facing = facesLight(point, light);
            needs_search = facing && !escapesObject(object, map, ray);
            ray.may_escape = false;
            result.lit |= facing && !needs_search ? 1u << turn : 0u;
            turn += 1;
            if (needs_search) break;
        }
        if (!needs_search) break;
    }
    result.point = point;
    result.searches.doubtful = point.doubtful;
    if (kWantsLight && point.hit && !point.doubtful) addLight(result);
    return result;
}

// The nearest hit, and its light if that is wanted.
Gathered gatherDirect(const Segment segment) {
    if (kOneObject) return gatherInOneLoop(segment);
    Gathered result = nothingGathered();
    result.point = nearestHit(segment);
    result.searches.doubtful = result.point.doubtful;
    if (kWantsLight && result.point.hit && !result.searches.doubtful) {
        if (kShadows != 0) result.lit = visibleLights(result.point, result.searches);
        addLight(result);
    }
    return result;
}

// Of one of a list's rays, by its own `key`: see shade_paths.
Gathered gatherListed(const Segment segment, const uint key) {
    return gatherDirect(segment);
}
