// The filter's step through one cell of a bilinear surface. Expects what filter.glsl has before.

// g along a chord, y in [0, 1], in the patch and on its piece: the quartic's coefficients from the products, then the
// parabola through its ends and middle, where y^3 = 1.5 y^2 - 0.5 y and y^4 = 1.75 y^2 - 0.75 y.
Chord filterChord(const Patch quad, const vec3 start, const vec3 slope, const vec3 bend) {
    real twist_1 = start.x * slope.y + start.y * slope.x;
    real twist_2 = start.x * bend.y + slope.x * slope.y + start.y * bend.x;
    real twist_3 = slope.x * bend.y + slope.y * bend.x;
    real twist_4 = bend.x * bend.y;
    real cubic = -quad.d * twist_3;
    real quartic = -quad.d * twist_4;
    real linear = slope.z - quad.b * slope.x - quad.c * slope.y - quad.d * twist_1;
    real square = bend.z - quad.b * bend.x - quad.c * bend.y - quad.d * twist_2;
    return makeChord(start.z - patchValue(quad, start.x, start.y), linear - real(0.5) * cubic - real(0.75) * quartic,
                     square + real(1.5) * cubic + real(1.75) * quartic, cubic, quartic);
}

// An upper bound of the surface's |grad f| between two places of a patch.
real steepestOn(const Patch quad, const vec3 start, const vec3 end, const vec2 steepness) {
    real east = greater(abs(quad.b + quad.d * start.y), abs(quad.b + quad.d * end.y));
    real south = greater(abs(quad.c + quad.d * start.x), abs(quad.c + quad.d * end.x));
    return real(1) + east * steepness.x + south * steepness.y;
}

// Through one cell. `may_be_inside`: at the start of a camera's ray, which may lie inside the solid.
void filterStep(INOUT(FilterWalk) walk, const Piece piece, const MapData map, const real scale,
                const bool may_be_inside) {
    Patch quad = fetchPatch(map, scale, wrappedCell(walk, map));
    real height = rowHeight(map, walk.cell.y);
    // Per row from here on, not per height of the cell: exact, since that is 1 or 1/2.
    quad.c *= height < real(1) ? real(2) : real(1);
    quad.d *= height < real(1) ? real(2) : real(1);
    Reach reach = reachOf(walk, piece, map, height);
    real by = lesser(lesser(reach.to_u.by, reach.to_v.by), real(1) - walk.x);

    vec3 place = reach.place;
    vec3 slope = by * reach.rate;
    vec3 bend = (by * by) * piece.bend;
    Chord chord = filterChord(quad, place, slope, bend);
    real band = kDoubt * steepestOn(quad, place, place + slope + bend, piece.steepness) + chord.miss;

    bool inside = may_be_inside && chord.g < -band;
    bool falls = chord.lowest < -band && chord.g > real(0);
    bool free = chord.lowest > band && chord.g > real(0);
    // Written so that any NaN is a doubt.
    walk.verdict = inside ? kInside : (falls ? kHit : (!free ? kDoubtful : (by < real(1) - walk.x ? kGoing : kFree)));
    walk.by = by;
    walk.parabola = vec3(chord.g, chord.slope, chord.bend);
    walk.beyond = vec2(chord.cubic, chord.quartic);
    if (walk.verdict == kGoing) walkOn(walk, reach);
}
