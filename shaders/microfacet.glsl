// GGX facets (Walter et al. 2007) with the height-correlated shadowing of Smith (Heitz 2014), in the basis of the normal.
// `alpha` is the roughness. Sines are kept, not differences of squared cosines from 1: facets of alpha 0.001 need them.

float facetDensity(const vec3 h, const float alpha) {
    float alpha2 = alpha * alpha;
    float stretched = alpha2 * h.z * h.z + dot(h.xy, h.xy);
    return alpha2 / (kPi * stretched * stretched);
}

// Smith's Lambda.
float hidden(const vec3 v, const float alpha) {
    return 0.5 * (sqrt(1.0 + alpha * alpha * dot(v.xy, v.xy) / (v.z * v.z)) - 1.0);
}

// D G / (4 c_v): times the Fresnel term, what facets reflect from `light` to `view`, times the cosine of `light`.
float facetReflection(const vec3 view, const vec3 light, const vec3 h, const float alpha) {
    return facetDensity(h, alpha) / (4.0 * view.z * (1.0 + hidden(view, alpha) + hidden(light, alpha)));
}

// Density of reflections from the facets that `view` sees.
float visibleFacetDensity(const vec3 view, const vec3 h, const float alpha) {
    return facetDensity(h, alpha) / (4.0 * view.z * (1.0 + hidden(view, alpha)));
}

// A facet that `view` sees (Heitz 2018, "Sampling the GGX Distribution of Visible Normals").
vec3 visibleFacet(const vec3 view, const float alpha, const vec2 u) {
    vec3 v = normalize(vec3(alpha * view.xy, view.z));
    float across = dot(v.xy, v.xy);
    vec3 x = across > 0.0 ? vec3(-v.y, v.x, 0.0) * inversesqrt(across) : vec3(1.0, 0.0, 0.0);
    vec3 y = cross(v, x);
    float radius = sqrt(u.x);
    float angle = 2.0 * kPi * u.y;
    float a = radius * cos(angle);
    float s = 0.5 * (1.0 + v.z);
    float b = (1.0 - s) * sqrt(max(1.0 - a * a, 0.0)) + s * radius * sin(angle);
    vec3 facet = a * x + b * y + sqrt(max(1.0 - a * a - b * b, 0.0)) * v;
    return normalize(vec3(alpha * facet.xy, max(facet.z, 1e-7)));
}

// Fresnel's reflectance of a metal in air, for unpolarised light.
vec3 conductorFresnel(const float cosine, const vec3 eta, const vec3 k) {
    float c2 = cosine * cosine;
    float s2 = 1.0 - c2;
    vec3 eta2 = eta * eta;
    vec3 k2 = k * k;
    vec3 difference = eta2 - k2 - s2;
    vec3 sum = sqrt(difference * difference + 4.0 * eta2 * k2);
    // (sum + difference) / 2, which would cancel where k is the greater.
    vec3 a2 = mix(0.5 * (sum + difference), 2.0 * eta2 * k2 / max(sum - difference, vec3(1e-30)),
                  lessThan(difference, vec3(0.0)));
    vec3 a = 2.0 * cosine * sqrt(max(a2, vec3(0.0)));
    vec3 across = (sum + c2 - a) / (sum + c2 + a);
    vec3 along = across * (c2 * sum + s2 * s2 - a * s2) / (c2 * sum + s2 * s2 + a * s2);
    return 0.5 * (across + along);
}

// The same of a dielectric of that index.
float dielectricFresnel(const float cosine, const float index) {
    float inner = sqrt(1.0 - (1.0 - cosine * cosine) / (index * index));
    float across = (cosine - index * inner) / (cosine + index * inner);
    float along = (index * cosine - inner) / (index * cosine + inner);
    return 0.5 * (across * across + along * along);
}
