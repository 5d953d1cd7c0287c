// Direct light on Lambertian surfaces from distant and point lights. Expects shade.glsl.

// Whether the light is seen from P'. `doubtful` is set where another precision must decide.
bool isLit(SurfacePoint point, LightData light, inout bool doubtful) {
    bool ends = light.position.w > 0.5;
    vec3 towards = ends ? light.position.xyz - point.from_first : light.position.xyz;
    bool lit = dot(towards, point.normal) > 0.0;
    for (int k = 0; k < kObjectCount && lit; ++k) lit = !shades(k, point, light.position.xyz, ends, doubtful);
    return lit;
}

uint visibleLights(SurfacePoint point, inout bool doubtful) {
    uint mask = 0u;
    for (int k = 0; k < kLightCount; ++k) mask |= isLit(point, lights[k], doubtful) ? 1u << k : 0u;
    return mask;
}

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
