// Prints what a ray costs on a large map; asserts only that something was hit.

#include "reference/firsthit.h"
#include "tests/reference/maps.h"

#include <gtest/gtest.h>

#include <chrono>

namespace dsphere::reference::test {
namespace {

double seconds() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// A pinhole view with square pixels: `across` is the width of the picture at distance 1 from the eye.
void timeView(const char* name, const Surface& surface, const dvec3& eye, const dvec3& target, double across) {
    constexpr int kSide = 200;
    const dvec3 forward = glm::normalize(target - eye);
    const dvec3 right = glm::normalize(glm::cross(forward, dvec3(0.1, 1.0, 0.2))), up = glm::cross(right, forward);
    int hits = 0;
    const double start = seconds();
    for (int j = 0; j < kSide; ++j)
        for (int i = 0; i < kSide; ++i) {
            const double x = (i + 0.5) / kSide - 0.5, y = 0.5 - (j + 0.5) / kSide;
            const Ray ray{.origin = eye, .direction = forward + across * (x * right + y * up)};
            hits += firstHit(surface, ray).hit;
        }
    const double each = (seconds() - start) / (kSide * kSide);
    printf("    %-34s %6.2f us a ray, %4.1f %% hit\n", name, 1e6 * each, 100.0 * hits / (kSide * kSide));
    EXPECT_GT(hits, 0);
}

TEST(Timing, FractalMap) {
    const Heightmap map = fractalMap(4096, 2048, 1);
    for (double percent : {5.0, 50.0}) {
        const double start = seconds();
        const Surface surface(map, makeRelief(1.0, percent));
        printf("    4096x2048 fractal, %g %%: bounds in %.2f s\n", percent, seconds() - start);
        timeView("whole planet", surface, {1.0, 0.8, 3.0}, {0.0, 0.0, 0.0}, 0.66);
        const dvec3 ground = glm::normalize(dvec3(0.3, 0.2, 0.9)), east = glm::normalize(dvec3(0.9, 0.1, -0.3));
        const dvec3 low = surface.greatestRadius() * 1.02 * ground;
        timeView("limb from low above the ground", surface, low, low + east - 0.25 * ground, 0.5);
        timeView("down on the north pole", surface, {0.001, 1.6, 0.002}, {0.0, 1.0, 0.0}, 0.4);
    }
}

}  // namespace
}  // namespace dsphere::reference::test
