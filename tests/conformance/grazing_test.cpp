// Rays that are aimed at tangency on purpose: within 1e-6 R either answer is right, beyond it the contract holds.

#include "tests/conformance/fixture.h"
#include "tests/support/testmaps.h"

#include <cmath>

namespace dsphere::conformance {
namespace {

using Grazing = Conformance;

constexpr double kReach = 1e-5;  // R; offsets above and below the tangent

// The tangent through top + offset: along a random direction across `top`.
ProbeQuery tangentRay(Random& random, const dvec3& top, double offset) {
    dvec3 along = randomAcross(random, top);
    return {.origin = top * (1.0 + offset / glm::length(top)) - 3.0 * along, .direction = along};
}

RawMap bumpMap(int width, int height, int i0, int j0) {
    RawMap map = test::constantMap(width, height, 0.0f);
    for (int j = 0; j < height; ++j)
        for (int i = 0; i < width; ++i) {
            double distance = std::hypot(i - i0, j - j0) / 12.0;
            map.samples[std::size_t(j * width + i)] = float(std::round(65535.0 * std::exp(-distance * distance)));
        }
    return map;
}

// The bump's top is the node (i0, j0), at the radius R exactly.
TEST_F(Grazing, TopOfABump) {
    Random random(21);
    for (int j0 : {40, 128, 230}) {
        World world = sphereWorld(bumpMap(512, 256, 300, j0), 20.0);
        const Heightmap& map = *world.maps.maps[0];
        dvec3 top = direction(nodeLongitude(map, 300), nodeLatitude(map, j0));
        Queries rays;
        for (int k = 0; k < kRays; ++k) rays.push_back(tangentRay(random, top, uniform(random, -kReach, kReach)));
        // Every ray within 1e-6 R of the top may be excused.
        expectContractButTangents(probe(world, rays));
    }
}

TEST_F(Grazing, SilhouetteOfTheFlatSphere) {
    Random random(22);
    Queries rays;
    for (int k = 0; k < kRays; ++k)
        rays.push_back(tangentRay(random, randomUnit(random), uniform(random, -kReach, kReach)));
    // Every ray within 1e-6 R of the silhouette may be excused.
    expectContractButTangents(probe(sphereWorld(test::constantMap(512, 256, 0.0f), 0.0), rays));
}

// The closed form: only rays that pass the centre within 1 -+ 1e-6 R may be judged either way.
TEST_F(Grazing, FlatSphereAgainstTheClosedForm) {
    Random random(23);
    World world = sphereWorld(test::constantMap(64, 32, 0.0f), 0.0);
    Queries rays;
    std::vector<double> offsets;
    for (int k = 0; k < kRays; ++k) {
        offsets.push_back(logarithmic(random, 1.01e-6, 0.5));
        rays.push_back(tangentRay(random, randomUnit(random), offsets.back()));
    }
    PackedScene packed = packScene(world.scene, world.maps);
    std::vector<layout::ProbeHit> hits = makeProbe(packed)->trace(rays);
    for (std::size_t k = 0; k < rays.size(); ++k) {
        ASSERT_EQ(hits[k].flags, offsets[k] < 0.0 ? 1u : 0u) << k << ": " << offsets[k];
        double radius = offsets[k] < 0.0 ? glm::length(dvec3(hits[k].position)) : 1.0;
        ASSERT_NEAR(radius, 1.0, 1e-6) << k;
    }
}

// Low over rough ground: many near misses before the hit. Not aimed at any tangency, so the whole contract holds.
TEST_F(Grazing, LowOverRoughGround) {
    Random random(24);
    Queries rays;
    for (int k = 0; k < kRays; ++k) {
        dvec3 top = uniform(random, 0.9, 1.0) * randomUnit(random);
        rays.push_back(tangentRay(random, top, 0.0));
    }
    expectContract(probe(sphereWorld(test::fractalMap(512, 256), 15.0), rays));
}

// Rays in the seam's plane that graze the seam's own profile.
TEST_F(Grazing, InTheSeamPlane) {
    Random random(25);
    Queries rays;
    for (int k = 0; k < kRays; ++k) {
        double latitude = uniform(random, -1.5, 1.5), zero = k % 2 ? 0.0 : -0.0;
        dvec3 top = (1.0 + uniform(random, -kReach, kReach)) * direction(kPi, latitude);
        dvec3 along = (k % 4 < 2 ? 1.0 : -1.0) * north(kPi, latitude);
        dvec3 from = top - 3.0 * along;
        rays.push_back({.origin = {zero, from.y, from.z}, .direction = {-zero, along.y, along.z}});
    }
    // Every ray within 1e-6 R of the silhouette may be excused.
    expectContractButTangents(probe(sphereWorld(test::constantMap(512, 256, 0.5f), 15.0), rays));
}

}  // namespace
}  // namespace dsphere::conformance
