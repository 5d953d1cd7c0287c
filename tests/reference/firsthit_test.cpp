#include "reference/firsthit.h"

#include "reference/analytic.h"
#include "tests/reference/maps.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>

namespace dsphere::reference::test {
namespace {

using enum Registration;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

TEST(FirstHit, FlatMapIsTheSphere) {
    Random random(1);
    for (Registration registration : {Texel, Gridline})
        for (double value : {0.0, 0.7}) {
            const Heightmap map = flatMap(9, 5, registration, value);
            const Surface surface(map, makeRelief(2.0, 30.0));
            const double radius = 2.0 + 0.6 * double(float(value));
            for (int k = 0; k < 4000; ++k) {
                const Ray ray = randomRay(random, k % 2 ? 2.5 : 9.0, 1.2 * radius);
                const FirstHit hit = firstHit(surface, ray), sphere = hitSphere(radius, ray);
                ASSERT_EQ(hit.hit, sphere.hit);
                if (!hit.hit) continue;
                const double length = glm::length(ray.direction);
                const double cosine = std::abs(glm::dot(sphere.position, ray.direction)) / (radius * length);
                EXPECT_NEAR(hit.t() * length, sphere.t() * length, 1e-13 + 1e-14 / cosine);
                EXPECT_LT(glm::length(hit.position - sphere.position), 1e-13 + 1e-14 / cosine);
                EXPECT_LE(hit.t_low, sphere.t_high);
                EXPECT_GE(hit.t_high, sphere.t_low);
                EXPECT_NEAR(glm::dot(surface.normal(hit.position), sphere.position), radius, 1e-13);
            }
        }
}

TEST(FirstHit, GrazingTheFlatMap) {
    const Heightmap map = flatMap(8, 4, Texel, 0.0);
    const Surface surface(map, makeRelief(1.0, 10.0));
    Random random(2);
    for (int k = 0; k < 500; ++k) {
        const dvec3 w = randomUnit(random), along = glm::normalize(glm::cross(w, randomUnit(random)));
        for (double aside : {1e-5, 1e-9}) {
            const FirstHit below = firstHit(surface, {.origin = (1.0 - aside) * w - 3.0 * along, .direction = along});
            ASSERT_TRUE(below.hit);
            EXPECT_NEAR(below.t(), 3.0 - std::sqrt(aside * (2.0 - aside)), 1e-14 / std::sqrt(aside) + 1e-14);
            EXPECT_FALSE(firstHit(surface, {.origin = (1.0 + aside) * w - 3.0 * along, .direction = along}).hit);
        }
    }
}

TEST(FirstHit, RaysThatHitNothingByDefinition) {
    const Heightmap map = noiseMap(8, 4, Texel, 3);
    const Surface surface(map, makeRelief(1.0, 50.0));
    const double nan = std::nan("");
    const dvec3 origin(0.0, 0.0, 3.0);
    for (const dvec3& direction :
         {dvec3(0.0), dvec3(nan, 0.0, -1.0), dvec3(0.0, 0.0, -kInfinity), dvec3(0.0, 0.0, nan)}) {
        EXPECT_FALSE(firstHit(surface, {.origin = origin, .direction = direction}).hit);
        EXPECT_EQ(classify(surface, {.origin = origin, .direction = direction}).verdict, Verdict::Miss);
        EXPECT_TRUE(sidewaysRays(surface, {.origin = origin, .direction = direction}).empty());
    }
    EXPECT_FALSE(firstHit(surface, {.origin = {0.0, nan, 3.0}, .direction = {0.0, 0.0, -1.0}}).hit);
    EXPECT_FALSE(firstHit(surface, {.origin = {0.0, kInfinity, 3.0}, .direction = {0.0, 0.0, -1.0}}).hit);
    EXPECT_FALSE(firstHit(surface, {.origin = origin, .direction = {0.0, 0.0, -1.0}, .t_max = nan}).hit);
    EXPECT_FALSE(firstHit(surface, {.origin = origin, .direction = {0.0, 0.0, -1.0}, .t_min = 1.0, .t_max = 0.5}).hit);
    EXPECT_FALSE(firstHit(surface, {.origin = origin, .direction = {0.0, 0.0, 1.0}}).hit);
    EXPECT_FALSE(firstHit(surface, {.origin = origin, .direction = {0.0, 0.0, -1.0}, .t_max = 1.0}).hit);
}

TEST(FirstHit, DirectionsOfAnyLength) {
    const Heightmap map = noiseMap(8, 4, Texel, 4);
    const Surface surface(map, makeRelief(1.0, 50.0));
    const dvec3 origin(0.5, 1.0, 3.0), direction(-0.2, -0.3, -1.0);
    const FirstHit unit = firstHit(surface, {.origin = origin, .direction = direction});
    ASSERT_TRUE(unit.hit);
    for (double scale : {1e-300, 1e-20, 1e20, 1e300}) {
        const FirstHit hit = firstHit(surface, {.origin = origin, .direction = scale * direction});
        ASSERT_TRUE(hit.hit) << scale;
        EXPECT_NEAR(hit.t() * scale, unit.t(), 1e-13);
        EXPECT_NE(classify(surface, {.origin = origin, .direction = scale * direction}).verdict, Verdict::Miss);
    }
}

TEST(FirstHit, StartInsideIsAHitAtOnce) {
    const Heightmap map = noiseMap(8, 4, Texel, 5);
    const Surface surface(map, makeRelief(1.0, 50.0));
    for (double t_min : {0.0, 2.5}) {
        const FirstHit hit = firstHit(surface, {.origin = dvec3(0.1, 0.2, 0.3) - t_min * dvec3(0.0, 1.0, 0.0),
                                                .direction = {0.0, 1.0, 0.0},
                                                .t_min = t_min});
        EXPECT_TRUE(hit.hit && hit.inside);
        EXPECT_EQ(hit.t_low, t_min);
        EXPECT_EQ(hit.t_high, t_min);
        EXPECT_NEAR(hit.position.y, 0.2, 1e-15);
    }
}

TEST(FirstHit, FarOriginsAgreeWithNearOnes) {
    const Heightmap map = noiseMap(32, 16, Texel, 6);
    const Surface surface(map, makeRelief(1.0, 10.0));
    Random random(7);
    int hits = 0;
    for (int k = 0; k < 500; ++k) {
        // Directions of few bits, so that the far origin is exact in double.
        const dvec3 direction = glm::round(8.0 * randomUnit(random)) / 8.0;
        const dvec3 near = glm::round(1024.0 * (dvec3(-3.0) * direction + 0.7 * randomUnit(random))) / 1024.0;
        const double back = 1048576.0;
        const Ray close{.origin = near, .direction = direction},
            far{.origin = near - back * direction, .direction = direction};
        const FirstHit a = firstHit(surface, close), b = firstHit(surface, far);
        ASSERT_EQ(a.hit, b.hit);
        if (!a.hit) continue;
        ++hits;
        const double cosine = std::abs(glm::dot(surface.normal(a.position), glm::normalize(direction)));
        EXPECT_LT(glm::length(a.position - b.position), 1e-12 / cosine);
        EXPECT_NEAR(b.t() - back, a.t(), 1e-9);
    }
    EXPECT_GT(hits, 300);
}

TEST(FirstHit, EnclosuresAreNarrow) {
    const Heightmap map = noiseMap(64, 32, Texel, 8);
    const Surface surface(map, makeRelief(1.0, 20.0));
    Random random(9);
    for (int k = 0; k < 2000; ++k) {
        const Ray ray = randomRay(random, 2.0, 1.0);
        const FirstHit hit = firstHit(surface, ray);
        if (!hit.hit) continue;
        const double cosine = std::abs(glm::dot(surface.normal(hit.position), glm::normalize(ray.direction)));
        if (cosine < 0.1) continue;
        EXPECT_LT(hit.t_high - hit.t_low, 64.0 * surface.evaluationError() / cosine);
    }
}

TEST(FirstHit, GrazingRaysEndSoon) {
    // Rays that creep along the ground of a rough map, and a map that is flat but for rounding: the worst to decide.
    const Heightmap rough = noiseMap(2048, 1024, Texel, 10), flat = flatMap(2048, 1024, Texel, 0.3);
    for (const Heightmap* map : {&rough, &flat}) {
        const Surface surface(*map, makeRelief(1.0, 1e-3));
        Random random(11);
        const auto start = std::chrono::steady_clock::now();
        for (int k = 0; k < 300; ++k) {
            const dvec3 w = randomUnit(random), along = glm::normalize(glm::cross(w, randomUnit(random)));
            const double height = surface.greatestRadius() * (1.0 + 1e-9 * uniform(random, -1.0, 1.0));
            firstHit(surface, {.origin = height * w - 3.0 * along, .direction = along});
        }
        const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
        printf("    grazing: %.1f us a ray\n", seconds / 300 * 1e6);
        EXPECT_LT(seconds / 300, 0.05);
    }
}

}  // namespace
}  // namespace dsphere::reference::test
