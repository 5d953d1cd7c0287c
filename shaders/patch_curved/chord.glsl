// A chord through a cell of a curved surface. Expects makeChord() and patch.glsl.

// Beyond the parabola through three points is at most 1 / (72 sqrt 3) of the third derivative; its slope is off by a
// twelfth of that, which matters where the chord starts on the surface.
Chord makeCurvedChord(const real g, const real slope, const real bend, const real twist) {
    Chord chord = makeChord(g, slope, bend, real(0), real(0));
    chord.miss = real(0.00802) * twist;
    bool rises = slope > real(0.0834) * twist;
    chord.lowest = g > chord.miss || rises ? chord.lowest : min(chord.lowest, chord.miss);
    return chord;
}

Chord solveChord(const PatchPoint start, const PatchPoint middle, const PatchPoint end, const Patch quad) {
    real bend = real(2) * (start.g + end.g - real(2) * middle.g);
    vec2 places = vec2(start.fu, start.fv);
    vec2 bends = real(2) * (places + vec2(end.fu, end.fv) - real(2) * vec2(middle.fu, middle.fv));
    vec2 rate = vec2(end.fu, end.fv) - places - bends;
    return makeCurvedChord(start.g, end.g - start.g - bend, bend, chordTwist(patchBends(quad), rate, bends));
}
