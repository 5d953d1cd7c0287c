// The walk below one leaf of the bounds in single floats, with a filter (Shewchuk 1997): where rounding could change the
// answer the ray is in doubt, and walk.glsl, whose rays have twice the bits, decides instead. Few rays are, and most of the
// walk's cost is its bits. Expects surface.glsl and walk.glsl's solveChord.

// How far a float ray and the float surface can be off together, in units of R: c and d are rounded in some five steps,
// a point's place in its cell in about as many, each by half an ulp below 1.
const real kDoubt = real(4e-7);
// A piece of a ray this long, as a share of its distance to the axis or the centre, has columns, rows and |p| that are
// parabolas to 1e-7: the cubic's share is 0.008 of the cube, and near the axis the third derivative is 2.
const real kPieceAcross = real(1.0 / 32.0);
const real kPieceLength = real(0.02);
// Closer to the axis than this every ray is in doubt.
const real kAxisDoubt = real(2e-5);
// Longer searches are left to the other walk, whose own steps count towards the same limit of the device.
const int kFilterSteps = 12000;

// The north-west corner of a cell: sine and cosine of its longitude and colatitude.
struct Corner {
    vec2 west, north;
};

Corner cornerOf(MapData map, ivec2 cell) {
    vec4 west = edgesAt(cell.x, map.edges_y);
    vec4 north = edgesAt(cell.y, map.edges_y + 1);
    Corner corner;
    corner.west = vec2(west.x + west.z, west.y + west.w);
    corner.north = vec2(north.x + north.z, north.y + north.w);
    return corner;
}

// A point seen from a corner.
struct Sight {
    real east, south;  // radians
    real rho, radius;  // distance to the axis and to the centre
};

Sight sightOf(Corner corner, vec3 p) {
    Sight sight;
    real across = p.x * corner.west.y - p.z * corner.west.x;
    real along = p.x * corner.west.x + p.z * corner.west.y;
    sight.rho = sqrt(across * across + along * along);
    real down = sight.rho * corner.north.y - p.y * corner.north.x;
    real toward = sight.rho * corner.north.x + p.y * corner.north.y;
    sight.radius = sqrt(down * down + toward * toward);
    sight.east = atanSmall(across / max(along, kTiny));
    sight.south = atanSmall(down / max(toward, kTiny));
    return sight;
}

// A part of a ray below a leaf: its place at x in [0, 1] is start + x (slope + x bend).
struct Piece {
    vec3 start, slope, bend;  // columns and rows from the corner of `cell`, and |p| - base
    ivec2 cell;               // where it starts
    real s_end, extent;       // in units of R
    vec2 steepness;           // slope of the surface per height difference of a cell, eastward and southward
    bool doubtful;
};

vec3 placeAt(Piece piece, real x) {
    return piece.start + x * (piece.slope + x * piece.bend);
}

vec3 placeOf(Corner corner, MapData map, real base, vec3 p) {
    Sight sight = sightOf(corner, p);
    return vec3(sight.east * real(map.cells_per_radian_u), sight.south * real(map.cells_per_radian_v),
                sight.radius - base);
}

// The longest piece that starts at s.
Piece makePiece(Ray ray, MapData map, real base, real across_axis, real s, real s_end) {
    Piece piece;
    vec3 p = ray.c + s * ray.d;
    piece.cell = locateCell(map, p);
    Corner corner = cornerOf(map, piece.cell);
    Sight sight = sightOf(corner, p);
    real longest = min(kPieceAcross * sight.rho / across_axis, kPieceLength * sight.radius);
    piece.s_end = min(s + max(longest, kShortestChord), s_end);
    piece.extent = piece.s_end - s;
    piece.start = vec3(sight.east * real(map.cells_per_radian_u), sight.south * real(map.cells_per_radian_v),
                       sight.radius - base);
    vec3 middle = placeOf(corner, map, base, ray.c + (s + real(0.5) * piece.extent) * ray.d);
    vec3 end = placeOf(corner, map, base, ray.c + piece.s_end * ray.d);
    piece.bend = real(2) * (piece.start + end - real(2) * middle);
    piece.slope = end - piece.start - piece.bend;
    real closest = (real(1) - kPieceAcross) * sight.rho;
    piece.steepness = vec2(real(map.cells_per_radian_u) / max(closest, kTiny),
                           real(map.cells_per_radian_v) / max((real(1) - kPieceLength) * sight.radius, kTiny));
    piece.doubtful = sight.rho < kAxisDoubt;
    return piece;
}

// How much x grows until a coordinate with that rate and bend has grown by `gap`, which has the rate's sign. Where it
// turns back before, until there, and a little more, lest it be met again.
struct Advance {
    real by;
    bool crosses;
};

