// The walk below one leaf of the bounds in single floats, with a filter (Shewchuk 1997): where rounding could change the
// answer the ray is in doubt, and walk.glsl, whose rays have twice the bits, decides instead. Few rays are, and most of the
// walk's cost is its bits. Expects march.glsl.

// How far a float ray and the float surface can be off together, in units of R: c and d are rounded in some five steps,
// a point's place in its cell in about as many, each by half an ulp below 1.
const real kDoubt = real(4e-7);
// A piece of a ray this long, as a share of its distance to the axis or the centre, has columns, rows and |p| that are
// parabolas to 1e-7 R: a parabola through both ends and the middle is off by 0.008 of the third derivative, and the angle
// about an axis has up to 2 of that over the cube of the distance.
const real kPieceAcross = real(1.0 / 48.0);
const real kPieceLength = real(1.0 / 64.0);
// Closer to the axis than this every ray is in doubt.
const real kAxisDoubt = real(2e-5);
// Rounding of s between this walk and the other.
const real kSafeMargin = real(1e-5);
// Longer searches are left to the other walk, whose own steps count towards the same limit of the device.
const int kFilterSteps = 12000;

real lesser(const real a, const real b) {
    return a < b ? a : b;
}

real greater(const real a, const real b) {
    return a > b ? a : b;
}

// The north-west corner of a cell: sine and cosine of its longitude and colatitude.
struct Corner {
    vec2 west, north;
};

Corner cornerOf(const vec4 west, const vec4 north) {
    Corner corner;
    corner.west = vec2(west.x, west.y);
    corner.north = vec2(north.x, north.y);
    return corner;
}

// A point seen from a corner.
struct Sight {
    real columns, rows;  // in cells, caps counted as half a row
    real rho, radius;    // distance to the axis and to the centre
};

Sight sightOf(const Corner corner, const MapData map, const vec3 p) {
    Sight sight;
    real rho2 = p.x * p.x + p.z * p.z;
    sight.rho = sqrt(rho2);
    sight.radius = sqrt(rho2 + p.y * p.y);
    real across = p.x * corner.west.y - p.z * corner.west.x;
    real along = p.x * corner.west.x + p.z * corner.west.y;
    real down = sight.rho * corner.north.y - p.y * corner.north.x;
    real toward = sight.rho * corner.north.x + p.y * corner.north.y;
    sight.columns = atanSmall(across / greater(along, kTiny)) * real(map.cells_per_radian_u);
    sight.rows = atanSmall(down / greater(toward, kTiny)) * real(map.cells_per_radian_v);
    return sight;
}

// Of a cell, in rows; and from the north pole to its north edge.
real rowHeight(const MapData map, const int row) {
    return map.caps != 0 && isPoleRow(map, row) ? real(0.5) : real(1);
}

real rowsBefore(const MapData map, const int row) {
    return greater(real(row) - real(map.cap_shift), real(0));
}

// A part of a ray below a leaf: its place at x in [0, 1] is start + x (slope + x bend).
struct Piece {
    Corner corner;
    vec3 start, slope, bend;  // columns and rows from the corner, and |p| - base
    ivec2 cell;               // where it starts: the corner's
    real s, s_end, extent;    // extent = s_end - s
    vec2 steepness;           // slope of the surface per height difference of a cell, eastward and southward
    real rows_before;         // of `cell`
    bool doubtful;
};

vec3 placeOf(const Corner corner, const MapData map, const real base, const vec3 p) {
    Sight sight = sightOf(corner, map, p);
    return vec3(sight.columns, sight.rows, sight.radius - base);
}

