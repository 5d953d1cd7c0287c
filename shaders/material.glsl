// What surfaces reflect, in the basis of the shading normal: docs/light.md. Expects kMaterials (a bit per MATERIAL_ of the
// scene: the others are compiled away) and the tables.

const float kPlasticIndex = 1.5;

bool sceneHasMaterial(const int kind) {
    return (kMaterials & (1 << kind)) != 0;
}

bool isMaterial(const MaterialData material, const int kind) {
    return kMaterials == 1 << kind || (sceneHasMaterial(kind) && material.kind == kind);
}

// The reflected share of light from a direction, times its cosine, and the density at which sampleMaterial finds it.
struct Scattering {
    vec3 value;
    float density;
};

// 1 - E: the light that facets of F = 1 do not reflect at once. Cubic (Catmull and Rom) between values at the squares of
// equal steps, the first of them beyond 0.
float facetLoss(const MaterialData material, const float cosine) {
    float place = sqrt(clamp(cosine, 0.0, 1.0)) * float(LOSS_INTERVALS);
    int i = min(int(place), LOSS_INTERVALS - 1);
    float t = place - float(i);
    int first = material.table + i;
    float a = tables[first];
    float b = tables[first + 1];
    float c = tables[first + 2];
    float d = tables[first + 3];
    return b + 0.5 * t * ((c - a) + t * ((2.0 * a - 5.0 * b + 4.0 * c - d) + t * (3.0 * (b - c) + (d - a))));
}

// Oren and Nayar's factor of Lambert's law.
float roughFactor(const MaterialData material, const vec3 view, const vec3 light) {
    if (view.z <= 0.0) return material.rough_a;
    float sine_view = length(view.xy);
    float sine_light = length(light.xy);
    float product = sine_view * sine_light;
    float cosine = product > 0.0 ? max(dot(view.xy, light.xy) / product, 0.0) : 0.0;
    // sin(alpha) tan(beta) of the greater and the lesser angle: the lesser has the greater cosine.
    return material.rough_a + material.rough_b * cosine * product / max(view.z, light.z);
}

Scattering diffuseScattering(const vec3 colour, const float factor, const vec3 light) {
    Scattering result;
    result.value = colour * (factor * light.z / kPi);
    result.density = light.z / kPi;
    return result;
}

// The share of samples that go by the facets. A viewer below the horizon of a smooth normal sees none.
float facetShare(const MaterialData material, const vec3 view) {
    if (view.z <= 0.0) return 0.0;
    return isMaterial(material, MATERIAL_CONDUCTOR) ? 1.0 - facetLoss(material, view.z) : 0.5;
}

// Facets above a diffuse rest: a conductor's is the light that bounces between them, a plastic's its colour.
Scattering facetScattering(const MaterialData material, const vec3 colour, const vec3 view, const vec3 light) {
    vec3 h = normalize(view + light);
    float facing = clamp(dot(light, h), 0.0, 1.0);
    float share = facetShare(material, view);
    vec3 fresnel;
    vec3 rest;
    if (isMaterial(material, MATERIAL_CONDUCTOR)) {
        fresnel = conductorFresnel(facing, material.eta.rgb, material.k.rgb);
        rest = material.bounced.rgb * (facetLoss(material, view.z) * facetLoss(material, light.z) * light.z);
    } else {
        fresnel = material.specular.rgb * dielectricFresnel(facing, kPlasticIndex);
        rest = colour * (light.z / kPi);
    }
    Scattering result;
    result.value = fresnel * facetReflection(view, light, h, material.alpha) + rest;
    result.density = mix(light.z / kPi, visibleFacetDensity(view, h, material.alpha), share);
    return result;
}

// Nothing of a mirror, which no sample of a light meets.
Scattering scatter(const MaterialData material, const vec3 colour, const vec3 view, const vec3 light) {
    Scattering result;
    result.value = vec3(0.0);
    result.density = 0.0;
    if (light.z <= 0.0 || isMaterial(material, MATERIAL_MIRROR)) return result;
    if (isMaterial(material, MATERIAL_MATTE))
        return diffuseScattering(colour, roughFactor(material, view, light), light);
    if (view.z > 0.0) return facetScattering(material, colour, view, light);
    return diffuseScattering(isMaterial(material, MATERIAL_PLASTIC) ? colour : vec3(0.0), 1.0, light);
}

// A direction to go on in; below the surface where a facet reflects into it. `lobe` chooses facets or cosine.
vec3 sampleMaterial(const MaterialData material, const vec3 view, const vec2 u, const float lobe) {
    if (isMaterial(material, MATERIAL_MIRROR)) return vec3(-view.xy, view.z);
    if (isMaterial(material, MATERIAL_MATTE) || lobe >= facetShare(material, view)) return cosineDirection(u);
    return reflect(-view, visibleFacet(view, material.alpha, u));
}
