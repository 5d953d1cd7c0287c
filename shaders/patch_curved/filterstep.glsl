// The filter's step through one cell of a curved surface: along a chord that is no polynomial of low degree, so the chord is
// halved until the parabola through its ends and middle decides. Expects what filter.glsl has before.

// What leaves this much of the doubt band undecided is not halved further.
const real kEnoughOfDoubt = real(0.25);

// A bound of |grad f| along a chord: the slopes at its middle, and how far they can change from there.
real steepestAlong(const Patch quad, const Bends bends, const vec3 middle, const vec2 reach, const vec2 steepness) {
    vec2 slopes = abs(patchSlopes(quad, middle.x, middle.y));
    real east = slopes.x + bends.second.x * reach.x + bends.second.y * reach.y;
    real south = slopes.y + bends.second.y * reach.x + bends.second.z * reach.y;
    return real(1) + east * steepness.x + south * steepness.y;
}

// The chord's parabola, and in `band` how far rounding can take the ray and the surface apart.
Chord curvedChord(const Patch quad, const vec3 start, const vec3 slope, const vec3 bend, const vec2 steepness,
                  INOUT(real) band) {
    vec3 middle = start + real(0.5) * (slope + real(0.5) * bend);
    vec3 end = start + slope + bend;
    real g_start = start.z - patchValue(quad, start.x, start.y);
    real g_middle = middle.z - patchValue(quad, middle.x, middle.y);
    real g_end = end.z - patchValue(quad, end.x, end.y);
    real bend_g = real(2) * (g_start + g_end - real(2) * g_middle);
    Bends bends = patchBends(quad);
    vec2 rate = vec2(slope.x, slope.y);
    vec2 bending = vec2(bend.x, bend.y);
    band = kDoubt * steepestAlong(quad, bends, middle, real(0.5) * abs(rate) + abs(bending), steepness);
    return makeCurvedChord(g_start, g_end - g_start - bend_g, bend_g, chordTwist(bends, rate, bending));
}

// Whether g falls all along the chord and ends below the band: then its one root is the first. Steeply enough that the
// parabola's slope is right to a tenth, so that the refinement's two steps reach it.
bool fallsThrough(const Chord chord, const real band) {
    real steepest_rise = max(chord.slope, chord.slope + real(2) * chord.bend);
    return chord.g + chord.slope + chord.bend < -band && steepest_rise < real(-100) * chord.miss;
}

void filterStep(INOUT(FilterWalk) walk, const Piece piece, const MapData map, const real scale,
                const bool may_be_inside) {
    Patch quad = fetchPatch(map, scale, wrappedCell(walk, map));
    real height = rowHeight(map, walk.cell.y);
    real rows_per_height = height < real(1) ? real(2) : real(1);
    Reach reach = reachOf(walk, piece, map, height);
    real by = lesser(lesser(lesser(reach.to_u.by, reach.to_v.by), real(1) - walk.x), walk.longest);

    vec3 per_place = vec3(real(1), rows_per_height, real(1));
    vec2 steepness = vec2(piece.steepness.x, piece.steepness.y * rows_per_height);
    real band;
    Chord chord = curvedChord(quad, reach.place * per_place, by * reach.rate * per_place, (by * by) * piece.bend * per_place,
                              steepness, band);
    real wide = band + chord.miss;
    bool narrow = chord.miss <= kEnoughOfDoubt * band || by * piece.extent <= real(4) * kShortestChord;

    bool inside = may_be_inside && chord.g < -wide;
    bool falls = chord.g > real(0) && (fallsThrough(chord, wide) || (narrow && chord.lowest < -wide));
    // Written so that any NaN is a doubt.
    bool free = chord.lowest > wide && chord.g > real(0);
    bool halve = !inside && !falls && !free && !narrow;
    bool goes_on = halve || by < real(1) - walk.x;
    walk.verdict = inside ? kInside : (falls ? kHit : (!free && narrow ? kDoubtful : (goes_on ? kGoing : kFree)));
    walk.by = by;
    walk.parabola = vec3(chord.g, chord.slope, chord.bend);
    walk.beyond = vec2(chord.cubic, chord.quartic);
    // The limit that was not too long is doubled, not the chord, which an edge may have cut to nothing.
    walk.longest = halve ? real(0.5) * by : real(2) * walk.longest;
    if (walk.verdict == kGoing && !halve) walkOn(walk, reach);
}
