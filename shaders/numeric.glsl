// Elementary functions that the specification leaves too loose (atan: 4096 ulp), and float arithmetic with more than 24
// bits. Compiled as GLSL and, with `real` a float or a double, as C++. All literals go through real(): a bare 1.0 is a
// double in C++ and a float in GLSL.

const real kPi = real(3.14159265358979323846);
const real kInfinity = real(1e30);
const real kTiny = real(1e-30);

// Arc tangent of |q| <= 0.42 (one reduction step below pi/8), Cephes atanf: 2 ulp in float.
real atanReduced(const real q) {
    real z = q * q;
    real poly = ((real(8.05374449538e-2) * z - real(1.38776856032e-1)) * z + real(1.99777106478e-1)) * z -
                real(3.33329491539e-1);
    return poly * z * q + q;
}

// Arc tangent within one cell: cells are at most 2 pi / 512 wide, so q^7 / 7 is below a float's rounding.
real atanSmall(const real q) {
    real z = q * q;
    return q * (real(1) - z * (real(1.0 / 3.0) - real(0.2) * z));
}

// Angle of (x, y) in (-pi, pi]; 0 for (0, 0). Octant reduction, then one more at tan(pi/8).
real atan2Precise(const real y, const real x) {
    real ax = abs(x);
    real ay = abs(y);
    real big = max(ax, ay);
    real small_side = min(ax, ay);
    bool upper = small_side > real(0.41421356237) * big;
    real numerator = upper ? small_side - big : small_side;
    real denominator = upper ? small_side + big : big;
    real angle = atanReduced(numerator / max(denominator, kTiny));
    angle += upper ? real(0.25) * kPi : real(0);
    angle = ay > ax ? real(0.5) * kPi - angle : angle;
    angle = x < real(0) ? kPi - angle : angle;
    return y < real(0) ? -angle : angle;
}

// Where g0 + b t + a t^2 first falls to 0 for t > 0, free of cancellation; the caller knows that it does, and that b > 0 where
// g0 < 0.
real firstRoot(const real g0, const real b, const real a) {
    real root = sqrt(max(b * b - real(4) * a * g0, real(0)));
    return b <= real(0) ? real(2) * g0 / max(root - b, kTiny) : (b + root) / max(real(-2) * a, kTiny);
}

// A value as hi + lo, lo far smaller: nearly twice the bits of a real.
struct Pair {
    real hi, lo;
};

Pair makePair(const real hi, const real lo) {
    Pair pair;
    pair.hi = hi;
    pair.lo = lo;
    return pair;
}

// hi + lo = a + b exactly (Knuth's two-sum), plus rest.
Pair exactSum(const real a, const real b, const real rest) {
    precise real sum = a + b;
    precise real b_part = sum - a;
    precise real error = (a - (sum - b_part)) + (b - b_part);
    return makePair(sum, error + rest);
}

// The same value with hi the nearest real to it.
Pair rounded(const Pair pair) {
    return exactSum(pair.hi, pair.lo, real(0));
}

// a * b exactly (Dekker).
Pair exactProduct(const real a, const real b) {
    real a1 = leadingBits(a);
    real b1 = leadingBits(b);
    precise real a2 = a - a1;
    precise real b2 = b - b1;
    precise real product = a * b;
    precise real error = (((a1 * b1 - product) + a1 * b2) + a2 * b1) + a2 * b2;  // each sum is exact, in this order
    return makePair(product, error);
}

// base + x step_x + y step_y for whole numbers x and y below 2^24.
Pair pairLinear(const Pair base, const real x, const Pair step_x, const real y, const Pair step_y) {
    Pair x_part = exactProduct(x, step_x.hi);
    Pair y_part = exactProduct(y, step_y.hi);
    Pair sum = exactSum(base.hi, x_part.hi, base.lo);
    precise real rest = sum.lo + ((x * step_x.lo + y * step_y.lo) + (x_part.lo + y_part.lo));
    return rounded(exactSum(sum.hi, y_part.hi, rest));
}

// (a, b) rotated by the angle of sine and cosine e: first = a cos - b sin, second = a sin + b cos. e holds sine and cosine
// as leading 12 bits (x, y) and rest (z, w), so that the leading products are exact and `first`, which is small where the
// angle is nearly that of (a, b), has an error of its own size's rounding, not of a's.
struct Rotated {
    real first;
    Pair second;
};

Rotated rotatePair(const Pair a, const Pair b, const vec4 e) {
    real a1 = leadingBits(a.hi);
    real b1 = leadingBits(b.hi);
    precise real a2 = (a.hi - a1) + a.lo;
    precise real b2 = (b.hi - b1) + b.lo;
    precise real sin_e = e.x + e.z;
    precise real cos_e = e.y + e.w;
    precise real a_cos = a1 * e.y;
    precise real b_sin = b1 * e.x;
    precise real a_sin = a1 * e.x;
    precise real b_cos = b1 * e.y;
    precise real first_rest = (a1 * e.w + a2 * cos_e) - (b1 * e.z + b2 * sin_e);
    precise real second_rest = (a1 * e.z + a2 * sin_e) + (b1 * e.w + b2 * cos_e);
    Rotated result;
    precise real first = (a_cos - b_sin) + first_rest;
    result.first = first;
    result.second = exactSum(a_sin, b_cos, second_rest);
    return result;
}

// (x, y) rotated by a small angle given as sine and versine (1 - cosine): no rounding of the cosine piles up.
vec2 rotateSmall(const vec2 p, const real sine, const real versine) {
    return vec2(p.x - (p.x * versine + p.y * sine), p.y + (p.x * sine - p.y * versine));
}
