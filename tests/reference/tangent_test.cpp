#include "reference/firsthit.h"
#include "tests/reference/maps.h"

#include <gtest/gtest.h>

#include <cmath>

namespace dsphere::reference::test {
namespace {

using enum Registration;

/// A sphere of radius 1 with one texel raised to 1.2, at longitude and latitude about 0.
class Bump : public testing::Test {
  protected:
    Heightmap map_ = makeMap(64, 32, Texel, [](int i, int j) { return i == 32 && j == 15 ? 1.0 : 0.0; });
    Surface surface_{map_, makeRelief(1.0, 20.0)};
    const double longitude_ = kPi / 64, latitude_ = kPi / 64;
    const dvec3 summit_ = 1.2 * dvec3(std::cos(latitude_) * std::sin(longitude_), std::sin(latitude_),
                                      std::cos(latitude_) * std::cos(longitude_));

    Verdict verdict(const dvec3& origin, const dvec3& direction) const {
        return classify(surface_, {.origin = origin, .direction = direction}).verdict;
    }
};

TEST_F(Bump, PastTheSummit) {
    ASSERT_NEAR(surface_.f(summit_), 0.0, 1e-7);  // the map's float
    const dvec3 along(0.0, 1.0, 0.0), up = glm::normalize(summit_ - summit_.y * along);
    auto at = [&](double above) { return summit_ + above * up - 3.0 * along; };
    EXPECT_EQ(verdict(at(1e-4), along), Verdict::Miss);
    EXPECT_EQ(verdict(at(3e-6), along), Verdict::Miss);
    EXPECT_EQ(verdict(at(5e-7), along), Verdict::Tangent);
    EXPECT_EQ(verdict(at(-5e-7), along), Verdict::Tangent);
    EXPECT_EQ(verdict(at(-1e-5), along), Verdict::Hit);
}

TEST_F(Bump, RootJumpsFromTheBumpToTheGround) {
    // From above, slanting just past the summit down to the ground behind it: a hit either way, far apart.
    const dvec3 radial = glm::normalize(summit_), up = glm::normalize(dvec3(0.0, 1.0, 0.0) - radial.y * radial);
    const dvec3 direction = glm::normalize(up - 1.2 * radial), side = glm::normalize(radial + 1.2 * up);
    auto at = [&](double above) { return summit_ + above * side - 2.0 * direction; };
    const FirstHit over = classify(surface_, {.origin = at(5e-7), .direction = direction});
    const FirstHit onto = classify(surface_, {.origin = at(-5e-7), .direction = direction});
    ASSERT_TRUE(over.hit && onto.hit);
    EXPECT_GT(over.t_low, onto.t_high + 0.1);
    EXPECT_EQ(over.verdict, Verdict::Tangent);
    EXPECT_EQ(onto.verdict, Verdict::Tangent);
    EXPECT_EQ(verdict(at(1e-5), direction), Verdict::Hit);
    EXPECT_EQ(verdict(at(-1e-5), direction), Verdict::Hit);
}

TEST_F(Bump, StraightDownIsNoTangent) {
    Random random(1);
    for (int k = 0; k < 100; ++k) {
        const dvec3 from = 3.0 * glm::normalize(summit_ + 0.2 * randomUnit(random));
        EXPECT_EQ(verdict(from, -from), Verdict::Hit);
    }
}

TEST_F(Bump, SilhouetteOfTheSphere) {
    Random random(2);
    for (int k = 0; k < 100; ++k) {
        dvec3 w = randomUnit(random);
        w.z = -std::abs(w.z) - 0.3;  // away from the bump
        w = glm::normalize(w);
        const dvec3 along = glm::normalize(glm::cross(w, dvec3(0.0, 0.0, 1.0)));
        auto at = [&](double radius) { return radius * w - 3.0 * along; };
        EXPECT_EQ(verdict(at(1.0 + 8e-7), along), Verdict::Tangent);
        EXPECT_EQ(verdict(at(1.0 - 8e-7), along), Verdict::Tangent);
        EXPECT_EQ(verdict(at(1.0 + 1.5e-6), along), Verdict::Miss);
        EXPECT_EQ(verdict(at(1.0 - 1.5e-6), along), Verdict::Hit);
    }
}

TEST_F(Bump, LeastFOfAMiss) {
    const FirstHit miss = classify(surface_, {.origin = {-1.5, -3.0, 0.0}, .direction = {0.0, 2.0, 0.0}});
    EXPECT_EQ(miss.verdict, Verdict::Miss);
    EXPECT_NEAR(miss.least_f, 0.5, 1e-12);
    EXPECT_NEAR(miss.least_t, 1.5, 1e-6);
    const FirstHit away = classify(surface_, {.origin = {-1.5, 3.0, 0.0}, .direction = {0.0, 2.0, 0.0}});
    EXPECT_NEAR(away.least_f, std::hypot(1.5, 3.0) - 1.0, 1e-12);
    EXPECT_EQ(away.least_t, 0.0);
}

TEST_F(Bump, SidewaysRaysAreBesideTheRay) {
    const Ray ray{.origin = {0.1, 0.2, 3.0}, .direction = {0.01, 0.03, -2.0}};
    const std::vector<Ray> rays = sidewaysRays(surface_, ray);
    EXPECT_EQ(rays.size(), 36u);
    for (const Ray& moved : rays) {
        const dvec3 offset = moved.origin - ray.origin;
        EXPECT_EQ(moved.direction, ray.direction);
        EXPECT_NEAR(glm::dot(offset, glm::normalize(ray.direction)), 0.0, 1e-15);
        EXPECT_LE(glm::length(offset), kSideways * surface_.greatestRadius() * (1.0 + 1e-8));
        EXPECT_GE(glm::length(offset), 0.49 * kSideways * surface_.greatestRadius());
    }
}

TEST(Tangent, IsRareOnRoughGround) {
    const Heightmap map = noiseMap(128, 64, Texel, 3);
    const Surface surface(map, makeRelief(1.0, 10.0));
    Random random(4);
    int tangent = 0;
    for (int k = 0; k < 3000; ++k)
        tangent += classify(surface, randomRay(random, 4.0, 1.0)).verdict == Verdict::Tangent;
    EXPECT_LE(tangent, 3);
}

}  // namespace
}  // namespace dsphere::reference::test