Advance advanceTo(real gap, real rate, real bend) {
    real square = rate * rate + real(4) * gap * bend;
    real root = sqrt(max(square, real(0)));
    Advance advance;
    advance.crosses = square >= real(0);
    real crossing = real(2) * abs(gap) / max(abs(rate) + root, kTiny);
    real turn = real(0.5) * abs(rate) / max(abs(bend), kTiny) + real(1e-5);
    advance.by = advance.crosses ? crossing : turn;
    return advance;
}

real rowHeight(MapData map, int row) {
    return map.caps != 0 && isPoleRow(map, row) ? real(0.5) : real(1);
}

// State of the walk along a piece: at x, in `cell`, whose corner lies at `corner` in the piece's columns and rows.
struct Stroll {
    ivec2 cell;
    vec2 corner;
    real x;
    real low, high;  // ends of the last chord
    real fall;       // after a hit: dg/dx there, of the chord's parabola
    bool going, hit, inside, doubtful;
};

PatchPoint strollPoint(Stroll stroll, Patch quad, vec3 place, real rows_per_height) {
    PatchPoint at;
    at.fu = place.x - stroll.corner.x;
    at.fv = (place.y - stroll.corner.y) * rows_per_height;
    at.g = place.z - patchValue(quad, at.fu, at.fv);
    return at;
}

// An upper bound of the surface's |grad f| on a chord that runs between two points of a patch.
real steepestOn(Patch quad, PatchPoint start, PatchPoint end, vec2 steepness) {
    real east = max(abs(quad.b + quad.d * start.fv), abs(quad.b + quad.d * end.fv));
    real south = max(abs(quad.c + quad.d * start.fu), abs(quad.c + quad.d * end.fu));
    return real(1) + east * steepness.x + south * steepness.y;
}

// Through one cell. `may_be_inside`: at the start of a camera's ray, which may lie inside the solid.
void strollStep(INOUT(Stroll) stroll, Piece piece, MapData map, real scale, bool may_be_inside) {
    Patch quad = fetchPatch(map, scale, stroll.cell);
    real height = rowHeight(map, stroll.cell.y);
    vec3 here = placeAt(piece, stroll.x);
    vec3 rate = piece.slope + real(2) * stroll.x * piece.bend;
    bool east = rate.x > real(0);
    bool south = rate.y > real(0);
    real gap_u = (east ? real(1) : real(0)) + stroll.corner.x - here.x;
    real gap_v = (south ? height : real(0)) + stroll.corner.y - here.y;
    // A coordinate that rounding has put beyond the edge already is taken as on it.
    Advance to_u = advanceTo(east ? max(gap_u, real(0)) : min(gap_u, real(0)), rate.x, piece.bend.x);
    Advance to_v = advanceTo(south ? max(gap_v, real(0)) : min(gap_v, real(0)), rate.y, piece.bend.y);
    bool pole_edge = south ? stroll.cell.y == map.rows - 1 : stroll.cell.y == 0;
    if (pole_edge && to_v.crosses) {
        to_v.crosses = false;
        to_v.by = kInfinity;
    }
    real far = min(stroll.x + min(to_u.by, to_v.by), real(1));

    real rows_per_height = real(1) / height;
    PatchPoint start = strollPoint(stroll, quad, here, rows_per_height);
    PatchPoint middle = strollPoint(stroll, quad, placeAt(piece, real(0.5) * (stroll.x + far)), rows_per_height);
    PatchPoint end = strollPoint(stroll, quad, placeAt(piece, far), rows_per_height);
    Chord chord = solveChord(start, middle, end, quad.d);
    vec2 steepness = vec2(piece.steepness.x, piece.steepness.y * rows_per_height);
    real band = kDoubt * steepestOn(quad, start, end, steepness) + chord.miss;

    stroll.inside = may_be_inside && start.g < -band;
    stroll.hit = stroll.inside || (chord.lowest < -band && start.g > real(0));
    // Written so that any NaN is a doubt.
    stroll.doubtful = !stroll.hit && !(chord.lowest > band && start.g > real(0));
    bool on = !stroll.hit && !stroll.doubtful;
    stroll.going = on && far < real(1);
    stroll.low = stroll.x;
    stroll.high = far;
    if (on) {
        bool leaves_u = to_u.crosses && stroll.x + to_u.by <= far;
        bool leaves_v = to_v.crosses && stroll.x + to_v.by <= far;
        real below = south ? height : -rowHeight(map, stroll.cell.y - 1);
        stroll.x = far;
        if (leaves_u) {
            stroll.cell.x = wrapColumn(stroll.cell.x + (east ? 1 : -1), map.width);
            stroll.corner.x += east ? real(1) : real(-1);
        }
        if (leaves_v) {
            stroll.cell.y += south ? 1 : -1;
            stroll.corner.y += below;
        }
    } else {
        stroll.x += stroll.inside ? real(0) : chord.fraction * (far - stroll.x);
    }
    stroll.fall = chord.fall / max(stroll.high - stroll.low, kTiny);
}

