// Samples of lights, and what is seen of them: docs/light.md. Expects kLightKinds (a bit per LIGHT_ of the scene) and the
// tables. Densities are per solid angle.

const int kInfiniteKinds = 1 << LIGHT_INFINITE | 1 << LIGHT_IMAGE;
const int kAreaKinds = 1 << LIGHT_SPHERE | 1 << LIGHT_DISK;

// Whether the scene has lights that a path can meet by itself.
bool sceneHasMetLights() {
    return (kLightKinds & (kInfiniteKinds | kAreaKinds)) != 0;
}

bool isInfinite(const LightData light) {
    return isLight(light, LIGHT_INFINITE) || isLight(light, LIGHT_IMAGE);
}

// Light that comes to P: from `place`, seen from object 0's centre, if it `ends` there, else from the direction `place`.
struct LightSample {
    vec3 place;
    bool ends;
    vec3 radiance;  // divided by the density; 0: nothing comes
    float density;  // 0: of a light that no path meets
};

// The cone that a sphere fills, seen from outside.
struct Cone {
    vec3 axis;
    float distance, versin;  // versin: 1 - cos of its half angle; 0 from inside
};

Cone coneOf(const LightData light, const vec3 from_first) {
    vec3 towards = light.position.xyz - from_first;
    Cone cone;
    cone.distance = length(towards);
    cone.axis = towards / cone.distance;
    float sine2 = light.measure * light.measure / (cone.distance * cone.distance);
    cone.versin = sine2 < 1.0 ? sine2 / (1.0 + sqrt(1.0 - sine2)) : 0.0;
    return cone;
}

LightSample sampleSphere(const LightData light, const vec3 from_first, const vec2 u) {
    Cone cone = coneOf(light, from_first);
    float versin = u.x * cone.versin;
    float sine2 = versin * (2.0 - versin);
    float sine = sqrt(sine2);
    float angle = 2.0 * kPi * u.y;
    vec3 direction =
        outOfBasis(basisAbout(cone.axis), vec3(sine * cos(angle), sine * sin(angle), 1.0 - versin));
    float half_chord = sqrt(max(light.measure * light.measure - cone.distance * cone.distance * sine2, 0.0));
    LightSample result;
    result.ends = true;
    result.place = from_first + (cone.distance * (1.0 - versin) - half_chord) * direction;
    result.radiance = light.radiance.rgb * (2.0 * kPi * cone.versin);
    result.density = cone.versin > 0.0 ? 1.0 / (2.0 * kPi * cone.versin) : 0.0;
    return result;
}

// Squared distance over the cosine at the disk and its area; 0 where it does not shine.
float diskDensity(const LightData light, const vec3 towards) {
    float square = dot(towards, towards);
    float cosine = -dot(light.z_axis.xyz, towards) * inversesqrt(square);
    cosine = light.two_sided != 0 ? abs(cosine) : cosine;
    return cosine > 0.0 ? square / (cosine * light.measure) : 0.0;
}

LightSample sampleDisk(const LightData light, const vec3 from_first, const vec2 u) {
    float radius = sqrt(mix(light.inner_squared, 1.0, u.x));
    float angle = 2.0 * kPi * u.y;
    LightSample result;
    result.ends = true;
    result.place = light.position.xyz + radius * (cos(angle) * light.x_axis.xyz + sin(angle) * light.y_axis.xyz);
    result.density = diskDensity(light, result.place - from_first);
    result.radiance = result.density > 0.0 ? finiteLight(light.radiance.rgb / result.density) : vec3(0.0);
    return result;
}

LightSample sampleInfinite(const LightData light, const vec3 normal, const vec2 u) {
    vec3 local = cosineDirection(u);
    LightSample result;
    result.ends = false;
    result.place = outOfBasis(basisAbout(normal), local);
    result.density = local.z / kPi;
    result.radiance = local.z > 0.0 ? light.radiance.rgb / result.density : vec3(0.0);
    return result;
}

// The last of `count` cells whose distribution starts at u or below it.
int findCell(const int first, const int count, const float u) {
    int low = 0;
    int high = count;
    for (int step = 0; step < 16 && high - low > 1; ++step) {
        int middle = (low + high) >> 1;
        bool above = tables[first + middle] <= u;
        low = above ? middle : low;
        high = above ? high : middle;
    }
    return low;
}

// Where u lies within that cell.
float withinCell(const int first, const int cell, const float u) {
    float start = tables[first + cell];
    float width = tables[first + cell + 1] - start;
    return width > 0.0 ? (u - start) / width : 0.5;
}

vec3 environmentTexel(const LightData light, const int column, const int row) {
    int y = clamp(row, 0, light.height - 1);
    int x = column < 0 ? column + light.width : (column >= light.width ? column - light.width : column);
    return placedTexel(light.image, x, light.image_y + y, light.image_layer, light.height);
}

