// The displaced sphere near one cell of its map: the patch, its height and gradient. Object space, units of R.
// Expects layout.h, numeric.glsl, and the resource functions heightAt(map, column, row) and edgesAt(x, y).

// One bilinear patch: r = a + b fu + c fv + d fu fv, fu eastward and fv southward fractions of the cell.
struct Patch {
    real a, b, c, d;
    vec4 lon;            // sine and cosine of the west edge's longitude, then of the east edge's
    vec4 lat;            // sine and cosine of the north edge's colatitude, then of the south edge's
    real per_radian_v;   // 1 / the cell's height in radians
    int row;
};

// Where a point stands in a patch. g = |p| - r, positive outside.
struct PatchPoint {
    real fu, fv, g;
};

int wrapColumn(int column, int width) {
    return column < 0 ? column + width : (column >= width ? column - width : column);
}

// Column and row of the cell that holds direction p; within rounding of an edge either neighbour.
ivec2 locateCell(MapData map, vec3 p) {
    real phi = atan2Precise(p.x, p.z);
    real theta = atan2Precise(sqrt(p.x * p.x + p.z * p.z), p.y);
    int column = int(floor(phi * (real(0.5) / kPi) * real(map.columns_per_turn) - real(map.first_column)));
    int row = int(floor(theta * real(map.cells_per_radian_v) + real(map.cap_shift)));
    column = wrapColumn(wrapColumn(column, map.width), map.width);
    return ivec2(clamp(column, 0, map.width - 1), clamp(row, 0, map.rows - 1));
}

bool isPoleRow(MapData map, int row) {
    return row == 0 || row == map.rows - 1;
}

// The patch of a cell from its four corners: (column, row) is the north-west one; the column after the last is the first.
Patch fetchPatch(MapData map, real base, real scale, ivec2 cell) {
    int next = cell.x + 1 == map.width ? 0 : cell.x + 1;
    real nw = base + scale * heightAt(map, cell.x, cell.y);
    real ne = base + scale * heightAt(map, next, cell.y);
    real sw = base + scale * heightAt(map, cell.x, cell.y + 1);
    real se = base + scale * heightAt(map, next, cell.y + 1);
    Patch quad;
    quad.a = nw;
    quad.b = ne - nw;
    quad.c = sw - nw;
    quad.d = (se - sw) - (ne - nw);
    quad.lon = edgesAt(cell.x, map.edges_y);
    quad.lat = edgesAt(cell.y, map.edges_y + 1);
    // Texel registration: the polar caps are half a cell high, so their weight runs twice as fast.
    bool half_high = map.caps != 0 && isPoleRow(map, cell.y);
    quad.per_radian_v = real(map.cells_per_radian_v) * (half_high ? real(2) : real(1));
    quad.row = cell.y;
    return quad;
}

// The map's own value inside a cell.
real storedAt(MapData map, ivec2 cell, PatchPoint at) {
    Patch quad = fetchPatch(map, real(0), real(1), cell);
    return quad.a + quad.b * at.fu + at.fv * (quad.c + quad.d * at.fu);
}

// Fractions from the angles to the cell's own edges, atan2(x cos e - z sin e, x sin e + z cos e): a global u in float
// would err by 6e-8 of a turn, times the slope. Clamped to the cell, which continues the surface by a constant.
PatchPoint patchPoint(MapData map, Patch quad, vec3 p, real radius) {
    precise real across = p.x * quad.lon.y - p.z * quad.lon.x;
    precise real along = p.x * quad.lon.x + p.z * quad.lon.y;
    real rho = sqrt(p.x * p.x + p.z * p.z);
    precise real south = rho * quad.lat.y - p.y * quad.lat.x;
    precise real toward = rho * quad.lat.x + p.y * quad.lat.y;
    real tan_u = clamp(across / max(along, real(1e-30)), real(0), real(map.tan_width));
    real tan_v = clamp(south / max(toward, real(1e-30)), real(0), real(map.tan_height));
    PatchPoint at;
    at.fu = atanSmall(tan_u) * real(map.cells_per_radian_u);
    at.fv = min(atanSmall(tan_v) * quad.per_radian_v, real(1));
    at.g = radius - (quad.a + quad.b * at.fu + at.fv * (quad.c + quad.d * at.fu));
    return at;
}

// Gradient of f = |p| - r(p/|p|): e_r - dr/dphi / rho e_east - dr/dtheta / |p| e_south. In the rows that touch a pole
// dr/dphi is proportional to the angle from it, which cancels rho analytically.
vec3 patchGradient(MapData map, Patch quad, PatchPoint at, vec3 p) {
    real radius = length(p);
    real rho = sqrt(p.x * p.x + p.z * p.z);
    real inverse_rho = real(1) / max(rho, real(1e-20));
    real slope_east = (quad.b + quad.d * at.fv) * inverse_rho;
    if (isPoleRow(map, quad.row)) {
        real tangent = rho / max(abs(p.y), real(1e-20));
        real angle_over_rho = (real(1) - tangent * tangent * real(1.0 / 3.0)) / max(abs(p.y), real(1e-20));
        slope_east = (quad.row == 0 ? quad.d : quad.b) * quad.per_radian_v * angle_over_rho;
    }
    slope_east *= real(map.cells_per_radian_u);
    real slope_south = (quad.c + quad.d * at.fu) * quad.per_radian_v / radius;
    vec3 east = vec3(p.z, real(0), -p.x) * inverse_rho;
    vec3 outward = p / radius;
    vec3 southward = vec3(outward.y * p.x * inverse_rho, -rho / radius, outward.y * p.z * inverse_rho);
    return outward - slope_east * east - slope_south * southward;
}
