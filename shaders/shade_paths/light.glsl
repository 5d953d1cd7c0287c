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
    real density;  // 0: of a light that no path meets
};

// The cone that a sphere fills, seen from outside.
struct Cone {
    vec3 axis;
    real distance, versin;  // versin: 1 - cos of its half angle; 0 from inside
};

Cone coneOf(const LightData light, const vec3 from_first) {
    vec3 towards = XYZ(light.position) - from_first;
    Cone cone;
    cone.distance = length(towards);
    cone.axis = towards / cone.distance;
    real sine2 = real(light.measure) * real(light.measure) / (cone.distance * cone.distance);
    cone.versin = sine2 < real(1) ? sine2 / (real(1) + sqrt(real(1) - sine2)) : real(0);
    return cone;
}

LightSample sampleSphere(const LightData light, const vec3 from_first, const vec2 u) {
    Cone cone = coneOf(light, from_first);
    real versin = u.x * cone.versin;
    real sine2 = versin * (real(2) - versin);
    real sine = sqrt(sine2);
    real angle = real(2) * kPi * u.y;
    vec3 direction =
        outOfBasis(basisAbout(cone.axis), vec3(sine * cos(angle), sine * sin(angle), real(1) - versin));
    real half_chord = sqrt(max(real(light.measure) * real(light.measure) - cone.distance * cone.distance * sine2, real(0)));
    LightSample result;
    result.ends = true;
    result.place = from_first + (cone.distance * (real(1) - versin) - half_chord) * direction;
    result.radiance = XYZ(light.radiance) * (real(2) * kPi * cone.versin);
    result.density = cone.versin > real(0) ? real(1) / (real(2) * kPi * cone.versin) : real(0);
    return result;
}

// Squared distance over the cosine at the disk and its area; 0 where it does not shine.
real diskDensity(const LightData light, const vec3 towards) {
    real square = dot(towards, towards);
    real cosine = -dot(XYZ(light.z_axis), towards) * inversesqrt(square);
    cosine = light.two_sided != 0 ? abs(cosine) : cosine;
    return cosine > real(0) ? square / (cosine * real(light.measure)) : real(0);
}

LightSample sampleDisk(const LightData light, const vec3 from_first, const vec2 u) {
    real radius = sqrt(mix(real(light.inner_squared), real(1), u.x));
    real angle = real(2) * kPi * u.y;
    LightSample result;
    result.ends = true;
    result.place = XYZ(light.position) + radius * (cos(angle) * XYZ(light.x_axis) + sin(angle) * XYZ(light.y_axis));
    result.density = diskDensity(light, result.place - from_first);
    result.radiance = result.density > real(0) ? finiteLight(XYZ(light.radiance) / result.density) : vec3(real(0));
    return result;
}

LightSample sampleInfinite(const LightData light, const vec3 normal, const vec2 u) {
    vec3 local = cosineDirection(u);
    LightSample result;
    result.ends = false;
    result.place = outOfBasis(basisAbout(normal), local);
    result.density = local.z / kPi;
    result.radiance = local.z > real(0) ? XYZ(light.radiance) / result.density : vec3(real(0));
    return result;
}

// The last of `count` cells whose distribution starts at u or below it.
int findCell(const int first, const int count, const real u) {
    int low = 0;
    int high = count;
    for (int step = 0; step < 16 && high - low > 1; ++step) {
        int middle = (low + high) >> 1;
        bool above = real(tables[first + middle]) <= u;
        low = above ? middle : low;
        high = above ? high : middle;
    }
    return low;
}

// Where u lies within that cell.
real withinCell(const int first, const int cell, const real u) {
    real start = real(tables[first + cell]);
    real width = real(tables[first + cell + 1]) - start;
    return width > real(0) ? (u - start) / width : real(0.5);
}

vec3 environmentTexel(const LightData light, const int column, const int row) {
    int y = clamp(row, 0, light.height - 1);
    int x = column < 0 ? column + light.width : (column >= light.width ? column - light.width : column);
    return placedTexel(light.image, x, light.image_y + y, light.image_layer, light.height);
}