// `place`: turns from the image's left edge, share of its height from the top.
vec3 environmentAt(const LightData light, const vec2 place) {
    vec2 texel = place * vec2(light.width, light.height) - 0.5;
    vec2 corner = floor(texel);
    vec2 t = texel - corner;
    int x = int(corner.x);
    int y = int(corner.y);
    vec3 above = mix(environmentTexel(light, x, y), environmentTexel(light, x + 1, y), t.x);
    vec3 below = mix(environmentTexel(light, x, y + 1), environmentTexel(light, x + 1, y + 1), t.x);
    return light.radiance.rgb * mix(above, below, t.y);
}

// `sine` of the angle from the image's pole.
float environmentDensity(const LightData light, const ivec2 texel, const float sine) {
    // Not a difference of rounded sums: those of faint texels would have few bits left.
    int densities = light.table + light.height + 1 + light.height * (light.width + 1);
    return tables[densities + texel.y * light.width + texel.x] / (2.0 * kPi * kPi * max(sine, 1e-7));
}

LightSample sampleEnvironment(const LightData light, const vec2 u) {
    ivec2 texel;
    texel.y = findCell(light.table, light.height, u.y);
    int row_table = light.table + light.height + 1 + texel.y * (light.width + 1);
    texel.x = findCell(row_table, light.width, u.x);
    vec2 place = (vec2(texel) + vec2(withinCell(row_table, texel.x, u.x), withinCell(light.table, texel.y, u.y))) /
                 vec2(light.width, light.height);
    float turn = 2.0 * kPi * place.x;
    float polar = kPi * place.y;
    float sine = sin(polar);
    vec3 local = vec3(cos(turn) * sine, sin(turn) * sine, cos(polar));
    LightSample result;
    result.ends = false;
    result.place = local.x * light.x_axis.xyz + local.y * light.y_axis.xyz + local.z * light.z_axis.xyz;
    result.density = environmentDensity(light, texel, sine);
    result.radiance = result.density > 0.0 ? environmentAt(light, place) / result.density : vec3(0.0);
    return result;
}

LightSample sampleDelta(const LightData light, const vec3 from_first) {
    LightSample result;
    result.place = light.position.xyz;
    result.ends = isLight(light, LIGHT_POINT);
    vec3 towards = light.position.xyz - from_first;
    result.radiance = finiteLight(light.radiance.rgb / (result.ends ? dot(towards, towards) : 1.0));
    result.density = 0.0;
    return result;
}

LightSample sampleLight(const LightData light, const vec3 from_first, const vec3 normal, const vec2 u) {
    if (isLight(light, LIGHT_SPHERE)) return sampleSphere(light, from_first, u);
    if (isLight(light, LIGHT_DISK)) return sampleDisk(light, from_first, u);
    if (isLight(light, LIGHT_INFINITE)) return sampleInfinite(light, normal, u);
    if (isLight(light, LIGHT_IMAGE)) return sampleEnvironment(light, u);
    return sampleDelta(light, from_first);
}

// What is seen of a light in a direction, and the density of its samples there for a surface of that normal.
struct Emission {
    vec3 radiance;
    float density;
};

Emission infiniteEmission(const LightData light, const vec3 normal, const vec3 direction) {
    Emission result;
    if (isLight(light, LIGHT_INFINITE)) {
        result.radiance = light.radiance.rgb;
        result.density = max(dot(normal, direction), 0.0) / kPi;
        return result;
    }
    vec3 local = vec3(dot(light.x_axis.xyz, direction), dot(light.y_axis.xyz, direction), dot(light.z_axis.xyz, direction));
    float sine = length(local.xy);
    float turn = atan2Precise(local.y, local.x) / (2.0 * kPi);
    vec2 place = vec2(turn < 0.0 ? turn + 1.0 : turn, atan2Precise(sine, local.z) / kPi);
    ivec2 texel = min(ivec2(place * vec2(light.width, light.height)), ivec2(light.width - 1, light.height - 1));
    result.radiance = environmentAt(light, place);
    result.density = environmentDensity(light, texel, sine);
    return result;
}

// Of the light's own surface, met in that direction `towards` from `from_first`; nothing from its dark side.
Emission surfaceEmission(const LightData light, const vec3 from_first, const vec3 towards, const vec3 normal) {
    Emission result;
    result.radiance = vec3(0.0);
    result.density = 0.0;
    if (isLight(light, LIGHT_SPHERE)) {
        Cone cone = coneOf(light, from_first);
        bool outside = dot(normal, towards) < 0.0;
        result.radiance = outside ? light.radiance.rgb : vec3(0.0);
        result.density = cone.versin > 0.0 ? 1.0 / (2.0 * kPi * cone.versin) : 0.0;
    } else {
        bool shines = light.two_sided != 0 || dot(light.z_axis.xyz, towards) < 0.0;
        result.radiance = shines ? light.radiance.rgb : vec3(0.0);
        result.density = diskDensity(light, towards);
    }
    return result;
}
