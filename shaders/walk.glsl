// The walk through the map's cells under one leaf of the bounds, and the refined hit. Expects frame.glsl.

// A chord of this share of the distance to the axis (or the centre) is a parabola within 1e-8 of the surface.
const real kChordShare = real(0.0125);
const real kShortestChord = real(2.5e-7);
// A ray that comes this close to a parallel touches it; the frame's own rounding is about 1e-9.
const real kTouch = real(1e-7);
// No crack that a secondary ray's start lies beside is as deep. Rays that start deeper are those of an eye inside the solid: their
// way out would be long, and nothing is lit there.
const real kDeepestCrack = real(0.01);
// How far from 0 the parabola's verdict is trusted; the contract excuses 1e-6.
const real kTrust = real(3e-8);

// What does not change along a ray through the map's cells.
struct WalkPlan {
    bool east;         // longitude grows along the ray
    real across_axis;  // share of d across the axis: how fast the ray can approach it
};

real acrossAxis(const vec3 d) {
    return sqrt(max(real(1) - d.y * d.y, real(1e-12)));
}

// The ray's moment about the axis, to 1e-14: its sign tells on which side of the axis the ray passes, and floats would
// miss that within 1e-7.
real momentAboutAxis(const Line line) {
    Pair plus = exactProduct(line.z.hi, line.dx.hi);
    Pair minus = exactProduct(line.x.hi, line.dz.hi);
    precise real plus_rest = plus.lo + (line.z.hi * line.dx.lo + line.z.lo * line.dx.hi);
    precise real minus_rest = minus.lo + (line.x.hi * line.dz.lo + line.x.lo * line.dz.hi);
    precise real moment = (plus.hi - minus.hi) + (plus_rest - minus_rest);
    return moment;
}

WalkPlan planWalk(const Ray ray) {
    WalkPlan plan;
    plan.east = momentAboutAxis(ray.line) > real(0);
    plan.across_axis = acrossAxis(ray.d);
    return plan;
}

// Where the ray meets the meridian plane of the edge that lies ahead of it: linear in sigma.
real meridianCrossing(const CellFrame frame, const MapData map, const bool east, const real sigma) {
    vec2 start = east ? rotateSmall(frame.place, real(map.sin_width), real(map.versin_width)) : -frame.place;
    vec2 rate = east ? rotateSmall(frame.place_d, real(map.sin_width), real(map.versin_width)) : -frame.place_d;
    return rate.x > real(0) ? max(sigma, -start.x / rate.x) : kInfinity;
}

// Where the ray meets the cone of a parallel, rho cos_e = y sin_e, going south or north, from the frame's anchor. With 2 b and
// a the terms of rho^2 = rho_0^2 + 2 b s + a s^2, m the ray's moment about the centre and E^2 = sin_e^2 |m|^2 - m_y^2,
// s = (y d_y sin_e^2 - b cos_e^2 +- cos_e E) / (a cos_e^2 - d_y^2 sin_e^2), + southward; the conjugate form where that would
// cancel. Near a pole every term is a small number, exact to its own rounding. A ray that fails to touch the cone by
// rounding is taken to touch it.
real coneCrossing(const CellFrame frame, const real d_y, const vec2 cosine_sine, const real beyond_anchor, const bool south,
                  const real sigma) {
    real cosine = cosine_sine.x;
    real sine = cosine_sine.y;
    real y = frame.anchor.y.hi;
    real square = (sine * frame.moment - frame.moment_y) * (sine * frame.moment + frame.moment_y);
    real swing = cosine * sqrt(max(square, real(0)));
    swing = south ? swing : -swing;
    real tilt = y * d_y * sine * sine - frame.rate_rho * cosine * cosine;
    real slack = frame.d_across2 * cosine * cosine - d_y * d_y * sine * sine;
    real crossing = tilt * swing >= real(0) ? (tilt + swing) / slack
                                            : beyond_anchor * (frame.rho * cosine + y * sine) / (tilt - swing);
    // The other nappe, or a crossing far behind, is none; rounding may put a true one a little behind.
    real height = y + crossing * d_y;
    bool true_one = square > real(-1e-6) * frame.moment * frame.moment &&
                    height * (cosine < real(0) ? real(-1) : real(1)) >= real(-1e-6) &&
                    crossing >= sigma - real(0.01) && crossing < kInfinity;
    return true_one ? crossing : kInfinity;
}

// Step from where a + b x + c x^2 / 2 was taken to its root with the derivative's sign `rising`. A parabola that fails to
// touch zero by rounding is taken to touch it: else a ray could cross an edge and not find its way back. kInfinity without
// a root.
real stepToRoot(const real a, const real b, const real c, const bool rising) {
    real square = b * b - real(2) * a * c;
    bool touches = abs(square) <= kTouch * real(2) * abs(c);
    real slope = sqrt(max(square, real(0)));
    slope = rising ? slope : -slope;
    real root = b * slope > real(0) ? real(-2) * a / (b + slope) : (slope - b) / c;
    return square >= real(0) || touches ? root : kInfinity;
}

