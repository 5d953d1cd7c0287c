// Displaced spheres whose heights are not bilinear: a bicubic spline, or ripples in closed form; and bilinear ones that
// share a scene with them. Expects surface.glsl, kSurfaces (a bit per SURFACE_ of the scene: the others are compiled away)
// and the resource functions nodeAt(map, column, row) and controlsAt(map, cell).

const bool kCurved = true;

// r - base over one cell. A polynomial: coefficients of u^0 to u^3 in the components of c0 to c3, which go with v^0 to
// v^3. Ripples: half (1 + sin(phase_u + u d_u) sin(phase_v + v d_v)), c0 the sines and cosines of both phases at the
// north-west corner, c1 d_u, d_v and half.
struct Patch {
    vec4 c0, c1, c2, c3;
    bool ripples;
};

bool sceneHasSurface(const int surface) {
    return (kSurfaces & (1 << surface)) != 0;
}

// Whether all of the scene's displaced spheres have that surface: then no test is left, nor the code of the others.
bool sceneHasOnly(const int surface) {
    return (kSurfaces & ~(1 << SURFACE_SMOOTH_NORMALS)) == 1 << surface;
}

bool hasSurface(const MapData map, const int surface) {
    return sceneHasOnly(surface) || (sceneHasSurface(surface) && map.surface == surface);
}

bool isRippled(const Patch quad) {
    return sceneHasOnly(SURFACE_RIPPLES) || (sceneHasSurface(SURFACE_RIPPLES) && quad.ripples);
}

Patch flatPatch() {
    Patch quad;
    quad.c0 = vec4(real(0));
    quad.c1 = vec4(real(0));
    quad.c2 = vec4(real(0));
    quad.c3 = vec4(real(0));
    quad.ripples = false;
    return quad;
}

// The cubic with that value at 0, that rise to 1, and those slopes at 0 and 1 (Hermite).
vec4 cubicOf(const real start, const real rise, const real slope_0, const real slope_1) {
    return vec4(start, slope_0, real(3) * rise - (slope_0 + slope_0 + slope_1), slope_0 + slope_1 - (rise + rise));
}

// Of a cell's corners: value, slope eastward, slope southward, twist.
struct SplineCorners {
    vec4 nw, ne, sw, se;
};

// At the middle of 3x3 control points; seen from that, so that rounding is of their differences.
vec4 splineNode(const vec3 above, const vec3 middle, const vec3 below) {
    vec3 north = above - vec3(middle.y);
    vec3 here = middle - vec3(middle.y);
    vec3 south = below - vec3(middle.y);
    vec3 value = (north + real(4) * here + south) / real(6);
    vec3 slope = real(0.5) * (south - north);
    return vec4(middle.y + (value.x + real(4) * value.y + value.z) / real(6), real(0.5) * (value.z - value.x),
                (slope.x + real(4) * slope.y + slope.z) / real(6), real(0.5) * (slope.z - slope.x));
}

// Of a map in tiles, which has no image of nodes.
SplineCorners tileSplineCorners(const MapData map, const ivec2 cell) {
    Controls of = controlsAt(map, cell);
    vec3 above = vec3(of.above.x, of.above.y, of.above.z);
    vec3 north = vec3(of.north.x, of.north.y, of.north.z);
    vec3 south = vec3(of.south.x, of.south.y, of.south.z);
    vec3 below = vec3(of.below.x, of.below.y, of.below.z);
    SplineCorners corners;
    corners.nw = splineNode(above, north, south);
    corners.sw = splineNode(north, south, below);
    above = vec3(of.above.y, of.above.z, of.above.w);
    north = vec3(of.north.y, of.north.z, of.north.w);
    south = vec3(of.south.y, of.south.z, of.south.w);
    below = vec3(of.below.y, of.below.z, of.below.w);
    corners.ne = splineNode(above, north, south);
    corners.se = splineNode(north, south, below);
    bool texel = map.caps != 0;
    if (texel && cell.y == 0) {
        corners.nw = vec4(real(map.north_pole), real(0), real(0), real(0));
        corners.ne = corners.nw;
    }
    if (texel && cell.y == map.rows - 1) {
        corners.sw = vec4(real(map.south_pole), real(0), real(0), real(0));
        corners.se = corners.sw;
    }
    return corners;
}

SplineCorners splineCorners(const MapData map, const ivec2 cell) {
    if (kTiles != 0 && map.tile_shift != 0) return tileSplineCorners(map, cell);
    int next = cell.x + 1 == map.width ? 0 : cell.x + 1;
    SplineCorners corners;
    corners.nw = nodeAt(map, cell.x, cell.y);
    corners.ne = nodeAt(map, next, cell.y);
    corners.sw = nodeAt(map, cell.x, cell.y + 1);
    corners.se = nodeAt(map, next, cell.y + 1);
    return corners;
}

