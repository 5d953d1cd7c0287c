// Paths of light from the camera: docs/light.md. Expects shade.glsl, material.glsl and light.glsl.

// Decisions at a path's vertex n: pairs 64 n + ...
const uint kPairsPerVertex = 64u;
const uint kPairDirection = 1u;
const uint kPairLobe = 2u;   // and roulette
const uint kPairChoice = 3u;  // of one light
const uint kPairLights = 4u;

// Russian roulette from vertex 1 on: before kRouletteFrom it ends only paths whose light counts for less than kSureThroughput of the
// picture's, so that noise hardly grows (docs/notebook.md).
const int kRouletteFrom = 4;
const real kSureThroughput = real(1.0 / 4.0);

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
    if (kFilter == FILTER_BOX) return vec2(kRadiusX, kRadiusY) * (real(2) * u - real(1));
    vec2 place = u * real(FILTER_INTERVALS);
    ivec2 i = ivec2(place);
    vec2 t = place - vec2(i);
    int second = FILTER_INTERVALS + 1;
    return vec2(mix(real(tables[i.x]), real(tables[i.x + 1]), t.x), mix(real(tables[second + i.y]), real(tables[second + i.y + 1]), t.y));
}

// How much the sample at filterPlace(u) counts.
real filterWeight(const vec2 u) {
    if (kFilter != FILTER_SIGNED) return real(1);
    ivec2 i = ivec2(u * real(FILTER_INTERVALS)) + 2 * (FILTER_INTERVALS + 1);
    return real(tables[i.x]) * real(tables[FILTER_INTERVALS + i.y]);
}

// A vertex of the path: the hit and its material, made ready.
struct Vertex {
    SurfacePoint point;
    MaterialData material;
    vec3 colour;
    Basis basis;  // about the shading normal
    vec3 view;    // in it, towards where the ray came from
};

// `direction`: of the ray, unit; from nearby it is known better than the way from its start to the hit. `softened`: after another
// reflection than mirrors'.
Vertex makeVertex(const SurfacePoint point, const vec3 direction, const vec3 colour, const bool softened) {
    Vertex vertex;
    vertex.point = point;
    vertex.material = materials[point.object + (kRegularize != 0 && softened ? MAX_OBJECTS : 0)];
    vertex.colour = colour;
    // A camera on the surface itself is 0 away, and sees it from above.
    bool apart = !point.inside && dot(point.towards, point.towards) > real(0);
    vec3 view = apart ? -direction : point.normal;
    vec3 normal = shadingNormal(point);
    vertex.basis = basisAbout(normal);
    vertex.view = intoBasis(vertex.basis, view);
    return vertex;
}

// Nothing below the facet's own horizon.
Scattering scatterTowards(const Vertex vertex, const vec3 direction) {
    vec3 light = intoBasis(vertex.basis, direction);
    Scattering result = scatter(vertex.material, vertex.colour, vertex.view, light);
    real cosine = dot(vertex.point.normal, direction);
    if (cosine <= real(0)) result.value = vec3(real(0));
    if (kCurved) result.value *= terminatorShare(cosine, light.z, dot(vertex.point.normal, vertex.basis.z));
    return result;
}

// `own` > 0. Neither is squared: densities of grazing directions are large.
real powerWeight(const real own, const real other) {
    real ratio = other / own;
    return real(1) / (real(1) + ratio * ratio);
}

// How a sample of the picture is gathered.
struct Rules {
    bool centre;    // direct light alone, each light by its own sample, whose shadows are wanted even where it is dark
    bool shadowed;  // else horizonShare() stands in for shadow rays
    bool weighed;   // paths may meet the lights too
};