// The answer in single floats; where it is doubtful the rest means nothing.
struct Filtered {
    bool hit, inside, doubtful;
    ivec2 cell;
    real s, low, high;  // s of the root, and of the ends of the chord that holds it
    real fall;          // df/ds at the root, negative
    int steps;
};

// One leaf, or as much of it as one piece covers: the cursor is moved to its end.
void filterLeaf(INOUT(Filtered) answer, INOUT(Cursor) at, Ray ray, MapData map, real base, real scale,
                real across_axis) {
    Piece piece = makePiece(ray, map, base, across_axis, at.s, at.leaf_end);
    Stroll stroll;
    stroll.cell = piece.cell;
    stroll.corner = vec2(real(0));
    stroll.x = real(0);
    stroll.low = real(0);
    stroll.high = real(1);
    stroll.fall = real(0);
    stroll.going = !piece.doubtful;
    stroll.hit = false;
    stroll.inside = false;
    stroll.doubtful = piece.doubtful;
    bool may_be_inside = ray.may_start_inside && at.s <= ray.s_min;
    while (stroll.going && answer.steps < kFilterSteps) {
        strollStep(stroll, piece, map, scale, may_be_inside);
        may_be_inside = false;
        answer.steps += 4;
    }
    answer.hit = stroll.hit;
    answer.inside = stroll.inside;
    answer.doubtful = stroll.doubtful;
    answer.cell = stroll.cell;
    answer.s = at.s + stroll.x * piece.extent;
    answer.low = at.s + stroll.low * piece.extent;
    answer.high = at.s + stroll.high * piece.extent;
    answer.fall = stroll.fall / piece.extent;
    // Where a leaf is longer than the piece, the next step finds the rest of it.
    at.skip = piece.s_end >= at.leaf_end;
    at.s = piece.s_end;
    at.leaf = false;
}

// Searches the whole ray in single floats.
Filtered filterMarch(Ray ray, MapData map, real base, real scale, real shell_squared) {
    Filtered answer;
    answer.hit = false;
    answer.inside = false;
    answer.doubtful = false;
    answer.cell = ivec2(0);
    answer.s = real(0);
    answer.low = real(0);
    answer.high = real(0);
    answer.fall = real(0);
    answer.steps = 0;
    Cursor at;
    real s_end;
    bool searching = startCursor(at, ray, map, shell_squared, s_end);
    real across_axis = acrossAxis(ray.d);
    while (searching) {
        FaceRay face = faceRay(ray, at.axis, at.sign_of_face);
        if (at.turned) findCell(at, face, map);
        while (!at.leaf && !at.turned && at.s < s_end && answer.steps < kFilterSteps) {
            traverseStep(at, face, ray, map, s_end);
            answer.steps += 1;
        }
        if (at.leaf) filterLeaf(answer, at, ray, map, base, scale, across_axis);
        searching = !answer.hit && !answer.doubtful && at.s < s_end && answer.steps < kFilterSteps;
    }
    answer.doubtful = answer.doubtful || answer.steps >= kFilterSteps;
    return answer;
}

// A float point, and the true surface seen from there.
Crossing crossingAt(vec3 p, MapData map, real base, Patch quad, Corner corner, int row) {
    Crossing crossing;
    crossing.p = p;
    Sight sight = sightOf(corner, crossing.p);
    crossing.at.fu = clamp(sight.east * real(map.cells_per_radian_u), real(0), real(1));
    crossing.at.fv = clamp(sight.south * cellsPerRadianV(map, row), real(0), real(1));
    crossing.at.g = (sight.radius - base) - patchValue(quad, crossing.at.fu, crossing.at.fv);
    crossing.gradient = patchGradient(map, quad, crossing.at, row, crossing.p);
    return crossing;
}

// Two Newton steps on the true f at float points, the first with the parabola's slope: what is left is f's rounding. Points
// move from each other, not along s, whose own rounding would come on top.
Crossing filterRefine(Ray ray, MapData map, real base, real scale, Filtered answer) {
    Patch quad = fetchPatch(map, scale, answer.cell);
    Corner corner = cornerOf(map, answer.cell);
    Crossing first = crossingAt(ray.c + answer.s * ray.d, map, base, quad, corner, answer.cell.y);
    real stride = answer.inside ? real(0) : -first.at.g / min(answer.fall, -kTiny);
    stride = clamp(stride, answer.low - answer.s, answer.high - answer.s);
    Crossing second = crossingAt(first.p + stride * ray.d, map, base, quad, corner, answer.cell.y);
    real rate = dot(second.gradient, ray.d);
    bool steep = abs(rate) > real(1e-6) * length(second.gradient);
    real s = answer.s + stride;
    stride = steep && !answer.inside ? -second.at.g / rate : real(0);
    stride = clamp(stride, answer.low - s, answer.high - s);
    return crossingAt(second.p + stride * ray.d, map, base, quad, corner, answer.cell.y);
}
