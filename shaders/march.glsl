// The exact marcher: first hit of a ray with the displaced sphere, in three steps. Traverse skips cells of a cube-map
// pyramid of height maxima until the ray dips below one at the finest level; walk goes through the map's own cells
// there and finds the first root along each chord; refine makes that root a correctly rounded one.
// Object space, units of R. Expects surface.glsl and the resource function boundAt(map, face, level, i, j).

// p(s) = c + s d, d unit, c the point closest to the centre: |p|^2 = |c|^2 + s^2, free of cancellation at any distance.
struct Ray {
    vec3 c, d;
    real c2;              // |c|^2
    real s_min, s_max;
    bool may_start_inside;  // camera rays: a start inside the solid is a hit; secondary rays: only going in is
};

// The refined hit.
struct Crossing {
    real s;
    vec3 p, gradient;  // gradient of f = |p| - r: its direction is the normal
    PatchPoint at;
};

// A chord of this share of the distance to the axis (or the centre) is a parabola within 1e-7 of the surface.
const real kChordShare = real(0.02);
const real kShortestChord = real(2.5e-7);
// How far from 0 the parabola's verdict is trusted; the contract excuses 1e-6.
const real kTrust = real(1.5e-7);

// A line in the gnomonic coordinates of one cube face: a = (ca + s da) / (cm + s dm), b likewise. Face axis k = 0, 1, 2
// (+ sign), a on axis k + 1, b on axis k + 2.
struct FaceRay {
    real ca, cb, cm, da, db, dm;
    bool a_grows, b_grows;
};

real component(vec3 v, int axis) {
    return axis == 0 ? v.x : (axis == 1 ? v.y : v.z);
}

