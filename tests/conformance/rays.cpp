#include "tests/conformance/rays.h"

#include "tests/support/testdevice.h"

#include <cmath>

namespace dsphere::conformance {

bool isRunAgain() {
    return testSurface() != TestSurface::AsGiven || test::testDevice().starts_with("host");
}

double uniform(Random& random, double low, double high) {
    return low + (high - low) * (double(random() >> 11) * 0x1p-53);
}

dvec3 randomUnit(Random& random) {
    double y = uniform(random, -1.0, 1.0), turn = uniform(random, 0.0, 2.0 * kPi), q = std::sqrt(1.0 - y * y);
    return {q * std::sin(turn), y, q * std::cos(turn)};
}

dvec3 randomAcross(Random& random, const dvec3& axis) {
    return glm::normalize(glm::cross(axis, randomUnit(random)));
}

double logarithmic(Random& random, double low, double high) {
    double size = std::exp(uniform(random, std::log(low), std::log(high)));
    return random() & 1 ? size : -size;
}

ProbeQuery aim(const dvec3& from, const dvec3& at) {
    return {.origin = from, .direction = at - from};
}

Queries randomRays(int count, double distance, double reach, std::uint64_t seed) {
    Random random(seed);
    Queries rays;
    for (int k = 0; k < count; ++k) {
        dvec3 from = distance * randomUnit(random);
        rays.push_back(aim(from, reach * std::cbrt(uniform(random, 0.0, 1.0)) * randomUnit(random)));
    }
    return rays;
}

}  // namespace dsphere::conformance
