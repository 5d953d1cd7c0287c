// Local coordinates of a ray in a cell of the map: everything that has to be precise is a small number. The ray is
// p(sigma), sigma counted from an anchor. In the frame of the cell's west edge (longitude e) and north edge (colatitude
// t): across = x cos e - z sin e, along = x sin e + z cos e, so tan(longitude - e) = across / along; south = rho cos t -
// y sin t, toward = rho sin t + y cos t, so tan(colatitude - t) = south / toward. Going from cell to cell turns the
// frame by the cell's own small angle. Expects surface.glsl and ray.glsl.

struct CellFrame {
    Anchor anchor;
    ivec2 cell;
    vec2 place, place_d;  // (across, along) of the anchor and of the direction
    vec2 slant;           // (south, toward) of the anchor
    vec2 edge;            // (sine, cosine) of the north edge's colatitude
    real rho, radius;     // distance from the axis and from the centre, of the anchor
    real height;          // radius - base, without cancellation
    real rate_rho, rate_radius;  // half the first derivatives of rho^2 and |p|^2
    real d_across2;       // squared share of d across the axis
    real moment, moment_y;  // lengths of the moment p x d and of its part about the axis
};

// Nearer to the axis than this a point is taken as on it; the contract excuses 1e-6.
const real kOnAxis = real(2.5e-7);
// A ray whose direction has less than this across the axis runs along it.
const real kAlongAxis = real(1e-3);
// How far off the axis a point is put to have the longitude of the ray's direction, in the same row.
const real kAsideOfAxis = real(1e-9);

// On the axis, and about to leave it; a ray along the axis stays in the column that it is in.
bool isOnAxis(const vec3 p, const vec3 d) {
    return max(abs(p.x), abs(p.z)) < kOnAxis && max(abs(d.x), abs(d.z)) > kAlongAxis;
}

// Sine and cosine of an edge as rotatePair wants them: leading 12 bits, and rest.
vec4 splitEdge(const vec4 edge) {
    real sine = leadingBits(edge.x);
    real cosine = leadingBits(edge.y);
    precise real sine_rest = (edge.x - sine) + edge.z;
    precise real cosine_rest = (edge.y - cosine) + edge.w;
    return vec4(sine, cosine, sine_rest, cosine_rest);
}

// A point seen from a cell's corner, to 48 bits where it matters: (across, along) and (south, toward) are small and exact to
// their own rounding in their first component.
struct View {
    vec2 place, slant;
    real rho, radius;  // distance from the axis and from the centre
    real height;       // radius - base, without cancellation
};

// west, north: of splitEdge.
View viewFrom(const vec4 west, const vec4 north, const Pair base, const Pair x, const Pair y, const Pair z) {
    View view;
    Rotated around = rotatePair(x, z, west);
    real along = around.second.hi + around.second.lo;
    view.place = vec2(around.first, along);
    // rho = along + across^2 / (along + rho): the small part apart. Beside or behind the axis, where an anchor can lie, the
    // whole is small.
    view.rho = sqrt(along * along + around.first * around.first);
    bool beside = along < real(0.5) * view.rho;
    real beyond = around.first * around.first / max(view.rho + along, kTiny);
    precise real rho_rest = (around.second.lo + beyond);
    Pair rho_pair = makePair(beside ? view.rho : around.second.hi, beside ? real(0) : rho_rest);
    Rotated down = rotatePair(rho_pair, y, north);
    real toward = down.second.hi + down.second.lo;
    view.slant = vec2(down.first, toward);
    view.radius = sqrt(toward * toward + down.first * down.first);
    real bulge = down.first * down.first / max(view.radius + toward, kTiny);
    precise real height = (down.second.hi - base.hi) + ((down.second.lo + bulge) - base.lo);
    view.height = height;
    return view;
}

// The frame of the cell that the ray is in at s, anchored near it. On the axis all columns meet, and the longitude jumps:
// the column is then the one that the ray leaves to. Leaves often start there: cells of the cube map meet at the poles.
CellFrame makeFrame(const Ray ray, const MapData map, const Pair base, const real s) {
    CellFrame frame;
    Anchor anchor = anchorAt(ray, s);
    frame.anchor = anchor;
    vec3 p = vec3(anchor.x.hi, anchor.y.hi, anchor.z.hi);
    vec3 at = ray.c + s * ray.d;  // the anchor may lie in another cell
    frame.cell = locateCell(map, isOnAxis(at, ray.d) ? vec3(kAsideOfAxis * ray.d.x, at.y, kAsideOfAxis * ray.d.z) : at);
    vec4 west = splitEdge(edgesAt(frame.cell.x, map.edges_y));
    vec4 north = splitEdge(edgesAt(frame.cell.y, map.edges_y + 1));
    View view = viewFrom(west, north, base, anchor.x, anchor.y, anchor.z);
    frame.place = view.place;
    frame.slant = view.slant;
    frame.rho = view.rho;
    frame.radius = view.radius;
    frame.height = view.height;
    real sin_w = west.x + west.z;
    real cos_w = west.y + west.w;
    frame.place_d = vec2(ray.d.x * cos_w - ray.d.z * sin_w, ray.d.x * sin_w + ray.d.z * cos_w);
    frame.edge = vec2(north.x + north.z, north.y + north.w);
    frame.rate_rho = p.x * ray.d.x + p.z * ray.d.z;
    frame.rate_radius = dot(p, ray.d);
    frame.d_across2 = ray.d.x * ray.d.x + ray.d.z * ray.d.z;
    vec3 moment = cross(p, ray.d);
    frame.moment = length(moment);
    frame.moment_y = abs(moment.y);
    return frame;
}

