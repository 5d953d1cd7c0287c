// The exact marcher: first hit of a ray with the displaced sphere, in three steps. Traverse skips cells of a cube-map
// pyramid of height maxima until the ray dips below one at the finest level; walk (walk.glsl) goes through the map's own
// cells there and finds the first root along each chord; refine polishes it. Object space, units of R. Expects walk.glsl
// and the resource functions faceRow(map, axis, sign) and boundAt(map, face_row, side, i, j).

// A line in the gnomonic coordinates of one cube face: a = (ca + s da) / (cm + s dm), b likewise. Face axis k = 0, 1, 2
// (+ sign), a on axis k + 1, b on axis k + 2.
struct FaceRay {
    real ca, cb, cm, da, db, dm;
    bool a_grows, b_grows;
};

real component(const vec3 v, const int axis) {
    return axis == 0 ? v.x : (axis == 1 ? v.y : v.z);
}

FaceRay faceRay(const Ray ray, const int axis, const real sign_of_face) {
    int axis_a = axis == 2 ? 0 : axis + 1;
    int axis_b = axis == 0 ? 2 : axis - 1;
    FaceRay face;
    face.ca = component(ray.c, axis_a);
    face.cb = component(ray.c, axis_b);
    face.cm = component(ray.c, axis) * sign_of_face;
    face.da = component(ray.d, axis_a);
    face.db = component(ray.d, axis_b);
    face.dm = component(ray.d, axis) * sign_of_face;
    precise real turn_a = face.cm * face.da - face.ca * face.dm;
    precise real turn_b = face.cm * face.db - face.cb * face.dm;
    face.a_grows = turn_a > real(0);
    face.b_grows = turn_b > real(0);
    return face;
}

// Where the line reaches face coordinate `edge` ahead of it, never before s; kInfinity if it never does: exactly when
// the denominator has the sign against the direction of travel. (Here and below choices are spelled out: min and max
// would cost a test for NaN more.)
real edgeCrossing(const real edge, const real c_along, const real d_along, const real cm, const real dm,
                  const bool grows, const real s) {
    real rate = d_along - edge * dm;
    bool reached = grows ? rate > real(0) : rate < real(0);
    real crossing = (edge * cm - c_along) / rate;
    return reached ? (crossing > s ? crossing : s) : kInfinity;
}

// State of the traversal: a cell (i, j) of a level of a face, which has side x side cells, entered at s.
struct Cursor {
    int axis, side, i, j;
    real sign_of_face, width, s;  // width: of a cell, in face coordinates
    real leaf_end;                // set when a leaf is found: the ray is below the cell's bound on [s, leaf_end]
    bool leaf;
    bool turned, across_a;  // turned: to a face whose cell is not found yet, over an edge of its first coordinate or second
};

void chooseFace(INOUT(Cursor) at, const vec3 p) {
    vec3 size = abs(p);
    at.axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
    at.sign_of_face = component(p, at.axis) < real(0) ? real(-1) : real(1);
}

int cellIndex(const real along, const real major, const int side) {
    real coordinate = along / max(major, real(1e-20));
    return clamp(int((coordinate * real(0.5) + real(0.5)) * real(side)), 0, side - 1);
}

// The cell of the cursor's level that holds the ray at s.
void findCell(INOUT(Cursor) at, const FaceRay face) {
    real major = face.cm + at.s * face.dm;
    at.i = cellIndex(face.ca + at.s * face.da, major, at.side);
    at.j = cellIndex(face.cb + at.s * face.db, major, at.side);
    at.turned = false;
}

// Over the edge of a face to its neighbour; findCell() is still to be called.
void turnFace(INOUT(Cursor) at, const FaceRay face) {
    int next = at.axis == 2 ? 0 : at.axis + 1;
    int previous = at.axis == 0 ? 2 : at.axis - 1;
    at.axis = at.across_a ? next : previous;
    at.sign_of_face = (at.across_a ? face.a_grows : face.b_grows) ? real(1) : real(-1);
}