// Light k's share of what leaves the vertex, and whether its sample is `seen`. `chance`: of this light's being asked.
vec3 lightThrough(const Vertex vertex, const int k, const vec2 u, const real chance, const Rules rules, OUT(bool) seen,
                  INOUT(Searches) searches) {
    LightData light = lights[k];
    SurfacePoint point = vertex.point;
    LightSample light_sample = sampleLight(light, point.from_first, point.normal, u);
    vec3 towards = light_sample.ends ? light_sample.place - point.from_first : light_sample.place;
    vec3 direction = normalize(towards);
    Scattering scattering = scatterTowards(vertex, direction);
    vec3 result = scattering.value * light_sample.radiance / chance;
    if (rules.weighed && light_sample.density > real(0)) result *= powerWeight(light_sample.density * chance, scattering.density);
    int shining = (kLightKinds & kAreaKinds) != 0 ? light.object : -1;
    seen = dot(point.normal, direction) > real(0) && shining != point.object;
    if (seen && rules.shadowed && (rules.centre || max(result.x, max(result.y, result.z)) > real(0)))
        seen = !isShaded(point, light_sample.place, light_sample.ends, shining, searches);
    if (kShadows == 0 && !isInfinite(light)) result *= horizonShare(point, direction);
    return seen ? result : vec3(real(0));
}

// The light drawn for a path's later vertices.
int drawnLight(const real u) {
    int k = 0;
    for (int i = 0; i + 1 < kLightCount; ++i) k = u >= real(lights[i].shares) ? i + 1 : k;
    return k;
}

// Where the material's sample was taken, for what the path meets next.
struct Departure {
    vec3 normal;
    real density;  // 0: the sample has no rival
    bool from_camera_hit;
};

// What is seen of a light, weighed against its samples.
vec3 weighed(const Emission emission, const LightData light, const Departure departure) {
    real rival = emission.density * (departure.from_camera_hit ? real(1) : real(light.share));
    return emission.radiance * (departure.density > real(0) ? powerWeight(departure.density, rival) : real(1));
}

vec3 emittedBySurface(const SurfacePoint point, const Departure departure) {
    int k = materials[point.object].light;
    if (k < 0) return vec3(real(0));
    LightData light = lights[k];
    return weighed(surfaceEmission(light, point.from_first - point.towards, point.towards, point.normal), light, departure);
}

// What the hit, or the distance, sends back along the path.
vec3 emitted(const SurfacePoint point, const vec3 direction, const Departure departure) {
    vec3 result = vec3(real(0));
    if ((kLightKinds & kInfiniteKinds) != 0 && !point.hit)
        result = weighed(infiniteEmission(infinite_light, departure.normal, direction), infinite_light, departure);
    if ((kLightKinds & kAreaKinds) != 0 && point.hit) result = emittedBySurface(point, departure);
    return result;
}

// A path on its way.
struct Path {
    Gathered result;
    Segment segment;  // the ray to come
    Numbers numbers;
    Departure departure;
    vec3 throughput;
    int vertices;  // so far
    bool going, softened;
};

Path startPath(const Segment segment, const Numbers numbers, const bool going) {
    Path path;
    path.result = nothingGathered();
    path.segment = segment;
    path.numbers = numbers;
    path.departure.normal = vec3(real(0), real(0), real(1));
    path.departure.density = real(0);
    path.departure.from_camera_hit = false;
    path.throughput = vec3(real(1));
    path.vertices = 0;
    path.going = going;
    path.softened = false;
    return path;
}

// Light straight from the lights: all of them at the first vertex, one that is drawn at others.
void gatherLights(INOUT(Path) path, const Vertex vertex, const Rules rules) {
    const int n = path.vertices;
    real draw = n == 0 ? real(0) : numbersAt(path.numbers, n, kPairChoice).x;
    bool all = n == 0 || kDiffusePaths == 0;
    if (kLightCount == 0) return;
    int asked = all ? kLightCount : 1;
    for (int i = 0; i < asked; ++i) {
        int k = all ? i : drawnLight(draw);
        vec2 u = numbersAt(path.numbers, n, kPairLights + uint(k));
        bool seen = false;
        vec3 light = lightThrough(vertex, k, u, all ? real(1) : real(lights[k].share), rules, seen, path.result.searches);
        path.result.colour += path.throughput * light;
        if (n == 0 && seen) path.result.lit |= 1u << k;
        if (i + 1 >= asked) break;
    }
}

