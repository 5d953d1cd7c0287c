// The exact marcher: first hit of a ray with the displaced sphere, in three steps. Traverse skips cells of a cube-map
// pyramid of height maxima until the ray dips below one at the finest level; walk (walk.glsl) goes through the map's own
// cells there and finds the first root along each chord; refine polishes it. Object space, units of R. Expects walk.glsl
// and the resource functions faceRow(map, axis, sign), boundAt(map, face_row, side, i, j) and horizonAt(map, face_row, i, j).

// Loops whose iterations differ from ray to ray, here and elsewhere, test their limit at the start and their end at the end: rule L1
// of docs/design.md. A test for the end at the start would run the body once more on lavapipe, which goes on until no lane is
// left. With a test at the end alone, lanes that left early would read what the body computes later: Mesa 22.3 masks what it
// keeps from one iteration to the next and what meets behind several exits, but no other values.

// A line in the gnomonic coordinates of one cube face: a = (ca + s da) / (cm + s dm), b likewise. Face axis k = 0, 1, 2
// (+ sign), a on axis k + 1, b on axis k + 2, each mirrored so that it grows along the line.
struct FaceRay {
    real ca, cb, cm, da, db, dm;
    bool mirrors_a, mirrors_b;
};

real component(const vec3 v, const int axis) {
    return axis == 0 ? v.x : (axis == 1 ? v.y : v.z);
}

int nextAxis(const int axis) {
    return axis == 2 ? 0 : axis + 1;
}

int previousAxis(const int axis) {
    return axis == 0 ? 2 : axis - 1;
}

FaceRay faceRay(const Ray ray, const int axis, const real sign_of_face) {
    int axis_a = nextAxis(axis);
    int axis_b = previousAxis(axis);
    FaceRay face;
    real ca = component(ray.c, axis_a);
    real cb = component(ray.c, axis_b);
    real da = component(ray.d, axis_a);
    real db = component(ray.d, axis_b);
    face.cm = component(ray.c, axis) * sign_of_face;
    face.dm = component(ray.d, axis) * sign_of_face;
    precise real turn_a = face.cm * da - ca * face.dm;
    precise real turn_b = face.cm * db - cb * face.dm;
    face.mirrors_a = !(turn_a > real(0));
    face.mirrors_b = !(turn_b > real(0));
    face.ca = face.mirrors_a ? -ca : ca;
    face.da = face.mirrors_a ? -da : da;
    face.cb = face.mirrors_b ? -cb : cb;
    face.db = face.mirrors_b ? -db : db;
    return face;
}

// Where the line reaches face coordinate `edge` ahead of it, never before s; kInfinity if it never does: exactly when
// the denominator is not positive. (Here and below choices are spelled out: min and max would cost a test for NaN more.)
real edgeCrossing(const real edge, const real c_along, const real d_along, const real cm, const real dm, const real s) {
    real rate = d_along - edge * dm;
    real crossing = (edge * cm - c_along) / rate;
    return rate > real(0) ? (crossing > s ? crossing : s) : kInfinity;
}

// State of the traversal: a cell (i, j) of a level of a face, which has side x side cells, entered at s; counted along the
// mirrored coordinates.
struct Cursor {
    int axis, side, i, j;
    real sign_of_face, width, s;  // width: of a cell, in face coordinates
    real leaf_end;                // of a leaf: the ray is below the cell's bound on [s, leaf_end]
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
    int next = nextAxis(at.axis);
    int previous = previousAxis(at.axis);
    at.axis = at.across_a ? next : previous;
    at.sign_of_face = (at.across_a ? face.mirrors_a : face.mirrors_b) ? real(-1) : real(1);
}