// Linear in v within a cap.
Patch splinePatch(const MapData map, const real scale, const ivec2 cell) {
    SplineCorners corners = splineCorners(map, cell);
    vec4 nw = corners.nw;
    vec4 ne = corners.ne;
    vec4 sw = corners.sw;
    vec4 se = corners.se;
    real north = ne.x - nw.x;
    vec4 down = cubicOf(sw.x - nw.x, (se.x - sw.x) - north, sw.y - nw.y, se.y - ne.y);
    bool in_cap = cell.y < map.cap_rows || cell.y >= map.rows - map.cap_rows;
    vec4 down_0 = in_cap ? down : cubicOf(nw.z, ne.z - nw.z, nw.w, ne.w);
    vec4 down_1 = in_cap ? down : cubicOf(sw.z, se.z - sw.z, sw.w, se.w);
    Patch quad;
    quad.c0 = scale * cubicOf(nw.x, north, nw.y, ne.y);
    quad.c1 = scale * down_0;
    quad.c2 = in_cap ? vec4(real(0)) : scale * (real(3) * down - (down_0 + down_0 + down_1));
    quad.c3 = in_cap ? vec4(real(0)) : scale * (down_0 + down_1 - (down + down));
    quad.ripples = false;
    return quad;
}

Patch bilinearPatch(const MapData map, const real scale, const ivec2 cell) {
    vec4 of = bilinearOf(map, scale, cell);
    Patch quad = flatPatch();
    quad.c0 = vec4(of.x, of.y, real(0), real(0));
    quad.c1 = vec4(of.z, of.w, real(0), real(0));
    return quad;
}

// The arguments of the sines at the edges lie in the two rows below the edges'.
Patch ripplePatch(const MapData map, const real scale, const ivec2 cell) {
    vec4 west = edgesAt(cell.x, map.edges_y + 2);
    vec4 north = edgesAt(cell.y, map.edges_y + 3);
    Patch quad = flatPatch();
    quad.c0 = vec4(west.x, west.y, north.x, north.y);
    quad.c1 = vec4(real(map.phase_u), real(map.phase_v), real(0.5) * scale, real(0));
    quad.ripples = true;
    return quad;
}

Patch fetchPatch(const MapData map, const real scale, const ivec2 cell) {
    Patch quad;
    if (hasSurface(map, SURFACE_BILINEAR)) quad = bilinearPatch(map, scale, cell);
    if (hasSurface(map, SURFACE_SPLINE)) quad = splinePatch(map, scale, cell);
    if (hasSurface(map, SURFACE_RIPPLES)) quad = ripplePatch(map, scale, cell);
    return quad;
}

// Sine and cosine of an angle whose own are `at`, plus a small one: |x| <= 0.2.
vec2 sineBeyond(const vec2 at, const real x) {
    real square = x * x;
    real sine = x * (real(1) - square * (real(1.0 / 6.0) - square * real(1.0 / 120.0)));
    real versine = square * (real(0.5) - square * (real(1.0 / 24.0) - square * real(1.0 / 720.0)));
    return vec2(at.x + (at.y * sine - at.x * versine), at.y - (at.x * sine + at.y * versine));
}

vec2 rippleSineU(const Patch quad, const real fu) {
    return sineBeyond(vec2(quad.c0.x, quad.c0.y), fu * quad.c1.x);
}

vec2 rippleSineV(const Patch quad, const real fv) {
    return sineBeyond(vec2(quad.c0.z, quad.c0.w), fv * quad.c1.y);
}

// The polynomial's coefficients in u on a parallel, and their slopes along v.
vec4 acrossAt(const Patch quad, const real fv) {
    return quad.c0 + fv * (quad.c1 + fv * (quad.c2 + fv * quad.c3));
}

vec4 acrossSlopesAt(const Patch quad, const real fv) {
    return quad.c1 + fv * (real(2) * quad.c2 + (real(3) * fv) * quad.c3);
}

real cubicValue(const vec4 c, const real x) {
    return c.x + x * (c.y + x * (c.z + x * c.w));
}

real cubicSlope(const vec4 c, const real x) {
    return c.y + x * (real(2) * c.z + (real(3) * x) * c.w);
}

real patchValue(const Patch quad, const real fu, const real fv) {
    if (isRippled(quad)) return quad.c1.z * (real(1) + rippleSineU(quad, fu).x * rippleSineV(quad, fv).x);
    return cubicValue(acrossAt(quad, fv), fu);
}

// dr/du and dr/dv, per cell.
vec2 patchSlopes(const Patch quad, const real fu, const real fv) {
    if (isRippled(quad)) {
        vec2 u = rippleSineU(quad, fu);
        vec2 v = rippleSineV(quad, fv);
        return quad.c1.z * vec2(quad.c1.x * u.y * v.x, quad.c1.y * u.x * v.y);
    }
    return vec2(cubicSlope(acrossAt(quad, fv), fu), cubicValue(acrossSlopesAt(quad, fv), fu));
}