// The ray at sigma, in the frame.
struct Local {
    vec2 place, slant;
    real rho, grown;  // rho and |p| - radius of the anchor
};

Local localAt(const CellFrame frame, const real d_y, const real sigma) {
    Local local;
    local.place = frame.place + sigma * frame.place_d;
    local.rho = length(local.place);
    real outward = sigma * (real(2) * frame.rate_rho + sigma * frame.d_across2) / max(local.rho + frame.rho, kTiny);
    real upward = sigma * d_y;
    local.slant = vec2(frame.slant.x + outward * frame.edge.y - upward * frame.edge.x,
                       frame.slant.y + outward * frame.edge.x + upward * frame.edge.y);
    real radii = max(length(local.slant) + frame.radius, kTiny);  // 0 at the very centre
    local.grown = sigma * (real(2) * frame.rate_radius + sigma) / radii;
    return local;
}

// Clamped to the cell, which continues the surface by a constant where rounding puts a crossing beside an edge.
PatchPoint patchPoint(const MapData map, const Patch quad, const CellFrame frame, const Local local) {
    real tan_u = clamp(local.place.x / max(local.place.y, kTiny), real(0), real(map.tan_width));
    real tan_v = clamp(local.slant.x / max(local.slant.y, kTiny), real(0), real(map.tan_height));
    PatchPoint at;
    at.fu = min(atanSmall(tan_u) * real(map.cells_per_radian_u), real(1));
    at.fv = min(atanSmall(tan_v) * cellsPerRadianV(map, frame.cell.y), real(1));
    precise real above = (frame.height - patchValue(quad, at.fu, at.fv)) + local.grown;
    at.g = above;
    return at;
}

// Steps over the east (or west) edge.
void stepEast(INOUT(CellFrame) frame, const MapData map, const bool east) {
    real sine = east ? real(map.sin_width) : -real(map.sin_width);
    frame.place = rotateSmall(frame.place, sine, real(map.versin_width));
    frame.place_d = rotateSmall(frame.place_d, sine, real(map.versin_width));
    frame.cell.x = wrapColumn(frame.cell.x + (east ? 1 : -1), map.width);
}

// Whether the ray at sigma stands behind the edge that it comes from, going east (or west).
bool behindColumn(const CellFrame frame, const MapData map, const bool east, const real sigma) {
    vec2 place = frame.place + sigma * frame.place_d;
    return east ? place.x < real(0) : rotateSmall(place, real(map.sin_width), real(map.versin_width)).x > real(0);
}

// Sine and versine of the height of a row of cells.
vec2 rowRotation(const MapData map, const int row) {
    bool pole = isPoleRow(map, row);
    return vec2(pole ? real(map.sin_cap) : real(map.sin_height), pole ? real(map.versin_cap) : real(map.versin_height));
}

// Steps over the south (or north) edge; the edge's own angle grows by the height of the row between.
void stepSouth(INOUT(CellFrame) frame, const MapData map, const bool south) {
    vec2 rotation = rowRotation(map, south ? frame.cell.y : frame.cell.y - 1);
    real sine = south ? rotation.x : -rotation.x;
    frame.slant = rotateSmall(frame.slant, sine, rotation.y);
    vec2 cosine_sine = rotateSmall(vec2(frame.edge.y, frame.edge.x), sine, rotation.y);
    frame.edge = vec2(cosine_sine.y, cosine_sine.x);
    frame.cell.y += south ? 1 : -1;
}

// The cell was found from rounded coordinates: near the axis that can be columns off, and elsewhere a row. Behind the ray its
// heights would stand for those of the cell that the ray is in, and an edge ahead might never be met. Steps to the cell that
// the frame's own coordinates say.
void settleCell(INOUT(CellFrame) frame, const MapData map, const bool east, const bool on_axis, const real d_y,
                const real sigma) {
    int left = on_axis ? 0 : map.width;
    while (left > 0 && behindColumn(frame, map, east, sigma)) {
        stepEast(frame, map, !east);
        left -= 1;
    }
    while (left > 0 && behindColumn(frame, map, !east, sigma)) {
        stepEast(frame, map, east);
        left -= 1;
    }
    vec2 slant = localAt(frame, d_y, sigma).slant;
    vec2 rotation = rowRotation(map, frame.cell.y);
    bool north = slant.x < real(0) && frame.cell.y > 0;
    bool south = rotateSmall(slant, rotation.x, rotation.y).x > real(0) && frame.cell.y < map.rows - 1;
    if (north || south) stepSouth(frame, map, south);
}
