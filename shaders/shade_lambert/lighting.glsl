// Direct light on Lambertian surfaces from distant and point lights. Expects shade.glsl.

// Whether the light is seen from P'.
bool isLit(const SurfacePoint point, const LightData light, INOUT(Searches) searches) {
    bool ends = isLight(light, LIGHT_POINT);
    vec3 towards = ends ? XYZ(light.position) - point.from_first : XYZ(light.position);
    return dot(towards, point.normal) > real(0) && !isShaded(point, XYZ(light.position), ends, -1, searches);
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

// The nearest hit, and its light if that is wanted.
Gathered gatherDirect(const Segment segment) {
    Gathered result = nothingGathered();
    result.point = nearestHit(segment);
    result.searches.doubtful = result.point.doubtful;
    if (kWantsLight && result.point.hit && !result.searches.doubtful) {
        result.albedo = albedoOf(result.point);
        result.lit = kShadows == 0 ? ~0u : visibleLights(result.point, result.searches);
        result.colour = directLight(result.point, result.albedo, result.lit);
    }
    return result;
}

// Of one of a list's rays, by its own `key`: see shade_paths.
Gathered gatherListed(const Segment segment, const uint key) {
    return gatherDirect(segment);
}