// `place`: turns from the image's left edge, share of its height from the top.
vec3 environmentAt(const LightData light, const vec2 place) {
    vec2 texel = place * vec2(light.width, light.height) - real(0.5);
    vec2 corner = floor(texel);
    vec2 t = texel - corner;
    int x = int(corner.x);
    int y = int(corner.y);
    vec3 above = mix(environmentTexel(light, x, y), environmentTexel(light, x + 1, y), t.x);
    vec3 below = mix(environmentTexel(light, x, y + 1), environmentTexel(light, x + 1, y + 1), t.x);
    return XYZ(light.radiance) * mix(above, below, t.y);
}

// `sine` of the angle from the image's pole.
real environmentDensity(const LightData light, const ivec2 texel, const real sine) {
    // Not a difference of rounded sums: those of faint texels would have few bits left.
    int densities = light.table + light.height + 1 + light.height * (light.width + 1);
    return real(tables[densities + texel.y * light.width + texel.x]) / (real(2) * kPi * kPi * max(sine, real(1e-7)));
}

LightSample sampleEnvironment(const LightData light, const vec2 u) {
    ivec2 texel;
    texel.y = findCell(light.table, light.height, u.y);
    int row_table = light.table + light.height + 1 + texel.y * (light.width + 1);
    texel.x = findCell(row_table, light.width, u.x);
    vec2 place = (vec2(texel) + vec2(withinCell(row_table, texel.x, u.x), withinCell(light.table, texel.y, u.y))) /
                 vec2(light.width, light.height);
    real azimuth = real(2) * kPi * place.x;
    real polar = kPi * place.y;
    real sine = sin(polar);
    vec3 local = vec3(cos(azimuth) * sine, sin(azimuth) * sine, cos(polar));
    LightSample result;
    result.ends = false;
    result.place = local.x * XYZ(light.x_axis) + local.y * XYZ(light.y_axis) + local.z * XYZ(light.z_axis);
    result.density = environmentDensity(light, texel, sine);
    result.radiance = result.density > real(0) ? environmentAt(light, place) / result.density : vec3(real(0));
    return result;
}

LightSample sampleDelta(const LightData light, const vec3 from_first) {
    LightSample result;
    result.place = XYZ(light.position);
    result.ends = isLight(light, LIGHT_POINT);
    vec3 towards = XYZ(light.position) - from_first;
    result.radiance = finiteLight(XYZ(light.radiance) / (result.ends ? dot(towards, towards) : real(1)));
    result.density = real(0);
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
    real density;
};

Emission infiniteEmission(const LightData light, const vec3 normal, const vec3 direction) {
    Emission result;
    if (isAmong(light.kind, LIGHT_INFINITE, kLightKinds & kInfiniteKinds)) {
        result.radiance = XYZ(light.radiance);
        result.density = max(dot(normal, direction), real(0)) / kPi;
        return result;
    }
    vec3 local = vec3(dot(XYZ(light.x_axis), direction), dot(XYZ(light.y_axis), direction), dot(XYZ(light.z_axis), direction));
    real sine = length(XY(local));
    real u = atan2Precise(local.y, local.x) / (real(2) * kPi);
    vec2 place = vec2(u < real(0) ? u + real(1) : u, atan2Precise(sine, local.z) / kPi);
    ivec2 texel = min(ivec2(place * vec2(light.width, light.height)), ivec2(light.width - 1, light.height - 1));
    result.radiance = environmentAt(light, place);
    result.density = environmentDensity(light, texel, sine);
    return result;
}

// Of the light's own surface, met in that direction `towards` from `from_first`; nothing from its dark side.
Emission surfaceEmission(const LightData light, const vec3 from_first, const vec3 towards, const vec3 normal) {
    Emission result;
    result.radiance = vec3(real(0));
    result.density = real(0);
    if (isAmong(light.kind, LIGHT_SPHERE, kLightKinds & kAreaKinds)) {
        Cone cone = coneOf(light, from_first);
        bool outside = dot(normal, towards) < real(0);
        result.radiance = outside ? XYZ(light.radiance) : vec3(real(0));
        result.density = cone.versin > real(0) ? real(1) / (real(2) * kPi * cone.versin) : real(0);
    } else {
        bool shines = light.two_sided != 0 || dot(XYZ(light.z_axis), towards) < real(0);
        result.radiance = shines ? XYZ(light.radiance) : vec3(real(0));
        result.density = diskDensity(light, towards);
    }
    return result;
}
