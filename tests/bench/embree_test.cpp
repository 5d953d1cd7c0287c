// Embree's meshes against closed forms.

#include "bench/embree.h"
#include "bench/pixelorder.h"
#include "reference/analytic.h"
#include "tests/support/testmaps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace dsphere::bench {
namespace {

struct Rays {
    std::vector<reference::Ray> exact;
    RaySet set;

    explicit Rays(int count) {
        std::mt19937 random(3);
        auto uniform = [&] { return 2.0 * double(random()) / 4294967296.0 - 1.0; };
        for (int k = 0; k < count; ++k) {
            dvec3 origin = 3.0 * glm::normalize(dvec3(uniform(), uniform(), uniform()));
            dvec3 target = 0.9 * dvec3(uniform(), uniform(), uniform());
            // Both sides trace the same ray: the rounded one.
            dvec3 start = dvec3(glm::vec3(origin)), direction = dvec3(glm::vec3(glm::normalize(target - origin)));
            exact.push_back({.origin = start, .direction = direction});
            set.add(start, direction);
        }
        set.fillPackets();
    }
};

class EmbreeTest : public testing::TestWithParam<MeshKind> {
  protected:
    static Heightmap smoothMap() { return makeHeightmap(test::constantMap(1024, 512, 0.0f), {}); }
};

// A facet over an angle of a lies within a^2 / 8 of the sphere in either direction, both together a^2 / 4.
TEST_P(EmbreeTest, SmoothSphereWithinItsSagitta) {
    Heightmap map = smoothMap();
    NodeGrid nodes(map);
    EmbreeScene scene(nodes, 1.0, 0.0, 1, GetParam());
    Rays rays(4000);
    std::vector<float> t(rays.set.size());
    scene.intersect(rays.set, t, nullptr);
    double angle = 2.0 * kPi / 1024, sagitta = 0.25 * angle * angle + 1e-6;
    int hits = 0;
    for (std::size_t k = 0; k < rays.exact.size(); ++k) {
        reference::FirstHit truth = reference::hitSphere(1.0, rays.exact[k]);
        dvec3 p = rays.exact[k].origin + double(t[k]) * rays.exact[k].direction;
        double across = glm::length(glm::cross(rays.exact[k].origin, rays.exact[k].direction));
        if (across < 1.0 - sagitta) {
            ASSERT_TRUE(std::isfinite(t[k])) << k;
            EXPECT_LE(std::abs(glm::length(p) - 1.0), sagitta) << k;
            EXPECT_NEAR(t[k], truth.t(), sagitta / std::sqrt(1.0 - across * across) + 1e-5) << k;
            ++hits;
        } else if (across > 1.0) {
            EXPECT_FALSE(std::isfinite(t[k])) << k;
        }
    }
    EXPECT_GT(hits, 1000);
}

TEST_P(EmbreeTest, OcclusionAgreesWithTheFirstHit) {
    DisplacedSphere sphere;
    sphere.max_displacement = 20.0;
    Heightmap map = makeHeightmap(test::fractalMap(512, 256), sphere);
    Relief relief = makeRelief(sphere, map, {"embree"});
    NodeGrid nodes(map);
    EmbreeScene scene(nodes, relief.base, relief.scale, 2, GetParam());
    Rays rays(4001);
    std::vector<float> t(rays.set.size()), blocked(rays.set.size());
    scene.intersect(rays.set, t, nullptr);
    scene.occluded(rays.set, blocked);
    for (std::size_t k = 0; k < rays.exact.size(); ++k) EXPECT_EQ(std::isfinite(t[k]), blocked[k] < 0.0f) << k;
}

TEST_P(EmbreeTest, MemoryHoldsTheVerticesAtLeast) {
    Heightmap map = smoothMap();
    NodeGrid nodes(map);
    EmbreeScene full(nodes, 1.0, 0.0, 1, GetParam()), half(nodes, 1.0, 0.0, 2, GetParam());
    EXPECT_GT(full.peakBytes(), meshLattice(nodes, 1).vertexCount() * sizeof(glm::vec3));
    EXPECT_LT(half.peakBytes(), full.peakBytes());
}

INSTANTIATE_TEST_SUITE_P(Kinds, EmbreeTest, testing::Values(MeshKind::Grid, MeshKind::Triangles));

TEST(RaySet, IsFilledToWholePackets) {
    RaySet rays;
    rays.fillPackets();
    EXPECT_EQ(rays.size(), 0u);
    for (int k = 0; k < kPacketSize + 1; ++k) rays.add(dvec3(k), dvec3(0.0, 0.0, 1.0));
    rays.fillPackets();
    EXPECT_EQ(rays.size(), std::size_t(2 * kPacketSize));
    EXPECT_EQ(rays.x.back(), float(kPacketSize));
}

}  // namespace
}  // namespace dsphere::bench
