// Paths of light from the camera: docs/light.md. Expects shade.glsl, material.glsl and light.glsl.

// Decisions at a path's vertex n: pairs 64 n + ...
const uint kPairsPerVertex = 64u;
const uint kPairDirection = 1u;
const uint kPairLobe = 2u;   // and roulette
const uint kPairChoice = 3u;  // of one light
const uint kPairLights = 4u;

const int kRouletteFrom = 4;

// The sample numbers of one path.
struct Numbers {
    uint key;
    int index;
};

vec2 numbersAt(const Numbers numbers, const int vertex, const uint pair) {
    return samplePoint(numbers.key, numbers.index, uint(vertex) * kPairsPerVertex + pair);
}

// The place in the filter, about the pixel's centre.
vec2 filterPlace(const vec2 u) {
    if (kGaussian == 0) return vec2(kRadiusX, kRadiusY) * (2.0 * u - 1.0);
    vec2 place = u * float(FILTER_INTERVALS);
    ivec2 i = ivec2(place);
    vec2 t = place - vec2(i);
    int second = FILTER_INTERVALS + 1;
    return vec2(mix(tables[i.x], tables[i.x + 1], t.x), mix(tables[second + i.y], tables[second + i.y + 1], t.y));
}

// A vertex of the path: the hit and its material, made ready.
struct Vertex {
    SurfacePoint point;
    MaterialData material;
    vec3 colour;
    Basis basis;  // about the shading normal
    vec3 view;    // in it, towards where the ray came from
};

// `softened`: after another reflection than mirrors'.
Vertex makeVertex(const SurfacePoint point, const vec3 colour, const bool softened) {
    Vertex vertex;
    vertex.point = point;
    vertex.material = materials[point.object + (kRegularize != 0 && softened ? MAX_OBJECTS : 0)];
    vertex.colour = colour;
    vec3 view = point.inside ? point.normal : normalize(-point.towards);
    vec3 normal = shadingNormal(point);
    vertex.basis = basisAbout(normal);
    vertex.view = intoBasis(vertex.basis, view);
    return vertex;
}

// Nothing below the facet's own horizon.
Scattering scatterTowards(const Vertex vertex, const vec3 direction) {
    vec3 light = intoBasis(vertex.basis, direction);
    Scattering result = scatter(vertex.material, vertex.colour, vertex.view, light);
    float cosine = dot(vertex.point.normal, direction);
    if (cosine <= 0.0) result.value = vec3(0.0);
#ifdef WITH_CURVED
    result.value *= terminatorShare(cosine, light.z, dot(vertex.point.normal, vertex.basis.z));
#endif
    return result;
}

// Whether anything but the light itself stands between P' and the sample.
bool isVisible(const SurfacePoint point, const LightData light, const LightSample light_sample, inout bool doubtful) {
    return !isShaded(point, light_sample.place, light_sample.ends, light.object, doubtful);
}

float powerWeight(const float own, const float other) {
    return own * own / (own * own + other * other);
}

// How a sample of the picture is gathered.
struct Rules {
    bool centre;    // direct light alone, each light by its own sample, whose shadows are wanted even where it is dark
    bool shadowed;  // else light passes through everything
    bool weighed;   // paths may meet the lights too
};

// Light k's share of what leaves the vertex, and whether its sample is `seen`. `chance`: of this light's being asked.
vec3 lightThrough(const Vertex vertex, const int k, const vec2 u, const float chance, const Rules rules, out bool seen,
                  inout bool doubtful) {
    LightData light = lights[k];
    SurfacePoint point = vertex.point;
    LightSample light_sample = sampleLight(light, point.from_first, point.normal, u);
    vec3 towards = light_sample.ends ? light_sample.place - point.from_first : light_sample.place;
    vec3 direction = normalize(towards);
    Scattering scattering = scatterTowards(vertex, direction);
    vec3 result = scattering.value * light_sample.radiance / chance;
    if (rules.weighed && light_sample.density > 0.0) result *= powerWeight(light_sample.density * chance, scattering.density);
    seen = dot(point.normal, direction) > 0.0 && light.object != point.object;
    if (seen && rules.shadowed && (rules.centre || max(result.x, max(result.y, result.z)) > 0.0))
        seen = isVisible(point, light, light_sample, doubtful);
    return seen ? result : vec3(0.0);
}

// The light drawn for a path's later vertices.
int drawnLight(const float u) {
    int k = 0;
    for (int i = 0; i + 1 < kLightCount; ++i) k = u >= lights[i].shares ? i + 1 : k;
    return k;
}

