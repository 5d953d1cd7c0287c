// Rays in object space, units of R, kept twice: rounded, for what only has to be safe, and to twice a float's bits, for
// where the surface is met. Moving a ray by half a float's ulp changes the answer of one ray in a thousand on a steep
// map, so the contract's tangency needs the bits.

// A point of the ray and its direction, of any length.
struct Line {
    Pair x, y, z;     // the point
    Pair dx, dy, dz;  // the direction
};

// p(s) = c + s d, d unit, c the point closest to the centre: |p|^2 = |c|^2 + s^2, free of cancellation at any distance.
struct Ray {
    vec3 c, d;
    real c2;  // |c|^2
    real s_min, s_max;
    bool may_start_inside;  // camera rays: a start inside the solid is a hit; secondary rays: only going in is
    bool may_escape;        // secondary rays, unless it has been asked already: whether they may rise too steeply to meet anything
    Line line;
    real s_point;         // s of the line's point
    real inverse_length;  // 1 / |direction|
};

// `before` is how far, in lengths of its direction, the ray starts before the line's point.
Ray makeRay(const Line line, const real before, const real s_max_from_start, const bool may_start_inside) {
    Ray ray;
    ray.line = line;
    vec3 direction = vec3(line.dx.hi, line.dy.hi, line.dz.hi);
    vec3 point = vec3(line.x.hi, line.y.hi, line.z.hi);
    real size = length(direction);
    ray.inverse_length = real(1) / size;
    ray.d = direction * ray.inverse_length;
    ray.s_point = dot(point, ray.d);
    ray.c = point - ray.s_point * ray.d;
    ray.c2 = dot(ray.c, ray.c);
    ray.s_min = ray.s_point - before * size;
    ray.s_max = ray.s_min + s_max_from_start;
    ray.may_start_inside = may_start_inside;
    ray.may_escape = !may_start_inside;
    return ray;
}

// A point of the line near s, exact to some 1e-14, and the s that it stands for.
struct Anchor {
    Pair x, y, z;
    real s;
};

Pair alongLine(const Pair start, const real steps, const Pair direction) {
    real lead = leadingBits(direction.hi);
    precise real rest = (direction.hi - lead) + direction.lo;
    precise real lead_part = steps * lead;
    precise real rest_part = steps * rest;
    return rounded(exactSum(start.hi, lead_part, start.lo + rest_part));
}

// The steps are cut to 12 bits, so that their products with the direction's leading 12 bits are exact.
Anchor anchorAt(const Ray ray, const real s) {
    real steps = leadingBits((s - ray.s_point) * ray.inverse_length);
    Anchor anchor;
    anchor.x = alongLine(ray.line.x, steps, ray.line.dx);
    anchor.y = alongLine(ray.line.y, steps, ray.line.dy);
    anchor.z = alongLine(ray.line.z, steps, ray.line.dz);
    anchor.s = ray.s_point + steps / ray.inverse_length;
    return anchor;
}

// The point at `sigma` beyond an anchor, correctly rounded but for the direction's rounding times sigma.
vec3 anchoredPoint(const Anchor anchor, const vec3 d, const real sigma) {
    precise real x = anchor.x.hi + (anchor.x.lo + sigma * d.x);
    precise real y = anchor.y.hi + (anchor.y.lo + sigma * d.y);
    precise real z = anchor.z.hi + (anchor.z.lo + sigma * d.z);
    return vec3(x, y, z);
}
