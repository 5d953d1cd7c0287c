// Triangles, met by Woop, Benthin and Wald 2013, "Watertight ray/triangle intersection": an edge that two triangles share
// gives both the same edge function but for its sign, so no ray slips through between them.

// The axes with the direction's greatest component last, and the shear that turns the direction into that axis.
struct Shear {
    int x, y, z;
    real by_x, by_y, by_z;
};

Shear shearOf(const vec3 d) {
    vec3 size = abs(d);
    Shear shear;
    shear.z = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
    shear.x = shear.z == 2 ? 0 : shear.z + 1;
    shear.y = shear.x == 2 ? 0 : shear.x + 1;
    shear.by_z = real(1) / component(d, shear.z);
    shear.by_x = component(d, shear.x) * shear.by_z;
    shear.by_y = component(d, shear.y) * shear.by_z;
    return shear;
}

vec3 sheared(const Shear shear, const vec3 p) {
    precise vec3 q = vec3(component(p, shear.x) - shear.by_x * component(p, shear.z),
                          component(p, shear.y) - shear.by_y * component(p, shear.z), shear.by_z * component(p, shear.z));
    return q;
}

real edgeFunction(const vec3 from, const vec3 to) {
    precise real left = from.x * to.y;
    precise real right = from.y * to.x;
    precise real value = left - right;
    return value;
}

// Of a triangle: the ray's s where it is met, and the barycentric weights of its corners; s is kInfinity on a miss.
struct TriangleHit {
    real s;
    vec3 weights;
};

TriangleHit meetTriangle(const TriangleData triangle, const Shear shear, const Ray ray) {
    TriangleHit hit;
    vec3 a = sheared(shear, vec3(triangle.a) - ray.c);
    vec3 b = sheared(shear, vec3(triangle.b) - ray.c);
    vec3 c = sheared(shear, vec3(triangle.c) - ray.c);
    vec3 edges = vec3(edgeFunction(c, b), edgeFunction(a, c), edgeFunction(b, a));
    real whole = edges.x + edges.y + edges.z;
    bool inside = (edges.x >= real(0) && edges.y >= real(0) && edges.z >= real(0)) ||
                  (edges.x <= real(0) && edges.y <= real(0) && edges.z <= real(0));
    hit.weights = edges / whole;
    hit.s = inside && whole != real(0) ? dot(hit.weights, vec3(a.z, b.z, c.z)) : kInfinity;
    return hit;
}

vec3 weighted(const vec3 weights, const vec3 a, const vec3 b, const vec3 c) {
    return weights.x * a + weights.y * b + weights.z * c;
}

ObjectHit hitMesh(const ObjectData object, const Ray ray) {
    ObjectHit hit = noHit();
    real nearest = ray.s_max;
    Shear shear = shearOf(ray.d);
    int k = 0;
    do {
        TriangleData triangle = triangles[object.first_triangle + k];
        TriangleHit meets = meetTriangle(triangle, shear, ray);
        bool after_start = ray.may_start_inside ? meets.s >= ray.s_min : meets.s > ray.s_min;
        if (after_start && meets.s < nearest) {
            nearest = meets.s;
            hit.hit = true;
            hit.n = cross(vec3(triangle.b) - vec3(triangle.a), vec3(triangle.c) - vec3(triangle.a));
            // Weights place the point in the triangle's plane to a rounding; c + s d would be off by the ray's own.
            hit.p = weighted(meets.weights, vec3(triangle.a), vec3(triangle.b), vec3(triangle.c));
            hit.uv = vec2(dot(meets.weights, vec3(triangle.a.w, triangle.b.w, triangle.c.w)),
                          dot(meets.weights, vec3(triangle.v)));
        }
    } while (++k < object.triangle_count);
    hit.n = normalize(dot(hit.n, ray.d) > real(0) ? -hit.n : hit.n);
    return hit;
}
