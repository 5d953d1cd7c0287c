// Rays of extreme and special numbers: every answer must be sane, and nothing in front of a hit may lie inside.

#include "reference/analytic.h"
#include "reference/firsthit.h"
#include "tests/reference/maps.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

namespace dsphere::reference::test {
namespace {

using enum Registration;

double special(Random& random) {
    static const double kValues[] = {0.0,   -0.0,  1.0,   -1.0,   1e-320, 1e-300,   -1e-300, 1e-160,   -1e-17,
                                     1e-17, 1e-9,  1e-5,  0.5,    1.1,    2.0,      3.0,     -3.0,     1e6,
                                     1e20,  1e150, 1e300, -1e300, -1e-9,  INFINITY, NAN,     0x1p-1074};
    if (random() % 3 == 0) return uniform(random, -3.0, 3.0);
    if (random() % 9 == 0) return std::bit_cast<double>(random());
    return kValues[random() % std::size(kValues)];
}

Ray specialRay(Random& random, const Surface& surface, int k) {
    auto vector = [&] { return dvec3(special(random), special(random), special(random)); };
    Ray ray{.origin = vector(), .direction = vector()};
    if (k % 4 == 0) ray.t_min = special(random);
    if (k % 5 == 0) ray.t_max = special(random);
    ray.may_start_inside = k % 2 == 0;
    if (k % 7 == 0) {  // from the ground, along it or anywhere
        const dvec3 w = randomUnit(random);
        ray.origin = surface.radius(w) * w;
        ray.direction = k % 3 ? randomUnit(random) : glm::cross(w, randomUnit(random));
    }
    if (k % 11 == 0) {  // in or beside a plane through the axis, perhaps from the axis
        ray.origin = {k % 3 ? 0.0 : 1e-160, uniform(random, -1.2, 1.2),
                      k % 4 ? 1e-160 * special(random) : special(random)};
        ray.direction = {k % 5 ? 0.0 : special(random), uniform(random, -1.0, 1.0), special(random)};
    }
    return ray;
}

void expectSane(const FirstHit& hit, const Ray& ray, const Surface& surface) {
    if (!hit.hit) return;
    EXPECT_LE(hit.t_low, hit.t_root);
    EXPECT_LE(hit.t_root, hit.t_high);
    EXPECT_GE(hit.t_low, ray.t_min);
    EXPECT_LE(hit.t_high, ray.t_max);
    EXPECT_TRUE(std::isfinite(hit.position.x + hit.position.y + hit.position.z));
    if (!hit.inside) {
        EXPECT_LT(std::abs(surface.f(hit.position)), 1e-12 + surface.evaluationError());
    }
}

/// For camera rays of ordinary numbers that start outside: f > 0 at points before the hit, or anywhere on a miss.
void expectNothingBefore(const FirstHit& hit, const Ray& ray, const Surface& surface) {
    const double speed = glm::length(ray.direction), far = glm::length(ray.origin) + 3.0;
    if (!ray.may_start_inside || hit.inside || !(speed > 1e-3 && speed < 1e3 && far < 1e3)) return;
    if (!(std::abs(ray.t_min) < 1e3 && ray.t_max >= ray.t_min)) return;
    const double end = std::min({hit.t_low, ray.t_max, ray.t_min + 2.0 * far / speed + 4.0 * std::abs(ray.t_min)});
    if (!(end > ray.t_min)) return;
    for (int n = 0; n < 60; ++n) {
        const double share = n < 30 ? n / 30.0 : std::exp2(-(n - 30));
        const double t = ray.t_min + share * (end - ray.t_min);
        const dvec3 p = ray.origin + t * ray.direction;
        if (p == dvec3(0.0)) continue;
        EXPECT_GT(surface.f(p), -1e-10) << t << " of " << hit.t_low;
    }
}

TEST(Hostile, AnyNumbersAnyMap) {
    const std::pair<int, int> sizes[] = {{1, 1}, {2, 1}, {3, 2}, {5, 3}, {16, 8}, {64, 1}, {255, 129}, {2, 128}};
    for (Registration registration : {Texel, Gridline})
        for (auto [width, height] : sizes)
            for (double percent : {0.0, 1e-9, 5.0, 140.0, -95.0}) {
                Heightmap map = noiseMap(width, std::max(height, registration == Gridline ? 2 : 1), registration, 1);
                map.longitude_origin = 13.0;
                const Surface surface(map, makeRelief(1.0, percent));
                Random random(5);
                for (int k = 0; k < 2000; ++k) {
                    const Ray ray = specialRay(random, surface, k);
                    const FirstHit hit = firstHit(surface, ray);
                    expectSane(hit, ray, surface);
                    expectNothingBefore(hit, ray, surface);
                    if (k % 100 == 0) {
                        EXPECT_EQ(classify(surface, ray).hit, hit.hit);
                    }
                    hitSphere(1.0, ray);
                    hitDisk({}, ray);
                    if (HasFailure())
                        FAIL() << width << 'x' << height << ' ' << percent << " % ray " << k << ": origin "
                               << ray.origin.x << ' ' << ray.origin.y << ' ' << ray.origin.z << " direction "
                               << ray.direction.x << ' ' << ray.direction.y << ' ' << ray.direction.z << " t "
                               << ray.t_min << ' ' << ray.t_max;
                }
            }
}

}  // namespace
}  // namespace dsphere::reference::test
