// Displaced spheres whose heights are bilinear between the map's samples. Expects surface.glsl.

const bool kCurved = false;

// One bilinear patch: r = base + a + b fu + c fv + d fu fv, fu eastward and fv southward fractions of the cell.
struct Patch {
    real a, b, c, d;
};

Patch fetchPatch(const MapData map, const real scale, const ivec2 cell) {
    vec4 of = bilinearOf(map, scale, cell);
    Patch quad;
    quad.a = of.x;
    quad.b = of.y;
    quad.c = of.z;
    quad.d = of.w;
    return quad;
}

real patchValue(const Patch quad, const real fu, const real fv) {
    return quad.a + quad.b * fu + fv * (quad.c + quad.d * fu);
}

// Gradient of f = |p| - r(p/|p|): e_r - dr/dphi / rho e_east - dr/dtheta / |p| e_south. In the rows that touch a pole
// dr/dphi is proportional to the angle from it, which cancels rho analytically.
vec3 patchGradient(const MapData map, const Patch quad, const PatchPoint at, const int row, const vec3 p) {
    real radius = max(length(p), kTiny);
    real rho = sqrt(p.x * p.x + p.z * p.z);
    real per_radian = cellsPerRadianV(map, row);
    real slope_east = (quad.b + quad.d * at.fv) / max(rho, real(1e-20));
    if (isPoleRow(map, row)) slope_east = (row == 0 ? quad.d : quad.b) * per_radian * angleOverRho(p, rho);
    slope_east *= real(map.cells_per_radian_u);
    real slope_south = (quad.c + quad.d * at.fu) * per_radian / radius;
    return gradientOf(p, rho, radius, slope_east, slope_south);
}

// The normal for shading at a hit, where the true one is `normal`: the same.
vec3 smoothNormal(const MapData map, const real scale, const PatchPoint at, const ivec2 cell, const vec3 p,
                  const vec3 normal) {
    return normal;
}
