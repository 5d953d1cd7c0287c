// The scene's nearest hit, its shadows and direct light. Loops over objects and lights have the bounds of the scene.

// The nearest hit, made ready for shading. World space unless said otherwise.
struct SurfacePoint {
    bool hit, inside, exhausted;
    int object, steps;
    float t;
    vec3 position, normal;
    vec3 object_position, start;  // object space, units of R; start: P', where secondary rays begin
    vec3 albedo;
    float h;  // height on the ramp
    int ramp;
    float residual;
};

SurfacePoint nearestHit(vec2 raster, vec2 jitter) {
    SurfacePoint best;
    best.hit = false;
    best.inside = false;
    best.exhausted = false;
    best.object = -1;
    best.steps = 0;
    best.t = kInfinity;
    for (int k = 0; k < kObjectCount; ++k) {
        ObjectData object = objects[k];
        MapData map = maps[k];
        vec2 pixel = raster - vec2(object.anchor_x, object.anchor_y);
        ObjectHit hit = hitObject(object, map, cameraRay(object, pixel, jitter));
        best.steps += hit.steps;
        best.exhausted = best.exhausted || hit.exhausted;
        float t = hit.inside ? 0.0 : cameraDistance(object, hit.p, pixel + jitter);
        if (hit.hit && t < best.t) {
            best.hit = true;
            best.inside = hit.inside;
            best.object = k;
            best.t = t;
            best.position = worldFromObjectPoint(object, hit.p);
            best.normal = worldNormal(object, hit.n);
            best.object_position = hit.p;
            best.start = hit.p + startOffset(object) * hit.n;
            best.albedo = object.albedo.rgb;
            best.h = object.ramp_offset + object.ramp_scale * hit.stored;
            best.ramp = object.ramp;
            best.residual = abs(hit.residual);
        }
    }
    return best;
}

vec3 albedoOf(SurfacePoint point) {
    if (point.ramp < 0) return point.albedo;
    float place = clamp(point.h, 0.0, 1.0) * float(RAMP_POINTS - 1);
    int k = min(int(place), RAMP_POINTS - 2);
    int first = point.ramp * RAMP_POINTS + k;
    return mix(ramp_points[first].rgb, ramp_points[first + 1].rgb, place - float(k));
}

// Whether light k is seen from P'.
bool isLit(SurfacePoint point, LightData light) {
    bool ends = light.position.w > 0.5;
    vec3 towards = ends ? light.position.xyz - point.position : light.position.xyz;
    bool lit = dot(towards, point.normal) > 0.0;
    for (int k = 0; k < kObjectCount && lit; ++k) {
        ObjectData object = objects[k];
        MapData map = maps[k];
        bool own = k == point.object;
        vec3 start = point.start;
        if (!own) start = objectFromWorldPoint(object, worldFromObjectPoint(objects[point.object], point.start));
        vec3 offset = ends ? objectFromWorldPoint(object, light.position.xyz) - start
                           : objectFromWorldVector(object, light.position.xyz);
        lit = !blocks(object, map, secondaryRay(start, offset, ends));
    }
    return lit;
}

uint visibleLights(SurfacePoint point) {
    uint mask = 0u;
    for (int k = 0; k < kLightCount; ++k) mask |= isLit(point, lights[k]) ? 1u << k : 0u;
    return mask;
}

// Lambert: albedo / pi times the irradiance of the visible lights.
vec3 directLight(SurfacePoint point, vec3 albedo, uint lit) {
    vec3 sum = vec3(0.0);
    for (int k = 0; k < kLightCount; ++k) {
        if ((lit & (1u << k)) == 0u) continue;
        LightData light = lights[k];
        vec3 towards = light.position.xyz - light.position.w * point.position;
        float square = dot(towards, towards);
        float cosine = max(dot(towards, point.normal) * inversesqrt(square), 0.0);
        sum += light.radiance.rgb * (light.position.w > 0.5 ? cosine / square : cosine);
    }
    return albedo * sum / kPi;
}
