// Orthonormal bases about a unit vector, and directions in them (z along that vector).

struct Basis {
    vec3 x, y, z;
};

// Duff et al. 2017, "Building an Orthonormal Basis, Revisited".
Basis basisAbout(const vec3 z) {
    real s = z.z < real(0) ? real(-1) : real(1);
    real a = real(-1) / (s + z.z);
    real b = z.x * z.y * a;
    Basis basis;
    basis.x = vec3(real(1) + s * z.x * z.x * a, s * b, -s * z.x);
    basis.y = vec3(b, s + z.y * z.y * a, -z.y);
    basis.z = z;
    return basis;
}

vec3 intoBasis(const Basis basis, const vec3 v) {
    return vec3(dot(v, basis.x), dot(v, basis.y), dot(v, basis.z));
}

vec3 outOfBasis(const Basis basis, const vec3 v) {
    return v.x * basis.x + v.y * basis.y + v.z * basis.z;
}

// By the density cos / pi.
vec3 cosineDirection(const vec2 u) {
    real angle = real(2) * kPi * u.y;
    real sine = sqrt(u.x);
    return vec3(sine * cos(angle), sine * sin(angle), sqrt(real(1) - u.x));
}