// The longest piece that starts at s.
Piece makePiece(const Ray ray, const MapData map, const real base, const real across_axis, const real s,
                const real s_end) {
    Piece piece;
    vec3 p = ray.c + s * ray.d;
    piece.cell = locateCell(map, p);
    piece.rows_before = rowsBefore(map, piece.cell.y);
    piece.corner = cornerOf(edgesAt(piece.cell.x, map.edges_y), edgesAt(piece.cell.y, map.edges_y + 1));
    Sight sight = sightOf(piece.corner, map, p);
    real longest = lesser(kPieceAcross * sight.rho / across_axis, kPieceLength * sight.radius);
    piece.s = s;
    piece.s_end = lesser(s + greater(longest, kShortestChord), s_end);
    piece.extent = piece.s_end - s;
    piece.start = vec3(sight.columns, sight.rows, sight.radius - base);
    vec3 middle = placeOf(piece.corner, map, base, ray.c + (s + real(0.5) * piece.extent) * ray.d);
    vec3 end = placeOf(piece.corner, map, base, ray.c + piece.s_end * ray.d);
    piece.bend = real(2) * (piece.start + end - real(2) * middle);
    piece.slope = end - piece.start - piece.bend;
    real closest = (real(1) - kPieceAcross) * sight.rho;
    piece.steepness = vec2(real(map.cells_per_radian_u) / greater(closest, kTiny),
                           real(map.cells_per_radian_v) / greater((real(1) - kPieceLength) * sight.radius, kTiny));
    piece.doubtful = !(sight.rho > kAxisDoubt);
    return piece;
}

// How much x grows until a coordinate with that rate and bend has grown by `gap`, which has the rate's sign. Where it
// turns back before, until there, and a little more, lest it be met again.
struct Advance {
    real by;
    bool crosses;
};

Advance advanceTo(const real gap, const real rate, const real bend) {
    real square = rate * rate + real(4) * gap * bend;
    Advance advance;
    advance.crosses = square >= real(0);
    real speed = abs(rate);
    real numerator = advance.crosses ? real(2) * abs(gap) : real(0.5) * speed;
    real denominator = advance.crosses ? speed + sqrt(square) : abs(bend);
    advance.by = numerator / greater(denominator, kTiny) + (advance.crosses ? real(0) : real(1e-5));
    return advance;
}

// What is known of a ray so far.
const int kGoing = 0;
const int kFree = 1;    // to the end of what was asked
const int kDoubtful = 2;
const int kHit = 3;
const int kInside = 4;  // a hit where it starts

// State of the walk along a piece: at x, in `cell`, whose column may lie beyond the map's first or last. Where it does not
// go on, or halves a chord, it stays at the last chord's start. Loops keep no more than they must: on lavapipe each value
// costs masked copies in every iteration (rule L12).
struct FilterWalk {
    ivec2 cell;
    real x;
    int verdict;
    real by;        // the last chord's length in x
    vec3 parabola;  // g, slope and bend of that chord
    vec2 beyond;    // its cubic and quartic terms
    real longest;   // of the next chord, in x: curved surfaces halve chords
};

// From a place in a cell to the edge that lies ahead, along one coordinate. A place that rounding has put beyond the edge
// already is taken as on it.
real gapAhead(const real place, const bool forward, const real size) {
    return forward ? greater(size - place, real(0)) : lesser(-place, real(0));
}

// Of the walk's cell, in the piece's columns and rows.
vec2 cornerPlace(const FilterWalk walk, const Piece piece, const MapData map) {
    return vec2(real(walk.cell.x - piece.cell.x), rowsBefore(map, walk.cell.y) - piece.rows_before);
}

ivec2 wrappedCell(const FilterWalk walk, const MapData map) {
    return ivec2(wrapColumn(walk.cell.x, map.width), walk.cell.y);
}

// What lies ahead in the walk's cell, which is `height` rows high.
struct Reach {
    vec3 place, rate;  // where the ray is in the cell, and how that changes with x
    bvec2 forward;     // eastward, southward
    Advance to_u, to_v;
};

Reach reachOf(const FilterWalk walk, const Piece piece, const MapData map, const real height) {
    real x = walk.x;
    Reach reach;
    reach.place = piece.start + x * (piece.slope + x * piece.bend) - vec3(cornerPlace(walk, piece, map), real(0));
    reach.rate = piece.slope + (real(2) * x) * piece.bend;
    reach.forward = bvec2(reach.rate.x > real(0), reach.rate.y > real(0));
    reach.to_u = advanceTo(gapAhead(reach.place.x, reach.forward.x, real(1)), reach.rate.x, piece.bend.x);
    reach.to_v = advanceTo(gapAhead(reach.place.y, reach.forward.y, height), reach.rate.y, piece.bend.y);
    bool pole_edge = walk.cell.y == (reach.forward.y ? map.rows - 1 : 0);
    reach.to_v.by = pole_edge && reach.to_v.crosses ? kInfinity : reach.to_v.by;
    return reach;
}