// One step: descend below a bound that the ray dips under, or leave the cell.
void traverseStep(INOUT(Cursor) at, const FaceRay face, const int face_row, const Ray ray, const MapData map,
                  const real s_end) {
    real edge_a = real(face.a_grows ? at.i + 1 : at.i) * at.width - real(1);
    real edge_b = real(face.b_grows ? at.j + 1 : at.j) * at.width - real(1);
    real s_a = edgeCrossing(edge_a, face.ca, face.da, face.cm, face.dm, face.a_grows, at.s);
    real s_b = edgeCrossing(edge_b, face.cb, face.db, face.cm, face.dm, face.b_grows, at.s);
    bool leaves_a = s_a <= s_b;
    real s_exit = leaves_a ? s_a : s_b;
    real margin = boundAt(map, face_row, at.side, at.i, at.j) - ray.c2;  // s^2 below which the ray is under it
    real half_chord = sqrt(max(margin, real(0)));
    // A leaf that was walked to its end is not entered again: s is where it ended.
    bool below = margin > real(0) && at.s < half_chord && s_exit > -half_chord && at.s < s_exit;
    if (below) {
        at.s = at.s < -half_chord ? -half_chord : at.s;
        at.leaf = at.side == map.bounds_side;
        real exit = s_exit < half_chord ? s_exit : half_chord;
        at.leaf_end = exit < s_end ? exit : s_end;
        if (!at.leaf) {
            real major = face.cm + at.s * face.dm;
            real mid_a = (real(at.i) + real(0.5)) * at.width - real(1);
            real mid_b = (real(at.j) + real(0.5)) * at.width - real(1);
            at.i = 2 * at.i + (face.ca + at.s * face.da >= mid_a * major ? 1 : 0);
            at.j = 2 * at.j + (face.cb + at.s * face.db >= mid_b * major ? 1 : 0);
            at.side *= 2;
            at.width *= real(0.5);
        }
    } else {
        int i = at.i + (leaves_a ? (face.a_grows ? 1 : -1) : 0);
        int j = at.j + (leaves_a ? 0 : (face.b_grows ? 1 : -1));
        at.s = s_exit;
        at.across_a = leaves_a;
        at.turned = ((i | j) < 0) || i >= at.side || j >= at.side;
        bool up = !at.turned && ((i ^ at.i) | (j ^ at.j)) > 1 && at.side > 1;
        at.i = up ? i >> 1 : i;
        at.j = up ? j >> 1 : j;
        at.side = up ? at.side >> 1 : at.side;
        at.width *= up ? real(2) : real(1);
    }
}

// Puts the cursor where the ray enters the shell; false if it never does, or is NaN. s_end: where the ray leaves it. The
// levels above the starting one would only be descended through; a ray that skims the ground climbs to them by itself.
bool startCursor(INOUT(Cursor) at, const Ray ray, const MapData map, const real shell_squared, INOUT(real) s_end) {
    real margin = shell_squared - ray.c2;
    real half_chord = sqrt(max(margin, real(0)));
    s_end = min(ray.s_max, half_chord);
    at.s = max(ray.s_min, -half_chord);
    chooseFace(at, ray.c + at.s * ray.d);
    at.side = ray.may_start_inside ? map.start_side : map.bounds_side >> 1;
    at.width = real(2) / real(at.side);
    at.leaf = false;
    at.across_a = false;
    at.leaf_end = s_end;
    at.i = 0;
    at.j = 0;
    at.turned = true;
    return margin > real(0) && at.s < s_end;
}

// Loops whose turns differ from ray to ray here and elsewhere test their limit at the start and their end at the end. A test
// for the end at the start would run the body once more on lavapipe, which goes on until no lane is left; and with a test
// at the end alone lanes that left early would read what the body computes later (Mesa 22.3 masks what it keeps from turn
// to turn, and what meets behind several exits, but no other values).
//
// Searches the whole ray; walk.hit, .inside, .frame and .sigma tell the answer, to be refined.
Walk march(const Ray ray, const MapData map, const Pair base, const real scale, const real shell_squared) {
    Walk walk;
    walk.hit = false;
    walk.inside = false;
    Cursor at;
    real s_end;
    bool searching = startCursor(at, ray, map, shell_squared, s_end);
    int steps = 0;
    WalkPlan plan = planWalk(ray);
    while (searching && steps < MAX_STEPS) {
        FaceRay face = faceRay(ray, at.axis, at.sign_of_face);
        if (at.turned) findCell(at, face);
        int face_row = faceRow(map, at.axis, at.sign_of_face);
        // Heavy code stays out of this loop: under masks every lane would pay for it at each step.
        while (steps < MAX_STEPS) {
            traverseStep(at, face, face_row, ray, map, s_end);
            steps += 1;
            if (at.leaf || at.turned || !(at.s < s_end)) break;
        }
        if (at.leaf) {
            walk = startWalk(ray, map, plan, base, at.s, at.leaf_end);
            while (steps < MAX_STEPS) {
                walkStep(walk, plan, ray, map, scale);
                steps += 4;
                if (!walk.going) break;
            }
            at.s = at.leaf_end;
            at.leaf = false;
        }
        if (at.turned) turnFace(at, face);
        if (walk.hit || !(at.s < s_end)) break;
    }
    walk.steps = steps;
    walk.exhausted = steps >= MAX_STEPS;
    return walk;
}