// One step: descend below a bound that the ray dips under, or leave the cell. Choices instead of branches: what a branch
// assigns is copied once more under lavapipe's masks (rule L12).
void traverseStep(INOUT(Cursor) at, const FaceRay face, const int face_row, const Ray ray, const MapData map,
                  const real s_end) {
    real corner_a = real(at.i) * at.width - real(1);
    real corner_b = real(at.j) * at.width - real(1);
    real s_a = edgeCrossing(corner_a + at.width, face.ca, face.da, face.cm, face.dm, at.s);
    real s_b = edgeCrossing(corner_b + at.width, face.cb, face.db, face.cm, face.dm, at.s);
    bool leaves_a = s_a <= s_b;
    real s_exit = leaves_a ? s_a : s_b;
    int last = at.side - 1;
    int column = face.mirrors_a ? last - at.i : at.i;
    int row = face.mirrors_b ? last - at.j : at.j;
    real margin = boundAt(map, face_row, at.side, column, row) - ray.c2;  // s^2 below which the ray is under it
    real half_chord = sqrt(max(margin, real(0)));
    // A leaf that was walked to its end is not entered again: s is where it ended.
    bool below = margin > real(0) && at.s < half_chord && s_exit > -half_chord && at.s < s_exit;
    bool finest = at.side == map.bounds_side;
    bool down = below && !finest;

    real entry = at.s < -half_chord ? -half_chord : at.s;
    real half_width = real(0.5) * at.width;
    real major = face.cm + entry * face.dm;
    bool far_a = face.ca + entry * face.da >= (corner_a + half_width) * major;
    bool far_b = face.cb + entry * face.db >= (corner_b + half_width) * major;

    int i = at.i + (leaves_a ? 1 : 0);
    int j = at.j + (leaves_a ? 0 : 1);
    bool outside = (leaves_a ? i : j) > last;
    bool up = !below && !outside && ((leaves_a ? i : j) & 1) == 0 && at.side > 1;

    real exit = s_exit < half_chord ? s_exit : half_chord;
    at.leaf = below && finest && entry < s_end;
    at.leaf_end = exit < s_end ? exit : s_end;
    at.turned = outside && !below;
    at.across_a = leaves_a;
    at.s = below ? entry : s_exit;
    int kept_i = below ? at.i : i;
    int kept_j = below ? at.j : j;
    at.i = down ? 2 * at.i + (far_a ? 1 : 0) : (up ? kept_i >> 1 : kept_i);
    at.j = down ? 2 * at.j + (far_b ? 1 : 0) : (up ? kept_j >> 1 : kept_j);
    at.side = down ? at.side << 1 : (up ? at.side >> 1 : at.side);
    at.width = down ? half_width : (up ? real(2) * at.width : at.width);
}

// Whether the ray starts at or above the ground and rises so steeply that no ground can be met: the tangent of its angle
// above the horizontal plane is s_min / |c|.
bool escapes(const Ray ray, const MapData map) {
    Cursor at;
    vec3 p = ray.c + ray.s_min * ray.d;
    chooseFace(at, p);
    int side = map.bounds_side >> 2;
    real major = abs(component(p, at.axis));
    int i = cellIndex(component(p, nextAxis(at.axis)), major, side);
    int j = cellIndex(component(p, previousAxis(at.axis)), major, side);
    vec2 horizon = horizonAt(map, faceRow(map, at.axis, at.sign_of_face), i, j);
    real square = ray.s_min * ray.s_min;
    return ray.s_min > real(0) && square > horizon.x * ray.c2 && square + ray.c2 >= horizon.y;
}

// Puts the cursor where the ray enters the shell; false if it meets nothing for certain, or is NaN. s_end: where the ray leaves it. The
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
    return margin > real(0) && at.s < s_end && !(ray.may_escape && escapes(ray, map));
}

// Searches the whole ray; walk.hit, .inside, .frame and .sigma tell the answer, to be refined.
ExactWalk march(const Ray ray, const MapData map, const Pair base, const real scale, const real shell_squared) {
    ExactWalk walk;
    walk.hit = false;
    walk.inside = false;
    walk.below = false;
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
            walk = startWalk(ray, map, plan, base, walk.below, at.s, at.leaf_end);
            while (steps < MAX_STEPS) {
                exactStep(walk, plan, ray, map, scale);
                steps += 4;
                if (!walk.going || missesTile()) break;
            }
            at.s = at.leaf_end;
            at.leaf = false;
        }
        if (at.turned) turnFace(at, face);
        if (walk.hit || missesTile() || !(at.s < s_end)) break;
    }
    walk.steps = steps;
    walk.exhausted = steps >= MAX_STEPS;
    if (walk.exhausted) giveUp();
    return walk;
}
