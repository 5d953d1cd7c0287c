// GGX facets (Walter et al. 2007) with the height-correlated shadowing of Smith (Heitz 2014), in the basis of the normal.
// `alpha` is the roughness. Sines are kept, not differences of squared cosines from 1: facets of alpha 0.001 need them.

real facetDensity(const vec3 h, const real alpha) {
    real alpha2 = alpha * alpha;
    real stretched = alpha2 * h.z * h.z + dot(XY(h), XY(h));
    return alpha2 / (kPi * stretched * stretched);
}

// Smith's Lambda.
real hidden(const vec3 v, const real alpha) {
    return real(0.5) * (sqrt(real(1) + alpha * alpha * dot(XY(v), XY(v)) / (v.z * v.z)) - real(1));
}

// D G / (4 c_v): times the Fresnel term, what facets reflect from `light` to `view`, times the cosine of `light`.
real facetReflection(const vec3 view, const vec3 light, const vec3 h, const real alpha) {
    return facetDensity(h, alpha) / (real(4) * view.z * (real(1) + hidden(view, alpha) + hidden(light, alpha)));
}

// Density of reflections from the facets that `view` sees.
real visibleFacetDensity(const vec3 view, const vec3 h, const real alpha) {
    return facetDensity(h, alpha) / (real(4) * view.z * (real(1) + hidden(view, alpha)));
}

// A facet that `view` sees (Heitz 2018, "Sampling the GGX Distribution of Visible Normals").
vec3 visibleFacet(const vec3 view, const real alpha, const vec2 u) {
    vec3 v = normalize(vec3(alpha * XY(view), view.z));
    real across = dot(XY(v), XY(v));
    vec3 x = across > real(0) ? vec3(-v.y, v.x, real(0)) * inversesqrt(across) : vec3(real(1), real(0), real(0));
    vec3 y = cross(v, x);
    real radius = sqrt(u.x);
    real angle = real(2) * kPi * u.y;
    real a = radius * cos(angle);
    real s = real(0.5) * (real(1) + v.z);
    real b = (real(1) - s) * sqrt(max(real(1) - a * a, real(0))) + s * radius * sin(angle);
    vec3 facet = a * x + b * y + sqrt(max(real(1) - a * a - b * b, real(0))) * v;
    return normalize(vec3(alpha * XY(facet), max(facet.z, real(1e-7))));
}

// Fresnel's reflectance of a metal in air, for unpolarised light.
vec3 conductorFresnel(const real cosine, const vec3 eta, const vec3 k) {
    real c2 = cosine * cosine;
    real s2 = real(1) - c2;
    vec3 eta2 = eta * eta;
    vec3 k2 = k * k;
    vec3 difference = eta2 - k2 - s2;
    vec3 sum = sqrt(difference * difference + real(4) * eta2 * k2);
    // (sum + difference) / 2, which would cancel where k is the greater.
    vec3 a2 = mix(real(0.5) * (sum + difference), real(2) * eta2 * k2 / max(sum - difference, vec3(real(1e-30))),
                  lessThan(difference, vec3(real(0))));
    vec3 a = real(2) * cosine * sqrt(max(a2, vec3(real(0))));
    vec3 across = (sum + c2 - a) / (sum + c2 + a);
    vec3 along = across * (c2 * sum + s2 * s2 - a * s2) / (c2 * sum + s2 * s2 + a * s2);
    return real(0.5) * (across + along);
}

// The same of a dielectric of that index.
real dielectricFresnel(const real cosine, const real index) {
    real inner = sqrt(real(1) - (real(1) - cosine * cosine) / (index * index));
    real across = (cosine - index * inner) / (cosine + index * inner);
    real along = (index * cosine - inner) / (index * cosine + inner);
    return real(0.5) * (across * across + along * along);
}
