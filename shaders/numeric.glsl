// Elementary functions that the specification leaves too loose (atan: 4096 ulp). Compiled as GLSL and, with `real` a
// float or a double, as C++. All literals go through real(): a bare 1.0 is a double in C++ and a float in GLSL.

const real kPi = real(3.14159265358979323846);
const real kInfinity = real(1e30);

// Arc tangent of |q| <= 0.42 (one reduction step below pi/8), Cephes atanf: 2 ulp in float.
real atanReduced(real q) {
    real z = q * q;
    real poly = ((real(8.05374449538e-2) * z - real(1.38776856032e-1)) * z + real(1.99777106478e-1)) * z -
                real(3.33329491539e-1);
    return poly * z * q + q;
}

// Arc tangent within one cell: cells are at most 2 pi / 512 wide, so q^7 / 7 is below a float's rounding.
real atanSmall(real q) {
    real z = q * q;
    return q * (real(1) - z * (real(1.0 / 3.0) - real(0.2) * z));
}

// Angle of (x, y) in (-pi, pi]; 0 for (0, 0). Octant reduction, then one more at tan(pi/8).
real atan2Precise(real y, real x) {
    real ax = abs(x);
    real ay = abs(y);
    real big = max(ax, ay);
    real small_side = min(ax, ay);
    bool upper = small_side > real(0.41421356237) * big;
    real numerator = upper ? small_side - big : small_side;
    real denominator = upper ? small_side + big : big;
    real angle = atanReduced(numerator / max(denominator, real(1e-30)));
    angle += upper ? real(0.25) * kPi : real(0);
    angle = ay > ax ? real(0.5) * kPi - angle : angle;
    angle = x < real(0) ? kPi - angle : angle;
    return y < real(0) ? -angle : angle;
}

// First positive root of g0 + b t + a t^2 where g0 > 0, free of cancellation; the caller knows that one exists.
real firstRoot(real g0, real b, real a) {
    real root = sqrt(max(b * b - real(4) * a * g0, real(0)));
    return b <= real(0) ? real(2) * g0 / max(root - b, real(1e-30)) : (b + root) / max(real(-2) * a, real(1e-30));
}
