#include "image/tone.h"

#include <algorithm>
#include <cmath>

namespace dsphere {

double toneMapped(ToneCurve curve, double x) {
    if (curve == ToneCurve::Linear) return x;
    if (!(x > 0.0)) return 0.0;
    // Beyond this both curves are at their ends, and their squares might overflow.
    x = std::min(x, 1e30);
    if (curve == ToneCurve::Reinhard) return x / (1.0 + x);
    return std::min(1.0, x * (2.51 * x + 0.03) / (x * (2.43 * x + 0.59) + 0.14));
}

}  // namespace dsphere
