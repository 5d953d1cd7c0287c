// What surfaces reflect, in the basis of the shading normal: docs/light.md. Expects kMaterials (a bit per MATERIAL_ of the
// scene: the others are compiled away) and the tables.

const real kPlasticIndex = real(1.5);

bool isMaterial(const MaterialData material, const int kind) {
    return isAmong(material.kind, kind, kMaterials);
}

// The reflected share of light from a direction, times its cosine, and the density at which sampleMaterial finds it.
struct Scattering {
    vec3 value;
    real density;
};

// 1 - E: the light that facets of F = 1 do not reflect at once. Cubic (Catmull and Rom) between values at the squares of
// equal steps, the first of them beyond 0.
real facetLoss(const MaterialData material, const real cosine) {
    real place = sqrt(clamp(cosine, real(0), real(1))) * real(LOSS_INTERVALS);
    int i = min(int(place), LOSS_INTERVALS - 1);
    real t = place - real(i);
    int first = material.table + i;
    real a = real(tables[first]);
    real b = real(tables[first + 1]);
    real c = real(tables[first + 2]);
    real d = real(tables[first + 3]);
    return b + real(0.5) * t * ((c - a) + t * ((real(2) * a - real(5) * b + real(4) * c - d) + t * (real(3) * (b - c) + (d - a))));
}

// Oren and Nayar's factor of Lambert's law.
real roughFactor(const MaterialData material, const vec3 view, const vec3 light) {
    if (kRoughMattes == 0) return real(1);
    if (view.z <= real(0)) return real(material.rough_a);
    real sine_view = length(XY(view));
    real sine_light = length(XY(light));
    real product = sine_view * sine_light;
    real cosine = product > real(0) ? max(dot(XY(view), XY(light)) / product, real(0)) : real(0);
    // sin(alpha) tan(beta) of the greater and the lesser angle: the lesser has the greater cosine.
    return real(material.rough_a) + real(material.rough_b) * cosine * product / max(view.z, light.z);
}

Scattering diffuseScattering(const vec3 colour, const real factor, const vec3 light) {
    Scattering result;
    result.value = colour * (factor * light.z / kPi);
    result.density = light.z / kPi;
    return result;
}

// The share of samples that go by the facets. A viewer below the horizon of a smooth normal sees none.
real facetShare(const MaterialData material, const vec3 view) {
    if (view.z <= real(0)) return real(0);
    return isMaterial(material, MATERIAL_CONDUCTOR) ? real(1) - facetLoss(material, view.z) : real(0.5);
}

// Facets above a diffuse rest: a conductor's is the light that bounces between them, a plastic's its colour.
Scattering facetScattering(const MaterialData material, const vec3 colour, const vec3 view, const vec3 light) {
    vec3 h = normalize(view + light);
    real facing = clamp(dot(light, h), real(0), real(1));
    real share = facetShare(material, view);
    vec3 fresnel;
    vec3 rest;
    if (isMaterial(material, MATERIAL_CONDUCTOR)) {
        fresnel = conductorFresnel(facing, XYZ(material.eta), XYZ(material.k));
        rest = XYZ(material.bounced) * (facetLoss(material, view.z) * facetLoss(material, light.z) * light.z);
    } else {
        fresnel = XYZ(material.specular) * dielectricFresnel(facing, kPlasticIndex);
        rest = colour * (light.z / kPi);
    }
    Scattering result;
    result.value = fresnel * facetReflection(view, light, h, real(material.alpha)) + rest;
    result.density = mix(light.z / kPi, visibleFacetDensity(view, h, real(material.alpha)), share);
    return result;
}

// Nothing of a mirror, which no sample of a light meets.
Scattering scatter(const MaterialData material, const vec3 colour, const vec3 view, const vec3 light) {
    Scattering result;
    result.value = vec3(real(0));
    result.density = real(0);
    if (light.z <= real(0) || isMaterial(material, MATERIAL_MIRROR)) return result;
    if (isMaterial(material, MATERIAL_MATTE))
        return diffuseScattering(colour, roughFactor(material, view, light), light);
    if (view.z > real(0)) return facetScattering(material, colour, view, light);
    return diffuseScattering(isMaterial(material, MATERIAL_PLASTIC) ? colour : vec3(real(0)), real(1), light);
}

// A direction to go on in; below the surface where a facet reflects into it. `lobe` chooses facets or cosine.
vec3 sampleMaterial(const MaterialData material, const vec3 view, const vec2 u, const real lobe) {
    if (isMaterial(material, MATERIAL_MIRROR)) return vec3(-XY(view), view.z);
    if (isMaterial(material, MATERIAL_MATTE) || lobe >= facetShare(material, view)) return cosineDirection(u);
    return reflect(-view, visibleFacet(view, real(material.alpha), u));
}