FaceRay faceRay(Ray ray, int axis, real sign_of_face) {
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
// the denominator has the sign against the direction of travel.
real edgeCrossing(real edge, real c_along, real d_along, real cm, real dm, bool grows, real s) {
    real rate = d_along - edge * dm;
    bool reached = grows ? rate > real(0) : rate < real(0);
    return reached ? max(s, (edge * cm - c_along) / rate) : kInfinity;
}

// State of the traversal: a cell (i, j) of a level (0 the finest) of a face, entered at s.
struct Cursor {
    int axis, level, i, j;
    real sign_of_face, s;
    real leaf_end;   // set when a leaf is found: the ray is below the cell's bound on [s, leaf_end]
    bool leaf, turned, skip;  // turned: just crossed to another face, (i, j) to be found anew
};

int faceIndex(Cursor at) {
    return at.axis * 2 + (at.sign_of_face < real(0) ? 1 : 0);
}

void chooseFace(INOUT(Cursor) at, vec3 p) {
    vec3 size = abs(p);
    at.axis = size.x >= size.y && size.x >= size.z ? 0 : (size.y >= size.z ? 1 : 2);
    at.sign_of_face = component(p, at.axis) < real(0) ? real(-1) : real(1);
    at.turned = true;
}

int cellIndex(real along, real major, int side) {
    real coordinate = along / max(major, real(1e-20));
    return clamp(int((coordinate * real(0.5) + real(0.5)) * real(side)), 0, side - 1);
}

// One step: descend below a bound that the ray dips under, or leave the cell.
void traverseStep(INOUT(Cursor) at, FaceRay face, Ray ray, MapData map, real s_end) {
    int side = map.bounds_side >> at.level;
    real width = real(2) / real(side);
    real edge_a = real(face.a_grows ? at.i + 1 : at.i) * width - real(1);
    real edge_b = real(face.b_grows ? at.j + 1 : at.j) * width - real(1);
    real s_a = edgeCrossing(edge_a, face.ca, face.da, face.cm, face.dm, face.a_grows, at.s);
    real s_b = edgeCrossing(edge_b, face.cb, face.db, face.cm, face.dm, face.b_grows, at.s);
    real s_exit = min(s_a, s_b);
    real margin = boundAt(map, faceIndex(at), at.level, at.i, at.j) - ray.c2;  // s^2 below which the ray is under it
    real nearest = clamp(real(0), at.s, s_exit);
    bool below = nearest * nearest < margin && !at.skip;
    bool finest = at.level == 0;
    if (below) {
        real half_chord = sqrt(max(margin, real(0)));
        at.s = max(at.s, -half_chord);
        at.leaf = finest;
        at.leaf_end = min(min(s_exit, half_chord), s_end);
        if (!finest) {
            real major = face.cm + at.s * face.dm;
            real mid_a = (real(at.i) + real(0.5)) * width - real(1);
            real mid_b = (real(at.j) + real(0.5)) * width - real(1);
            at.i = 2 * at.i + (face.ca + at.s * face.da >= mid_a * major ? 1 : 0);
            at.j = 2 * at.j + (face.cb + at.s * face.db >= mid_b * major ? 1 : 0);
            at.level -= 1;
        }
    } else {
        bool leaves_a = s_a <= s_b;
        int i = at.i + (leaves_a ? (face.a_grows ? 1 : -1) : 0);
        int j = at.j + (leaves_a ? 0 : (face.b_grows ? 1 : -1));
        at.s = s_exit;
        at.turned = i < 0 || j < 0 || i >= side || j >= side;
        if (at.turned) {
            at.axis = leaves_a ? (at.axis == 2 ? 0 : at.axis + 1) : (at.axis == 0 ? 2 : at.axis - 1);
            at.sign_of_face = (leaves_a ? face.a_grows : face.b_grows) ? real(1) : real(-1);
        } else {
            bool up = ((i ^ at.i) | (j ^ at.j)) > 1 && at.level + 1 < map.bounds_levels;
            at.i = up ? i >> 1 : i;
            at.j = up ? j >> 1 : j;
            at.level += up ? 1 : 0;
        }
    }
    at.skip = false;
}

// What does not change along a ray through the map's cells.
struct WalkPlan {
    bool east;        // longitude grows along the ray
    real s_turn;      // where the latitude is extreme
    real across_axis; // share of d across the axis: how fast the ray can approach it
};

WalkPlan planWalk(Ray ray) {
    WalkPlan plan;
    plan.east = ray.c.z * ray.d.x - ray.c.x * ray.d.z > real(0);
    real rise = ray.d.y * ray.c2;
    plan.s_turn = ray.c.y != real(0) ? clamp(rise / ray.c.y, -kInfinity, kInfinity)
                                     : (rise > real(0) ? kInfinity : -kInfinity);
    plan.across_axis = sqrt(max(real(1) - ray.d.y * ray.d.y, real(1e-12)));
    return plan;
}

// Where the ray meets the meridian plane of an edge that lies ahead of it: linear in s.
real meridianCrossing(Ray ray, Patch quad, bool east, real s) {
    real side = east ? real(1) : real(-1);
    real sin_e = side * (east ? quad.lon.z : quad.lon.x);
    real cos_e = side * (east ? quad.lon.w : quad.lon.y);
    real rate = ray.d.x * cos_e - ray.d.z * sin_e;
    real start = ray.c.x * cos_e - ray.c.z * sin_e;
    return rate > real(0) ? max(s, -start / rate) : kInfinity;
}

// Where the ray meets the cone of a parallel, y = |p| cos_e, going south or north: with E^2 = c_y^2 + |c|^2 (d_y^2 -
// cos_e^2), s = (c_y d_y +- cos_e E) / (cos_e^2 - d_y^2), + southward; the conjugate form where that would cancel.
real parallelCrossing(Ray ray, real cos_e, bool south, real s) {
    real slack = (cos_e - ray.d.y) * (cos_e + ray.d.y);
    real square = ray.c.y * ray.c.y - ray.c2 * slack;
    real swing = cos_e * sqrt(max(square, real(0)));
    swing = south ? swing : -swing;
    real tilt = ray.c.y * ray.d.y;
    real crossing = tilt * swing >= real(0) ? (tilt + swing) / slack
                                            : (ray.c2 * cos_e * cos_e - ray.c.y * ray.c.y) / (tilt - swing);
    // The other nappe, or a crossing far behind, is none; rounding may put a true one a little behind.
    real height = ray.c.y + crossing * ray.d.y;
    bool real_one = square > real(0) && height * (cos_e < real(0) ? real(-1) : real(1)) >= real(-1e-6) &&
                    crossing >= s - real(0.01) && crossing < kInfinity;
    return real_one ? max(s, crossing) : kInfinity;
}

// One chord of a cell as a parabola through its ends and middle.
struct Chord {
    bool hit, unsure;
    real fraction;  // of the chord, where it hits
};

// First root on a chord where f(0) = g0 >= 0. The parabola misses the surface by the product of the patch's twist and
// the bends of fu and fv along the chord; where that could change the verdict the chord is unsure and must be halved.
Chord solveChord(PatchPoint start, PatchPoint middle, PatchPoint end, real twist) {
    real bend = real(2) * (start.g + end.g - real(2) * middle.g);
    real slope = end.g - start.g - bend;
    real bend_u = real(2) * (start.fu + end.fu - real(2) * middle.fu);
    real bend_v = real(2) * (start.fv + end.fv - real(2) * middle.fv);
    real slope_u = end.fu - start.fu - bend_u;
    real slope_v = end.fv - start.fv - bend_v;
    real miss = abs(twist) * (real(0.05) * abs(slope_u * bend_v + slope_v * bend_u) + real(0.1) * abs(bend_u * bend_v));

    real lowest_at = slope < real(0) && bend > real(0) ? min(real(-0.5) * slope / bend, real(1)) : real(1);
    real lowest = min(start.g + lowest_at * (slope + lowest_at * bend), end.g);
    Chord chord;
    chord.hit = lowest <= real(0);
    chord.unsure = miss > kTrust && lowest <= miss;
    chord.fraction = clamp(firstRoot(start.g, slope, bend), real(0), real(1));
    return chord;
}

// Walk of the map's cells on [s, leaf_end], where the ray is below the leaf's bound.
struct Walk {
    bool hit, inside, going, exhausted;
    ivec2 cell;
    real s;           // where the walk stands; after a hit, the root
    real low, s_far;  // ends of the chord that holds the root
    real longest;     // chord length limit: halved where a parabola was unsure
    PatchPoint here;
    int steps;  // height and bound fetches of the whole march
};

void walkStep(INOUT(Walk) walk, WalkPlan plan, Ray ray, MapData map, real base, real scale, real leaf_end) {
    Patch quad = fetchPatch(map, base, scale, walk.cell);
    bool before = walk.s < plan.s_turn;
    bool south = before != (ray.c.y >= real(0));
    real s_u = meridianCrossing(ray, quad, plan.east, walk.s);
    bool pole_edge = south ? walk.cell.y == map.rows - 1 : walk.cell.y == 0;
    real s_v = pole_edge ? kInfinity : parallelCrossing(ray, south ? quad.lat.w : quad.lat.y, south, walk.s);
    vec3 p = ray.c + walk.s * ray.d;
    real rho = sqrt(p.x * p.x + p.z * p.z);
    real radius = sqrt(ray.c2 + walk.s * walk.s);
    real limit = min(kChordShare * min(rho / plan.across_axis, radius), walk.longest);
    real s_far = min(min(s_u, s_v), min(leaf_end, walk.s + max(limit, kShortestChord)));
    s_far = before ? min(s_far, plan.s_turn) : s_far;

    real s_mid = real(0.5) * (walk.s + s_far);
    PatchPoint middle = patchPoint(map, quad, ray.c + s_mid * ray.d, sqrt(ray.c2 + s_mid * s_mid));
    PatchPoint end = patchPoint(map, quad, ray.c + s_far * ray.d, sqrt(ray.c2 + s_far * s_far));
    Chord chord = solveChord(walk.here, middle, end, quad.d);
    real length_of_chord = s_far - walk.s;
    if (chord.unsure && length_of_chord > real(4) * kShortestChord) {
        walk.longest = real(0.5) * length_of_chord;
    } else if (chord.hit) {
        walk.hit = true;
        walk.going = false;
        walk.low = walk.s;
        walk.s_far = s_far;
        walk.s += chord.fraction * length_of_chord;
    } else {
        bool crosses_u = s_u <= s_far;
        bool crosses_v = s_v <= s_far;
        walk.here = end;
        walk.here.g = max(end.g, real(0));
        walk.here.fu -= crosses_u ? (plan.east ? real(1) : real(-1)) : real(0);
        walk.here.fv -= crosses_v ? (south ? real(1) : real(-1)) : real(0);
        walk.cell.x = wrapColumn(walk.cell.x + (crosses_u ? (plan.east ? 1 : -1) : 0), map.width);
        walk.cell.y += crosses_v ? (south ? 1 : -1) : 0;
        walk.s = s_far;
        walk.longest = real(2) * max(walk.longest, kShortestChord);
        walk.going = s_far < leaf_end;
    }
}

// Enters a leaf: finds the cell, and what the ray's own start means.
void startWalk(INOUT(Walk) walk, Ray ray, MapData map, real base, real scale, Cursor at) {
    vec3 p = ray.c + at.s * ray.d;
    walk.cell = locateCell(map, p);
    walk.here = patchPoint(map, fetchPatch(map, base, scale, walk.cell), p, sqrt(ray.c2 + at.s * at.s));
    bool at_start = at.s <= ray.s_min;
    // The ray came from above a bound, so only its own start can lie deeper inside than rounding.
    walk.hit = walk.here.g <= real(0) && !(at_start && !ray.may_start_inside);
    walk.inside = walk.hit && at_start;
    walk.here.g = max(walk.here.g, real(0));
    walk.going = !walk.hit;
    walk.s = at.s;
    walk.low = at.s;
    walk.s_far = at.leaf_end;
    walk.longest = kInfinity;
}

// Searches the whole ray; walk.hit, .inside, .cell and .s tell the answer, to be refined.
Walk march(Ray ray, MapData map, real base, real scale, real shell_squared) {
    Walk walk;
    walk.hit = false;
    walk.inside = false;
    walk.exhausted = false;
    walk.steps = 0;
    real margin = shell_squared - ray.c2;
    real half_chord = sqrt(max(margin, real(0)));
    real s_end = min(ray.s_max, half_chord);
    Cursor at;
    at.s = max(ray.s_min, -half_chord);
    // Written so that any NaN ends here.
    bool searching = margin > real(0) && at.s < s_end;
    if (searching) chooseFace(at, ray.c + at.s * ray.d);
    at.level = map.bounds_levels - 1;
    at.leaf = false;
    at.skip = false;
    at.leaf_end = s_end;
    at.i = 0;
    at.j = 0;
    int steps = 0;
    WalkPlan plan = planWalk(ray);
    while (searching) {
        FaceRay face = faceRay(ray, at.axis, at.sign_of_face);
        if (at.turned) {
            int side = map.bounds_side >> at.level;
            real major = face.cm + at.s * face.dm;
            at.i = cellIndex(face.ca + at.s * face.da, major, side);
            at.j = cellIndex(face.cb + at.s * face.db, major, side);
            at.turned = false;
        }
        // Heavy code stays out of this loop: under masks every lane would pay for it at each step.
        while (!at.leaf && !at.turned && at.s < s_end && steps < MAX_STEPS) {
            traverseStep(at, face, ray, map, s_end);
            steps += 1;
        }
        if (at.leaf) {
            startWalk(walk, ray, map, base, scale, at);
            steps += 4;
            while (walk.going && steps < MAX_STEPS) {
                walkStep(walk, plan, ray, map, base, scale, at.leaf_end);
                steps += 4;
            }
            at.s = at.leaf_end;
            at.leaf = false;
            at.skip = true;
        }
        searching = !walk.hit && at.s < s_end && steps < MAX_STEPS;
    }
    walk.steps = steps;
    walk.exhausted = steps >= MAX_STEPS;
    return walk;
}

// Newton on the true f, kept inside the chord; its last gradient is the normal's direction.
Crossing refine(Ray ray, MapData map, real base, real scale, Walk walk) {
    Patch quad = fetchPatch(map, base, scale, walk.cell);
    Crossing crossing;
    crossing.s = walk.s;
    for (int i = 0; i < 3; ++i) {
        crossing.p = ray.c + crossing.s * ray.d;
        crossing.at = patchPoint(map, quad, crossing.p, length(crossing.p));
        crossing.gradient = patchGradient(map, quad, crossing.at, crossing.p);
        real rate = dot(crossing.gradient, ray.d);
        bool steep = abs(rate) > real(1e-6) * length(crossing.gradient);
        real stride = steep && !walk.inside && i < 2 ? crossing.at.g / rate : real(0);
        crossing.s = clamp(crossing.s - stride, walk.low, walk.s_far);
    }
    return crossing;
}
