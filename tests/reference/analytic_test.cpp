#include "reference/analytic.h"

#include "reference/firsthit.h"
#include "tests/reference/maps.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dsphere::reference::test {
namespace {

TEST(HitSphere, HandMade) {
    const FirstHit hit = hitSphere(2.0, {.origin = {0.0, 0.0, -10.0}, .direction = {0.0, 0.0, 4.0}});
    EXPECT_EQ(hit.verdict, Verdict::Hit);
    EXPECT_DOUBLE_EQ(hit.t(), 2.0);
    EXPECT_LE(hit.t_low, 2.0);
    EXPECT_GE(hit.t_high, 2.0);
    EXPECT_EQ(hit.position, dvec3(0.0, 0.0, -2.0));
    const FirstHit aside = hitSphere(5.0, {.origin = {3.0, -7.0, 0.0}, .direction = {0.0, 1.0, 0.0}});
    EXPECT_DOUBLE_EQ(aside.t(), 3.0);
    EXPECT_FALSE(hitSphere(5.0, {.origin = {5.0, -7.0, 0.0}, .direction = {0.0, 1.0, 0.0}}).hit);
    EXPECT_FALSE(hitSphere(5.0, {.origin = {3.0, -7.0, 0.0}, .direction = {0.0, -1.0, 0.0}}).hit);
    EXPECT_FALSE(hitSphere(5.0, {.origin = {3.0, -7.0, 0.0}, .direction = {0.0, 1.0, 0.0}, .t_max = 2.9}).hit);
    EXPECT_FALSE(hitSphere(5.0, {.origin = {3.0, -7.0, 0.0}, .direction = {0.0, 1.0, 0.0}, .t_min = 20.0}).hit);
    EXPECT_FALSE(hitSphere(5.0, {.origin = {3.0, -7.0, 0.0}, .direction = {0.0, 0.0, 0.0}}).hit);
}

TEST(HitSphere, StartsInside) {
    Ray ray{.origin = {0.0, 0.0, 1.0}, .direction = {0.0, 0.0, 1.0}};
    EXPECT_TRUE(hitSphere(2.0, ray).inside);
    ray.may_start_inside = false;
    EXPECT_FALSE(hitSphere(2.0, ray).hit);  // on its way out
    ray.t_max = 0.5;
    EXPECT_TRUE(hitSphere(2.0, ray).inside);  // but does not get there
    ray = {.origin = {0.0, 0.0, 1.0}, .direction = {0.0, 0.0, -1.0}, .may_start_inside = false};
    EXPECT_TRUE(hitSphere(2.0, ray).inside);  // on its way in
}

TEST(HitSphere, FarAndGrazing) {
    Random random(1);
    for (int k = 0; k < 1000; ++k) {
        const dvec3 w = randomUnit(random), along = glm::normalize(glm::cross(w, randomUnit(random)));
        const double aside = k % 2 ? 1e-9 : 1e-5;
        const Ray ray{.origin = (1.0 - aside) * w - 3.0 * along, .direction = along};
        EXPECT_NEAR(hitSphere(1.0, ray).t(), 3.0 - std::sqrt(aside * (2.0 - aside)), 1e-15 / std::sqrt(aside) + 1e-15);
        const Ray far{.origin = 1e6 * w, .direction = -w};
        EXPECT_NEAR(glm::length(hitSphere(1.0, far).position - w), 0.0, 1e-9);
        EXPECT_NEAR(glm::length(hitSphere(1.0, far).position), 1.0, 1e-15);
    }
    const Ray moved =
        movedSideways({.origin = {1.0 - 5e-7, 0.0, 3.0}, .direction = {0.0, 0.0, -1.0}}, {1e-6, 0.0, 0.0});
    EXPECT_FALSE(hitSphere(1.0, moved).hit);
}

TEST(HitDisk, RingFromBothSides) {
    const Disk disk{.height = 0.5, .radius = 2.0, .inner_radius = 1.0};
    for (double side : {1.0, -1.0}) {
        auto ray = [&](double x) {
            return Ray{.origin = {x, 0.0, 0.5 + 3.0 * side}, .direction = {0.0, 0.0, -2.0 * side}};
        };
        EXPECT_TRUE(hitDisk(disk, ray(1.5)).hit);
        EXPECT_DOUBLE_EQ(hitDisk(disk, ray(1.5)).t(), 1.5);
        EXPECT_EQ(hitDisk(disk, ray(1.5)).position, dvec3(1.5, 0.0, 0.5));
        EXPECT_FALSE(hitDisk(disk, ray(1.5)).inside);
        EXPECT_TRUE(hitDisk(disk, ray(1.0)).hit);
        EXPECT_TRUE(hitDisk(disk, ray(-2.0)).hit);
        EXPECT_FALSE(hitDisk(disk, ray(0.999)).hit);
        EXPECT_FALSE(hitDisk(disk, ray(2.001)).hit);
        Ray backward = ray(1.5);
        backward.direction *= -1.0;
        EXPECT_FALSE(hitDisk(disk, backward).hit);
        Ray brief = ray(1.5);
        brief.t_max = 1.4;
        EXPECT_FALSE(hitDisk(disk, brief).hit);
    }
    EXPECT_FALSE(hitDisk(disk, {.origin = {-3.0, 0.0, 0.5}, .direction = {1.0, 0.0, 0.0}}).hit);  // in its plane
    Ray from{.origin = {1.5, 0.0, 0.5}, .direction = {0.0, 0.1, 1.0}};
    EXPECT_TRUE(hitDisk(disk, from).hit);
    from.may_start_inside = false;
    EXPECT_FALSE(hitDisk(disk, from).hit);
}

TEST(HitDisk, SlantedRays) {
    Random random(2);
    const Disk disk{.height = -1.0, .radius = 1.0};
    for (int k = 0; k < 1000; ++k) {
        const dvec3 target(uniform(random, -1.2, 1.2), uniform(random, -1.2, 1.2), -1.0),
            from = 50.0 * randomUnit(random);
        const FirstHit hit = hitDisk(disk, {.origin = from, .direction = target - from});
        ASSERT_EQ(hit.hit, std::hypot(target.x, target.y) <= 1.0);
        if (!hit.hit) continue;
        EXPECT_NEAR(hit.t(), 1.0, 1e-13);
        EXPECT_LT(glm::length(hit.position - target), 1e-11);
    }
}

}  // namespace
}  // namespace dsphere::reference::test
