// The displaced sphere over one cell of its map, whatever patch.glsl has there. Object space, units of R. Expects layout.h,
// numeric.glsl, and the resource functions cornersAt(map, cell) and edgesAt(x, y).

// Where a point stands in a patch. g = |p| - r, positive outside.
struct PatchPoint {
    real fu, fv, g;
};

int wrapColumn(const int column, const int width) {
    return column < 0 ? column + width : (column >= width ? column - width : column);
}

// Column and row of the cell that holds direction p; within rounding of an edge either neighbour.
ivec2 locateCell(const MapData map, const vec3 p) {
    real phi = atan2Precise(p.x, p.z);
    real theta = atan2Precise(sqrt(p.x * p.x + p.z * p.z), p.y);
    int column = int(floor(phi * (real(0.5) / kPi) * real(map.columns_per_turn) - real(map.first_column)));
    int row = int(floor(theta * real(map.cells_per_radian_v) + real(map.cap_shift)));
    column = wrapColumn(wrapColumn(column, map.width), map.width);
    return ivec2(clamp(column, 0, map.width - 1), clamp(row, 0, map.rows - 1));
}

bool isPoleRow(const MapData map, const int row) {
    return row == 0 || row == map.rows - 1;
}

// Cells per radian of latitude. Texel registration: the polar caps are half a cell high, so their weight runs twice as
// fast.
real cellsPerRadianV(const MapData map, const int row) {
    return real(map.cells_per_radian_v) * (map.caps != 0 && isPoleRow(map, row) ? real(2) : real(1));
}

// Angle from the nearer pole over the distance from the axis, close to that pole.
real angleOverRho(const vec3 p, const real rho) {
    real tangent = rho / max(abs(p.y), real(1e-20));
    return (real(1) - tangent * tangent * real(1.0 / 3.0)) / max(abs(p.y), real(1e-20));
}

// e_r - slope_east e_east - slope_south e_south: slopes of r per length.
vec3 gradientOf(const vec3 p, const real rho, const real radius, const real slope_east, const real slope_south) {
    real inverse_rho = real(1) / max(rho, real(1e-20));
    vec3 east = vec3(p.z, real(0), -p.x) * inverse_rho;
    vec3 outward = p / radius;
    vec3 southward = vec3(outward.y * p.x * inverse_rho, -rho / radius, outward.y * p.z * inverse_rho);
    return outward - slope_east * east - slope_south * southward;
}

// Coefficients of 1, fu, fv and fu fv of the bilinear patch over a cell, from its four corners: `cell` is the north-west
// one; the column after the last is the first.
vec4 bilinearOf(const MapData map, const real scale, const ivec2 cell) {
    // Scaled last: differences of a file's integers are exact, and slopes beside a pole need them so.
    vec4 at = cornersAt(map, cell);
    real north = at.y - at.x;
    return vec4(scale * at.x, scale * north, scale * (at.z - at.x), scale * ((at.w - at.z) - north));
}