// dr/du over the share of the way from the pole to the cell's other edge, in a row that touches a pole, where both are 0
// together: the polynomial divided by v, or by 1 - v; of ripples the sine over its argument.
real poleSlopeEast(const Patch quad, const real fu, const real fv, const bool north) {
    real from_pole = north ? fv : real(1) - fv;
    if (isRippled(quad)) {
        real x = quad.c1.y * from_pole;
        real square = x * x;
        real sinc = real(1) - square * (real(1.0 / 6.0) - square * real(1.0 / 120.0));
        real sign = north || quad.c0.z >= real(0) ? real(1) : real(-1);
        return quad.c1.z * quad.c1.x * rippleSineU(quad, fu).y * sign * quad.c1.y * sinc;
    }
    real q1 = cubicSlope(quad.c1, fu);
    real q2 = cubicSlope(quad.c2, fu);
    real q3 = cubicSlope(quad.c3, fu);
    return north ? q1 + fv * (q2 + fv * q3) : -((q1 + q2 + q3) + fv * ((q2 + q3) + fv * q3));
}

// Gradient of f = |p| - r(p/|p|); in the rows that touch a pole the distance to the axis cancels.
vec3 patchGradient(const MapData map, const Patch quad, const PatchPoint at, const int row, const vec3 p) {
    real radius = max(length(p), kTiny);
    real rho = sqrt(p.x * p.x + p.z * p.z);
    real per_radian = cellsPerRadianV(map, row);
    vec2 slopes = patchSlopes(quad, at.fu, at.fv);
    real east_over_rho = slopes.x / max(rho, real(1e-20));
    if (isPoleRow(map, row))
        east_over_rho = poleSlopeEast(quad, at.fu, at.fv, row == 0) * per_radian * angleOverRho(p, rho);
    return gradientOf(p, rho, radius, east_over_rho * real(map.cells_per_radian_u), slopes.y * per_radian / radius);
}

// Bounds of the second and third derivatives over the whole cell.
struct Bends {
    vec3 second;  // uu, uv, vv
    vec4 third;   // uuu, uuv, uvv, vvv
};

Bends patchBends(const Patch quad) {
    Bends bends;
    if (isRippled(quad)) {
        real u = quad.c1.x;
        real v = quad.c1.y;
        real half_scale = abs(quad.c1.z);
        bends.second = half_scale * vec3(u * u, u * v, v * v);
        bends.third = half_scale * vec4(u * u * u, u * u * v, u * v * v, v * v * v);
        return bends;
    }
    vec4 a1 = abs(quad.c1);
    vec4 a2 = abs(quad.c2);
    vec4 a3 = abs(quad.c3);
    vec4 value = abs(quad.c0) + a1 + a2 + a3;
    vec4 slope = a1 + real(2) * a2 + real(3) * a3;
    vec4 bend = real(2) * a2 + real(6) * a3;
    bends.second = vec3(real(2) * value.z + real(6) * value.w, slope.y + real(2) * slope.z + real(3) * slope.w,
                        bend.x + bend.y + bend.z + bend.w);
    bends.third = vec4(real(6) * value.w, real(2) * slope.z + real(6) * slope.w,
                       bend.y + real(2) * bend.z + real(3) * bend.w, real(6) * (a3.x + a3.y + a3.z + a3.w));
    return bends;
}

// A bound of d3 r / dy3 along a chord on which u and v are parabolas of y in [0, 1], by the chain rule. `rate`: at its
// start; `bend`: half of the second derivative.
real chordTwist(const Bends bends, const vec2 rate, const vec2 bend) {
    vec2 grown = rate + real(2) * bend;
    real u = max(abs(rate.x), abs(grown.x));
    real v = max(abs(rate.y), abs(grown.y));
    vec2 second = real(2) * abs(bend);
    real cubes = (bends.third.x * u + real(3) * bends.third.y * v) * u * u +
                 (real(3) * bends.third.z * u + bends.third.w * v) * v * v;
    real products = bends.second.x * u * second.x + bends.second.y * (u * second.y + v * second.x) +
                    bends.second.z * v * second.y;
    return cubes + real(3) * products;
}

// The normal for shading at a hit, where the true one is `normal`: the B-spline's, if the object asks for it.
vec3 smoothNormal(const MapData map, const real scale, const PatchPoint at, const ivec2 cell, const vec3 p,
                  const vec3 normal) {
    if (!sceneHasSurface(SURFACE_SMOOTH_NORMALS) || map.smooth_normals == 0) return normal;
    Patch quad = splinePatch(map, scale, cell);
    vec3 gradient = patchGradient(map, quad, at, cell.y, p);
    return dot(gradient, gradient) > real(0) ? normalize(gradient) : normal;
}