// Turns the path to where the material reflects it, if anywhere.
void reflectPath(INOUT(Path) path, const Vertex vertex) {
    const int n = path.vertices;
    vec2 lobe = numbersAt(path.numbers, n, kPairLobe);
    vec3 local = sampleMaterial(vertex.material, vertex.view, numbersAt(path.numbers, n, kPairDirection), lobe.x);
    path.segment.direction = outOfBasis(vertex.basis, local);
    if (isMaterial(vertex.material, MATERIAL_MIRROR)) {
        path.throughput *= XYZ(vertex.material.specular);
        path.departure.density = real(0);
        path.going = local.z > real(0) && dot(vertex.point.normal, path.segment.direction) > real(0);
    } else {
        Scattering scattering = scatterTowards(vertex, path.segment.direction);
        path.throughput *= scattering.density > real(0) ? scattering.value / scattering.density : vec3(real(0));
        path.departure.density = scattering.density;
        path.softened = true;
        path.going = kDiffusePaths != 0 && max(path.throughput.x, max(path.throughput.y, path.throughput.z)) > real(0);
    }
    if (kDiffusePaths != 0 && n > 0) {
        real greatest = max(path.throughput.x, max(path.throughput.y, path.throughput.z));
        real chance = n < kRouletteFrom ? min(greatest / kSureThroughput, real(1)) : min(greatest, real(0.95));
        path.going = path.going && lobe.y < chance;
        path.throughput /= max(chance, real(1e-6));
    }
    path.departure.normal = vertex.point.normal;
    path.departure.from_camera_hit = n == 0;
    path.segment.camera = false;
    path.segment.safe_s = -kInfinity;
    path.segment.object = vertex.point.object;
    path.segment.level = vertex.point.level;
    path.segment.start = vertex.point.start;
    path.segment.world_start = vertex.point.world_start;
    path.segment.from_first = vertex.point.from_first;
}

// The next vertex of a path that is going. The planes of a centre need its first alone.
void extendPath(INOUT(Path) path, const Rules rules) {
    const int n = path.vertices;
    vec3 direction = segmentDirection(path.segment);
    SurfacePoint point = nearestHit(path.segment);
    path.result.searches.doubtful = path.result.searches.doubtful || point.doubtful;
    path.result.searches.steps += point.steps;
    if (n == 0) path.result.point = point;
    path.going = !path.result.searches.doubtful && kWantsLight;
    bool hidden = kHideDistance != 0 && n == 0 && !point.hit;
    if (path.going && sceneHasMetLights() && !hidden)
        path.result.colour += path.throughput * emitted(point, direction, path.departure);
    path.going = path.going && point.hit;
    if (path.going) {
        Vertex vertex = makeVertex(point, direction, albedoOf(point), path.softened);
        if (n == 0) path.result.albedo = vertex.colour;
        path.going = n < kMaxDepth || rules.centre;
        if (path.going) {
            gatherLights(path, vertex, rules);
            reflectPath(path, vertex);
            path.going = path.going && !path.result.searches.doubtful && n < (rules.centre ? 0 : kMaxDepth);
        }
    }
    path.vertices = n + 1;
}

Gathered resultOf(const Path path, const Rules rules) {
    Gathered result = path.result;
    real greatest = max(result.colour.x, max(result.colour.y, result.colour.z));
    if (kClamp > real(0) && !rules.centre && greatest > kClamp) result.colour *= kClamp / greatest;
    if (!rules.centre) result.weight = filterWeight(numbersAt(path.numbers, 0, 0u));
    result.colour *= result.weight;
    return result;
}
