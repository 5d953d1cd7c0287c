// The answer of a ray with one object.

struct ObjectHit {
    bool hit, inside, exhausted;
    bool doubtful;  // only of the filter: full precision must decide, the rest means nothing
    int steps;
    real safe_s;    // after a filter's hit or doubt: up to this s of the ray nothing is met
    vec3 p, n;     // object space, units of R; n unit, outward (disk: towards the ray's origin)
    vec3 shading_n;  // n, or the normal of a smoother surface
    vec2 uv;       // of a mesh
    real stored;   // the map's value
    real residual; // f(p)
};

ObjectHit noHit() {
    ObjectHit hit;
    hit.hit = false;
    hit.inside = false;
    hit.exhausted = false;
    hit.doubtful = false;
    hit.steps = 0;
    hit.safe_s = -kInfinity;
    hit.p = vec3(real(0));
    hit.n = vec3(real(0));
    hit.shading_n = vec3(real(0));
    hit.uv = vec2(real(0));
    hit.stored = real(0);
    hit.residual = real(0);
    return hit;
}