// The same in the frame: the cone of the rounded ray, then one step on the edge's own small coordinate as a parabola. A
// Newton step, which has no second derivative, goes astray where the ray is about to touch the cone.
real parallelCrossing(const CellFrame frame, const real d_y, const MapData map, const bool south, const Local here,
                      const real sigma) {
    vec2 rotation = south ? rowRotation(map, frame.cell.y) : vec2(real(0));
    real beyond_here = rotateSmall(here.slant, rotation.x, rotation.y).x;
    if (south ? beyond_here > real(0) : beyond_here < real(0)) return sigma;
    vec2 cosine_sine = rotateSmall(vec2(frame.edge.y, frame.edge.x), rotation.x, rotation.y);
    real beyond_anchor = rotateSmall(frame.slant, rotation.x, rotation.y).x;
    real crossing = coneCrossing(frame, d_y, cosine_sine, beyond_anchor, south, sigma);
    if (!(crossing < real(1))) return kInfinity;
    Local local = localAt(frame, d_y, crossing);
    real beyond = rotateSmall(local.slant, rotation.x, rotation.y).x;
    real rho = max(local.rho, kTiny);
    real outward = (frame.rate_rho + crossing * frame.d_across2) / rho;
    real rate = outward * cosine_sine.x - d_y * cosine_sine.y;
    real bend = cosine_sine.x * (frame.d_across2 - outward * outward) / rho;
    real correction = stepToRoot(beyond, rate, bend, south);
    return correction < kInfinity ? max(sigma, crossing + clamp(correction, real(-0.01), real(0.01))) : kInfinity;
}

// One chord of a cell as the parabola g + y (slope + y bend) through its ends and middle, y in [0, 1].
struct Chord {
    real g, slope, bend;
    real cubic, quartic;  // terms of g beyond the parabola, where they are known: see alongChord()
    real lowest;          // of the parabola after the start
    real miss;            // how far g along the chord can be from it
};

// `cubic` and `quartic`: g's own terms beyond the parabola, which interpolates them with an error of at most 0.05 and 0.1.
Chord makeChord(const real g, const real slope, const real bend, const real cubic, const real quartic) {
    Chord chord;
    chord.g = g;
    chord.slope = slope;
    chord.bend = bend;
    chord.cubic = cubic;
    chord.quartic = quartic;
    real end = g + slope + bend;
    real vertex = real(-0.5) * slope;  // times 1 / bend
    bool dips = slope < real(0) && vertex < bend;
    chord.lowest = dips ? g + real(0.5) * slope * vertex / bend : end;
    chord.miss = real(0.05) * abs(cubic) + real(0.1) * abs(quartic);
    return chord;
}

// Whether a chord that starts below 0 is above 0 somewhere before its end.
bool comesOut(const Chord chord) {
    real vertex = real(-0.5) * chord.slope;  // times 1 / bend
    bool peaks = chord.slope > real(0) && vertex > chord.bend;
    return peaks && chord.slope * chord.slope > real(4) * chord.g * chord.bend;
}

#include "chord.glsl"

// Where a chord's parabola (g, slope, bend) falls to 0 first, as a share of the chord.
real parabolaRoot(const vec3 parabola) {
    return clamp(firstRoot(parabola.x, parabola.y, parabola.z), real(0), real(1));
}

struct ExactWalk {
    bool hit, inside, going, exhausted;
    bool first;       // at the leaf's first chord
    bool at_start;    // where the ray itself starts
    bool below;       // a secondary ray that rises from inside the solid and is not out yet
    CellFrame frame;
    real sigma, end;  // where the walk stands, and ends; after a hit, sigma is the root
    real extreme;     // sigma where the latitude is extreme
    bool southward;   // beyond it
    real low, high;   // ends of the chord that holds the root
    real longest;     // chord length limit: halved where a parabola was unsure
    int steps;        // height and bound fetches of the whole march
};

// The ray is below the leaf's bound on [s, s_end]. below: whether the leaf before ended inside the solid.
ExactWalk startWalk(const Ray ray, const MapData map, const WalkPlan plan, const Pair base, const bool below, const real s,
                    const real s_end) {
    ExactWalk walk;
    walk.frame = makeFrame(ray, map, base, s);
    walk.hit = false;
    walk.inside = false;
    walk.going = true;
    walk.first = true;
    walk.at_start = s <= ray.s_min;
    walk.below = below;
    walk.sigma = s - walk.frame.anchor.s;
    settleCell(walk.frame, map, plan.east, isOnAxis(ray.c + s * ray.d, ray.d), ray.d.y, walk.sigma);
    walk.end = s_end - walk.frame.anchor.s;
    // The colatitude's rate has the sign of turn + sigma c_y, c the ray's point closest to the centre.
    real turn = walk.frame.rate_rho * walk.frame.anchor.y.hi - walk.frame.rho * walk.frame.rho * ray.d.y;
    real c_y = walk.frame.d_across2 * walk.frame.anchor.y.hi - walk.frame.rate_rho * ray.d.y;
    walk.extreme = c_y != real(0) ? clamp(-turn / c_y, -kInfinity, kInfinity) : -kInfinity;
    walk.southward = c_y != real(0) ? c_y > real(0) : turn > real(0);
    walk.low = walk.sigma;
    walk.high = walk.end;
    walk.longest = kInfinity;
    return walk;
}