// On to the last chord's end, and over the edges that it leaves the cell by.
void walkOn(INOUT(FilterWalk) walk, const Reach reach) {
    bool leaves_u = reach.to_u.crosses && reach.to_u.by <= walk.by;
    bool leaves_v = reach.to_v.crosses && reach.to_v.by <= walk.by;
    walk.x += walk.by;
    walk.cell.x += leaves_u ? (reach.forward.x ? 1 : -1) : 0;
    walk.cell.y += leaves_v ? (reach.forward.y ? 1 : -1) : 0;
}

#include "filterstep.glsl"

// The answer in single floats; where it is doubtful the chord alone means something.
struct Filtered {
    bool hit, inside, doubtful;
    int verdict, steps;
    // The chord that holds the root or the doubt: its cell, s where it starts, its length in s, its parabola and the terms beyond.
    ivec2 cell;
    real low, extent;
    vec3 parabola;
    vec2 beyond;
};

// One leaf, or as much of it as one piece covers: the cursor is moved to its end.
void filterLeaf(INOUT(Filtered) answer, INOUT(Cursor) at, const Ray ray, const MapData map, const real base,
                const real scale, const real across_axis) {
    Piece piece = makePiece(ray, map, base, across_axis, at.s, at.leaf_end);
    FilterWalk walk;
    walk.cell = piece.cell;
    walk.x = real(0);
    walk.verdict = kGoing;
    walk.by = real(0);
    walk.parabola = vec3(real(0));
    walk.beyond = vec2(real(0));
    walk.longest = real(1);
    bool may_be_inside = ray.may_start_inside && at.s <= ray.s_min;
    while (answer.steps < kFilterSteps) {
        filterStep(walk, piece, map, scale, may_be_inside && walk.x == real(0));
        answer.steps += 4;
        if (walk.verdict != kGoing || piece.doubtful) break;
    }
    answer.verdict = piece.doubtful ? kDoubtful : walk.verdict;
    answer.cell = wrappedCell(walk, map);
    answer.low = piece.s + (piece.doubtful ? real(0) : walk.x * piece.extent);
    answer.extent = walk.by * piece.extent;
    answer.parabola = walk.parabola;
    answer.beyond = walk.beyond;
    at.s = piece.s_end;  // where a leaf is longer than the piece, the next step finds the rest of it
    at.leaf = false;
}

// Searches the whole ray in single floats.
Filtered filterMarch(const Ray ray, const MapData map, const real base, const real scale, const real shell_squared) {
    Filtered answer;
    answer.verdict = kGoing;
    answer.steps = 0;
    answer.cell = ivec2(0);
    answer.low = real(0);
    answer.extent = real(0);
    answer.parabola = vec3(real(0));
    answer.beyond = vec2(real(0));
    Cursor at;
    real s_end;
    bool searching = startCursor(at, ray, map, shell_squared, s_end);
    real across_axis = acrossAxis(ray.d);
    while (searching && answer.steps < kFilterSteps) {
        FaceRay face = faceRay(ray, at.axis, at.sign_of_face);
        if (at.turned) findCell(at, face);
        int face_row = faceRow(map, at.axis, at.sign_of_face);
        while (answer.steps < kFilterSteps) {
            traverseStep(at, face, face_row, ray, map, s_end);
            answer.steps += 1;
            if (at.leaf || at.turned || !(at.s < s_end)) break;
        }
        if (at.leaf) filterLeaf(answer, at, ray, map, base, scale, across_axis);
        if (at.turned) turnFace(at, face);
        if (answer.verdict > kFree || !(at.s < s_end)) break;
    }
    answer.hit = answer.verdict >= kHit;
    answer.inside = answer.verdict == kInside;
    answer.doubtful = answer.verdict == kDoubtful || answer.steps >= kFilterSteps;
    return answer;
}

// Up to this s nothing is met, for certain: bounds, or the chords before, said so.
real safeUntil(const Filtered answer) {
    bool cut_short = answer.steps >= kFilterSteps;
    return cut_short ? -kInfinity : answer.low - kSafeMargin;
}

