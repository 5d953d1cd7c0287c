// A chord through a cell of a bilinear surface. Expects makeChord() and patch.glsl.

// The patch's twist makes the terms beyond the parabola, by the bends of fu and fv along the chord.
Chord solveChord(const PatchPoint start, const PatchPoint middle, const PatchPoint end, const Patch quad) {
    real twist = quad.d;
    real bend = real(2) * (start.g + end.g - real(2) * middle.g);
    real bend_u = real(2) * (start.fu + end.fu - real(2) * middle.fu);
    real bend_v = real(2) * (start.fv + end.fv - real(2) * middle.fv);
    real slope_u = end.fu - start.fu - bend_u;
    real slope_v = end.fv - start.fv - bend_v;
    return makeChord(start.g, end.g - start.g - bend, bend, twist * (slope_u * bend_v + slope_v * bend_u),
                     twist * bend_u * bend_v);
}