void exactStep(INOUT(ExactWalk) walk, const WalkPlan plan, const Ray ray, const MapData map, const real scale) {
    CellFrame frame = walk.frame;
    Patch quad = fetchPatch(map, scale, frame.cell);
    bool before = walk.sigma < walk.extreme;
    bool south = before != walk.southward;
    bool pole_edge = south ? frame.cell.y == map.rows - 1 : frame.cell.y == 0;
    real to_u = meridianCrossing(frame, map, plan.east, walk.sigma);
    Local here = localAt(frame, ray.d.y, walk.sigma);
    real to_v = pole_edge ? kInfinity : parallelCrossing(frame, ray.d.y, map, south, here, walk.sigma);

    // Across the axis the shortest chord is what counts too: along it the ray may be parallel to the axis, and long.
    real sideways = max(kChordShare * here.rho, kShortestChord) / plan.across_axis;
    real limit = min(min(sideways, kChordShare * frame.radius), walk.longest);
    real far = min(min(to_u, to_v), min(walk.end, walk.sigma + max(limit, kShortestChord)));
    far = before ? min(far, walk.extreme) : far;
    PatchPoint start = patchPoint(map, quad, frame, here);
    PatchPoint middle = patchPoint(map, quad, frame, localAt(frame, ray.d.y, real(0.5) * (walk.sigma + far)));
    PatchPoint end = patchPoint(map, quad, frame, localAt(frame, ray.d.y, far));

    // The ray came from above a bound, so only its own start can lie deeper inside than rounding. Where a secondary ray rises
    // from there (in a crack narrower than its offset) it has to come out first; else it goes on in, as from the surface.
    bool starts_inside = start.g <= real(0) && walk.first && !walk.below && (ray.may_start_inside || !walk.at_start);
    bool emerges = walk.first && walk.at_start && !ray.may_start_inside && start.g > -kDeepestCrack;
    vec3 gradient = patchGradient(map, quad, start, frame.cell.y, anchoredPoint(frame.anchor, ray.d, walk.sigma));
    bool rises = dot(gradient, ray.d) > real(0);
    bool below = start.g < real(0) && (walk.below || (emerges && rises));
    start.g = below ? start.g : max(start.g, real(0));
    Chord chord = solveChord(start, middle, end, quad);
    real length_of_chord = far - walk.sigma;
    bool unsure = chord.miss > kTrust && chord.lowest <= chord.miss;
    bool halve = unsure && !starts_inside && length_of_chord > real(4) * kShortestChord;
    bool enters = chord.lowest <= real(0) && (!below || comesOut(chord));
    // A chord without length leads from where rounding put the start to its true cell; on the axis, where all columns meet,
    // to no other.
    bool empty = !(far > walk.sigma) && here.rho > kOnAxis;
    walk.hit = !empty && (starts_inside || (enters && !halve));
    walk.inside = walk.hit && starts_inside && walk.at_start;
    walk.low = walk.sigma;
    walk.high = far;
    walk.longest = halve ? real(0.5) * length_of_chord : real(2) * max(walk.longest, kShortestChord);
    walk.going = !walk.hit && (halve || far < walk.end);
    if (walk.hit) {
        walk.sigma += starts_inside ? real(0) : parabolaRoot(vec3(chord.g, chord.slope, chord.bend)) * length_of_chord;
    } else if (!halve) {
        walk.below = empty ? walk.below : below && end.g <= real(0);
        walk.sigma = far;
        walk.first = walk.first && empty;
        if (to_u <= far) stepEast(walk.frame, map, plan.east);
        if (to_v <= far) stepSouth(walk.frame, map, south);
    }
}

// The refined hit.
struct Crossing {
    vec3 p, gradient;  // gradient of f = |p| - r: its direction is the normal
    PatchPoint at;
};

// Newton on the true f, kept inside the chord; its last gradient is the normal's direction.
Crossing refine(const Ray ray, const MapData map, const real scale, const ExactWalk walk) {
    Patch quad = fetchPatch(map, scale, walk.frame.cell);
    Crossing crossing;
    real sigma = walk.sigma;
    for (int i = 0; i < 2; ++i) {
        crossing.p = anchoredPoint(walk.frame.anchor, ray.d, sigma);
        crossing.at = patchPoint(map, quad, walk.frame, localAt(walk.frame, ray.d.y, sigma));
        crossing.gradient = patchGradient(map, quad, crossing.at, walk.frame.cell.y, crossing.p);
        real rate = dot(crossing.gradient, ray.d);
        bool steep = abs(rate) > real(1e-6) * length(crossing.gradient);
        real stride = steep && !walk.inside && i < 1 ? crossing.at.g / rate : real(0);
        sigma = clamp(sigma - stride, walk.low, walk.high);
    }
    return crossing;
}
