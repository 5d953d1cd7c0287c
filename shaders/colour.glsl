// The colour of an image at a point of an object, bilinear. Expects numeric.glsl, kImages (a bit per KIND_ of the objects that
// have one), and the resource functions edgesAt(x, y) and imageTexel(object, column, row).
//
// A texel next to a dark one needs its weight to a relative precision, however small the weight is. So the weights are
// distances from the nearest texel's centre, found as heights are: (a, b) turned by the centre's angle, in products
// that do not round.

// sqrt(a^2 + b^2) to twice a float's bits.
Pair exactLength(const real a, const real b) {
    Pair aa = exactProduct(a, a);
    Pair bb = exactProduct(b, b);
    Pair square = exactSum(aa.hi, bb.hi, aa.lo + bb.lo);
    precise real root = sqrt(square.hi);
    Pair back = exactProduct(root, root);
    precise real rest = (square.hi - back.hi) + (square.lo - back.lo);
    return makePair(root, rest / max(real(2) * root, kTiny));
}

// The angle from a centre to (a, b), `centre` the sine and cosine of its angle as float (x, y) and rest (z, w).
real angleFrom(const Pair a, const real b, const vec4 centre) {
    Pair a_cos = exactProduct(a.hi, centre.y);
    Pair b_sin = exactProduct(b, centre.x);
    precise real rest = (a_cos.lo - b_sin.lo) + ((a.lo * centre.y + a.hi * centre.w) - b * centre.z);
    Pair across = exactSum(a_cos.hi, -b_sin.hi, rest);
    return atan2Precise(across.hi + across.lo, a.hi * centre.x + b * centre.y);
}

// A texel whose centre is near, and how far beyond that centre the point lies, in texels.
struct TexelPlace {
    int index;
    real beyond;
};

// `q` has its poles on y, as displaced spheres have.
TexelPlace imageColumn(const ObjectData o, const vec3 q) {
    real u = atan2Precise(q.x, q.z) * (real(0.5) / kPi) + real(o.image_shift);
    TexelPlace place;
    place.index = clamp(int((u - floor(u)) * real(o.image_width)), 0, o.image_width - 1);
    place.beyond = angleFrom(makePair(q.x, real(0)), q.z, edgesAt(place.index, o.image_centres_y)) *
                   (real(o.image_width) * (real(0.5) / kPi));
    return place;
}

int nearestRow(const ObjectData o, const real share) {
    return clamp(int(share * real(o.image_height)), 0, o.image_height - 1);
}

TexelPlace imageRow(const ObjectData o, const vec3 q) {
    Pair rho = exactLength(q.x, q.z);
    TexelPlace place;
    if (isAmong(o.kind, KIND_DISK, kImages)) {
        real inner = sqrt(real(o.inner_squared));
        real per_unit = real(1) / (real(1) - inner);
        place.index = nearestRow(o, (rho.hi - inner) * per_unit);
        vec4 centre = edgesAt(place.index, o.image_centres_y + 1);
        precise real beyond = (rho.hi - centre.x) + (rho.lo - centre.z);
        place.beyond = beyond * (per_unit * real(o.image_height));
        return place;
    }
    place.index = nearestRow(o, atan2Precise(rho.hi, q.y) / kPi);
    place.beyond =
        angleFrom(rho, q.y, edgesAt(place.index, o.image_centres_y + 1)) * (real(o.image_height) / kPi);
    return place;
}

// The texel on the point's side of the nearest one.
int neighbour(const TexelPlace place, const int count) {
    int index = place.index + (place.beyond < real(0) ? -1 : 1);
    return index < 0 ? index + count : (index >= count ? index - count : index);
}

vec3 alongRow(const ObjectData o, const TexelPlace column, const int row) {
    real weight = abs(column.beyond);
    return (real(1) - weight) * imageTexel(o, column.index, row) +
           weight * imageTexel(o, neighbour(column, o.image_width), row);
}

// Between the first (last) row of a displaced sphere's image and the pole.
vec3 inCap(const ObjectData o, const TexelPlace row, const vec3 own, const vec3 q) {
    real from_pole = atan2Precise(length(vec2(q.x, q.z)), abs(q.y)) * (real(2 * o.image_height) / kPi);
    vec3 pole = row.beyond < real(0) ? vec3(o.image_north) : vec3(o.image_south);
    return from_pole * own + real(2) * abs(row.beyond) * pole;
}

vec3 imageColour(const ObjectData o, const vec3 p) {
    bool planet = isAmong(o.kind, KIND_DISPLACED, kImages);
    vec3 q = planet ? p : vec3(-p.y, p.z, -p.x);  // pbrt's shapes have their axis on z and begin at +x
    TexelPlace column = imageColumn(o, q);
    TexelPlace row = imageRow(o, q);
    vec3 own = alongRow(o, column, row.index);
    bool in_cap = planet && (row.beyond < real(0) ? row.index == 0 : row.index == o.image_height - 1);
    real weight = abs(row.beyond);
    vec3 colour = in_cap ? inCap(o, row, own, q)
                         : (real(1) - weight) * own + weight * alongRow(o, column, neighbour(row, o.image_height));
    return clamp(vec3(o.texture_scale) * colour, vec3(real(0)), vec3(real(1)));
}

// At texture coordinates, which repeat; (0, 0) is the image's lower left corner.
vec3 imageColourAt(const ObjectData o, const vec2 uv) {
    vec2 texel = vec2(uv.x - floor(uv.x), real(1) - (uv.y - floor(uv.y))) * vec2(o.image_width, o.image_height) - real(0.5);
    vec2 corner = floor(texel);
    vec2 t = texel - corner;
    int x0 = int(corner.x) < 0 ? o.image_width - 1 : int(corner.x);
    int y0 = int(corner.y) < 0 ? o.image_height - 1 : int(corner.y);
    int x1 = x0 + 1 == o.image_width ? 0 : x0 + 1;
    int y1 = y0 + 1 == o.image_height ? 0 : y0 + 1;
    vec3 colour = mix(mix(imageTexel(o, x0, y0), imageTexel(o, x1, y0), t.x),
                      mix(imageTexel(o, x0, y1), imageTexel(o, x1, y1), t.x), t.y);
    return clamp(vec3(o.texture_scale) * colour, vec3(real(0)), vec3(real(1)));
}

// (u, v), of an object that is of one of the `possible` kinds: a displaced sphere's as its heights have them, others' as pbrt has them.
vec2 surfaceUv(const ObjectData o, const vec3 p, const int possible) {
    if (isAmong(o.kind, KIND_DISPLACED, possible))
        return vec2(real(0.5) + atan2Precise(p.x, p.z) / (real(2) * kPi),
                    atan2Precise(sqrt(p.x * p.x + p.z * p.z), p.y) / kPi);
    real u = atan2Precise(p.y, p.x) / (real(2) * kPi);
    real rho = sqrt(p.x * p.x + p.y * p.y);
    real v = isAmong(o.kind, KIND_DISK, possible) ? (real(1) - rho) / (real(1) - sqrt(real(o.inner_squared)))
                                  : real(1) - atan2Precise(rho, p.z) / kPi;
    return vec2(u < real(0) ? u + real(1) : u, v);
}