// Where the material's sample was taken, for what the path meets next.
struct Departure {
    vec3 normal;
    float density;  // 0: the sample has no rival
    bool from_camera_hit;
};

// What the hit, or the distance, sends back along the path.
vec3 emitted(const SurfacePoint point, const vec3 direction, const Departure departure) {
    vec3 sum = vec3(0.0);
    for (int k = 0; k < kLightCount; ++k) {
        LightData light = lights[k];
        bool is_surface = light.object >= 0;
        if (point.hit ? !(is_surface && light.object == point.object) : !isInfinite(light)) continue;
        Emission emission;
        if (is_surface)
            emission = surfaceEmission(light, point.from_first - point.towards, point.towards, point.normal);
        else
            emission = infiniteEmission(light, departure.normal, direction);
        float rival = emission.density * (departure.from_camera_hit ? 1.0 : light.share);
        sum += emission.radiance * (departure.density > 0.0 ? powerWeight(departure.density, rival) : 1.0);
    }
    return sum;
}

// A picture's sample, or the planes of its centre.
struct Gathered {
    SurfacePoint point;  // that the camera's ray met
    vec3 albedo, colour;
    uint lit;
    bool doubtful;
};

Gathered gather(Segment segment, const Numbers numbers, const Rules rules) {
    Gathered result;
    result.albedo = vec3(0.0);
    result.colour = vec3(0.0);
    result.lit = 0u;
    result.doubtful = false;
    vec3 throughput = vec3(1.0);
    Departure departure;
    departure.normal = vec3(0.0, 0.0, 1.0);
    departure.density = 0.0;
    departure.from_camera_hit = false;
    int last = rules.centre ? 0 : kMaxDepth;
    bool going = true;
    bool softened = false;
    for (int n = 0; n <= last && going; ++n) {
        SurfacePoint point = nearestHit(segment);
        result.doubtful = result.doubtful || point.doubtful;
        if (n == 0) result.point = point;
        going = !result.doubtful && kWantsLight;
        if (going && sceneHasMetLights())
            result.colour += throughput * emitted(point, segmentDirection(segment), departure);
        going = going && point.hit;
        if (!going) continue;
        Vertex vertex = makeVertex(point, albedoOf(point), softened);
        if (n == 0) result.albedo = vertex.colour;
        if (n >= kMaxDepth && !rules.centre) continue;

        float draw = n == 0 ? 0.0 : numbersAt(numbers, n, kPairChoice).x;
        bool all = n == 0 || kDiffusePaths == 0;
        int asked = all ? kLightCount : min(kLightCount, 1);
        for (int i = 0; i < asked; ++i) {
            int k = all ? i : drawnLight(draw);
            vec2 u = numbersAt(numbers, n, kPairLights + uint(k));
            bool seen = false;
            vec3 light = lightThrough(vertex, k, u, all ? 1.0 : lights[k].share, rules, seen, result.doubtful);
            result.colour += throughput * light;
            if (n == 0 && seen) result.lit |= 1u << k;
        }

        vec2 lobe = numbersAt(numbers, n, kPairLobe);
        vec3 local = sampleMaterial(vertex.material, vertex.view, numbersAt(numbers, n, kPairDirection), lobe.x);
        segment.direction = outOfBasis(vertex.basis, local);
        bool mirrored = isMaterial(vertex.material, MATERIAL_MIRROR);
        if (mirrored) {
            throughput *= vertex.material.specular.rgb;
            departure.density = 0.0;
            going = local.z > 0.0 && dot(point.normal, segment.direction) > 0.0;
        } else {
            Scattering scattering = scatterTowards(vertex, segment.direction);
            throughput *= scattering.density > 0.0 ? scattering.value / scattering.density : vec3(0.0);
            departure.density = scattering.density;
            softened = true;
            going = kDiffusePaths != 0 && max(throughput.x, max(throughput.y, throughput.z)) > 0.0;
        }
        if (n >= kRouletteFrom) {
            float chance = min(max(throughput.x, max(throughput.y, throughput.z)), 0.95);
            going = going && lobe.y < chance;
            throughput /= max(chance, 1e-6);
        }
        going = going && !result.doubtful;
        departure.normal = point.normal;
        departure.from_camera_hit = n == 0;
        segment.camera = false;
        segment.clear = -kInfinity;
        segment.object = point.object;
        segment.level = point.level;
        segment.start = point.start;
        segment.from_first = point.from_first;
    }
    float greatest = max(result.colour.x, max(result.colour.y, result.colour.z));
    if (kClamp > 0.0 && !rules.centre && greatest > kClamp) result.colour *= kClamp / greatest;
    return result;
}