// A float point, and the true surface of the cell seen from there.
Crossing crossingAt(const vec3 p, const MapData map, const real base, const ivec2 cell, const Corner corner,
                    const Patch quad) {
    Crossing crossing;
    crossing.p = p;
    Sight sight = sightOf(corner, map, p);
    real rows_per_height = real(1) / rowHeight(map, cell.y);
    crossing.at.fu = clamp(sight.columns, real(0), real(1));
    crossing.at.fv = clamp(sight.rows * rows_per_height, real(0), real(1));
    crossing.at.g = (sight.radius - base) - patchValue(quad, crossing.at.fu, crossing.at.fv);
    crossing.gradient = patchGradient(map, quad, crossing.at, cell.y, p);
    return crossing;
}

// The same to 48 bits: the height ramp's colour of a steep map needs them. west, north: the cell's edges.
Crossing finalCrossing(const vec3 p, const MapData map, const Pair base, const ivec2 cell, const vec4 west,
                       const vec4 north, const Patch quad) {
    Crossing crossing;
    crossing.p = p;
    View view = viewFrom(splitEdge(west), splitEdge(north), base, makePair(p.x, real(0)), makePair(p.y, real(0)),
                         makePair(p.z, real(0)));
    real columns = atanSmall(view.place.x / max(view.place.y, kTiny)) * real(map.cells_per_radian_u);
    real rows = atanSmall(view.slant.x / max(view.slant.y, kTiny)) * cellsPerRadianV(map, cell.y);
    crossing.at.fu = clamp(columns, real(0), real(1));
    crossing.at.fv = clamp(rows, real(0), real(1));
    crossing.at.g = view.height - patchValue(quad, crossing.at.fu, crossing.at.fv);
    crossing.gradient = patchGradient(map, quad, crossing.at, cell.y, p);
    return crossing;
}

// g along a hit's chord, y in [0, 1], its slope and half its second derivative: the parabola through the ends and the middle, and
// the terms beyond, cubic (y^3 - 1.5 y^2 + 0.5 y) + quartic (y^4 - 1.75 y^2 + 0.75 y).
vec3 alongChord(const Filtered answer, const real y) {
    real cubic = answer.beyond.x;
    real quartic = answer.beyond.y;
    real linear = answer.parabola.y + real(0.5) * cubic + real(0.75) * quartic;
    real square = answer.parabola.z - real(1.5) * cubic - real(1.75) * quartic;
    return vec3(answer.parabola.x + y * (linear + y * (square + y * (cubic + y * quartic))),
                linear + y * (real(2) * square + y * (real(3) * cubic + y * (real(4) * quartic))),
                square + y * (real(3) * cubic + y * (real(6) * quartic)));
}

// How much y grows from where g is so large until it is 0, by its slope and bend there.
real towardsRoot(const vec3 along, const real g) {
    real by = -g / lesser(along.y, -kTiny);
    return -g / lesser(along.y + by * along.z, -kTiny);
}

// The root of g along the chord, then a step from the true f at that float point, by the same slope and bend: what is left is f's
// rounding. Of curved surfaces, whose chords are not known so well, one more, by the true gradient. Points move from each other, not
// along s, whose own rounding would come on top.
Crossing filterRefine(const Ray ray, const MapData map, const Pair base, const real scale, const Filtered answer) {
    Patch quad = fetchPatch(map, scale, answer.cell);
    vec4 west = edgesAt(answer.cell.x, map.edges_y);
    vec4 north = edgesAt(answer.cell.y, map.edges_y + 1);
    Corner corner = cornerOf(west, north);
    real root = parabolaRoot(answer.parabola);
    vec3 along = alongChord(answer, root);
    root = clamp(root + towardsRoot(along, along.x), real(0), real(1));
    real y = answer.inside ? real(0) : root;
    vec3 p = ray.c + (answer.low + y * answer.extent) * ray.d;
    Crossing first = crossingAt(p, map, base.hi, answer.cell, corner, quad);
    along = alongChord(answer, y);
    real moved = answer.inside ? y : clamp(y + towardsRoot(along, first.at.g), real(0), real(1));
    p += ((moved - y) * answer.extent) * ray.d;
    if (kCurved) {
        Crossing second = crossingAt(p, map, base.hi, answer.cell, corner, quad);
        real rate = dot(second.gradient, ray.d);
        bool steep = abs(rate) > real(1e-6) * length(second.gradient);
        real stride = steep && !answer.inside ? -second.at.g / rate : real(0);
        p += clamp(stride, -moved * answer.extent, (real(1) - moved) * answer.extent) * ray.d;
    }
    return finalCrossing(p, map, base, answer.cell, west, north, quad);
}
