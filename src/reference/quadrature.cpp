#include "reference/quadrature.h"

#include "base/math.h"

#include <cmath>

namespace dsphere::reference {

// The nodes are the roots of P_n, by Newton from Tricomi's estimate; P_n by Bonnet's recurrence.
GaussLegendre::GaussLegendre(int count) {
    for (int k = 0; k < count; ++k) {
        double x = std::cos(kPi * (k + 0.75) / (count + 0.5)), slope = 1.0;
        for (int step = 0; step < 20; ++step) {
            double before = 1.0, value = x;
            for (int n = 2; n <= count; ++n) {
                const double next = ((2 * n - 1) * x * value - (n - 1) * before) / n;
                before = value;
                value = next;
            }
            slope = count * (x * value - before) / (x * x - 1.0);
            x -= value / slope;
        }
        nodes.push_back(0.5 * (1.0 + x));
        weights.push_back(1.0 / ((1.0 - x * x) * slope * slope));
    }
}

}  // namespace dsphere::reference
