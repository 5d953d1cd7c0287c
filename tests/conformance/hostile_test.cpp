// Rays that are no rays: zero, denormal, infinite, not a number, in every place.

#include "reference/firsthit.h"
#include "tests/conformance/fixture.h"
#include "tests/support/testmaps.h"

#include <cmath>
#include <limits>

namespace dsphere::conformance {
namespace {

constexpr double kInf = std::numeric_limits<double>::infinity(), kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kTiny = std::numeric_limits<double>::denorm_min();
constexpr double kFloatTiny = std::numeric_limits<float>::denorm_min();

class Hostile : public Conformance {
  protected:
    World world_ = sphereWorld(test::fractalMap(512, 256), 15.0);
    PackedScene packed_ = packScene(world_.scene, world_.maps);
    reference::Surface surface_{*world_.maps.maps[0], world_.maps.reliefs[0]};
    Random random_{51};

    /// Some coordinates of `v` replaced by one of `values`, at least one.
    dvec3 spoiled(dvec3 v, const std::vector<double>& values) {
        unsigned which = 1u + unsigned(random_() % 7);
        for (int c = 0; c < 3; ++c)
            if (which >> c & 1u) v[c] = values[random_() % values.size()];
        return v;
    }

    std::vector<layout::ProbeHit> trace(const Queries& queries) {
        EXPECT_GE(queries.size(), kLeastRays);
        std::vector<layout::ProbeHit> hits = makeProbe(packed_)->trace(queries);
        for (std::size_t k = 0; k < hits.size(); ++k) {
            for (int c = 0; c < 4; ++c)
                EXPECT_TRUE(std::isfinite(hits[k].position[c]) && std::isfinite(hits[k].normal[c]))
                    << describe(queries, k);
            EXPECT_EQ(hits[k].flags & 4u, 0u) << "ran away: " << describe(queries, k);
            if (HasFailure()) break;
        }
        return hits;
    }

    static std::string describe(const Queries& queries, std::size_t k) {
        const auto& [o, d, length, secondary] = queries[k];
        std::ostringstream text;
        text << "ray " << k << " from " << o.x << ' ' << o.y << ' ' << o.z << " along " << d.x << ' ' << d.y << ' '
             << d.z << " for " << length << (secondary ? ", secondary" : "");
        return text.str();
    }

    void expectMisses(const Queries& queries) {
        std::vector<layout::ProbeHit> hits = trace(queries);
        for (std::size_t k = 0; k < hits.size(); ++k) ASSERT_EQ(hits[k].flags & 1u, 0u) << describe(queries, k);
    }

    /// A miss, or the reference's hit to within the bound along the ray.
    void expectMissesOrTheRightHits(const Queries& queries) {
        std::vector<layout::ProbeHit> hits = trace(queries);
        for (std::size_t k = 0; k < hits.size(); ++k) {
            if ((hits[k].flags & 1u) == 0) continue;
            reference::FirstHit truth = reference::firstHit(
                surface_, {.origin = queries[k].origin * world_.unit(), .direction = queries[k].direction});
            ASSERT_TRUE(truth.hit) << describe(queries, k);
            ASSERT_EQ(truth.inside, (hits[k].flags & 2u) != 0) << describe(queries, k);
            if (truth.inside) continue;
            double largest = std::max(
                {std::abs(queries[k].direction.x), std::abs(queries[k].direction.y), std::abs(queries[k].direction.z)});
            dvec3 d = glm::normalize(queries[k].direction / largest);
            double cosine = std::abs(glm::dot(surface_.normal(truth.position), d));
            ASSERT_LE(glm::length(dvec3(hits[k].position) - truth.position / world_.unit()),
                      verify::contract::kAlongRay / cosine + 1e-6)
                << describe(queries, k);
        }
    }
};

TEST_F(Hostile, DirectionsThatAreNotFinite) {
    Queries rays = randomRays(kRays, 3.0, 1.0);
    for (ProbeQuery& ray : rays) ray.direction = spoiled(ray.direction, {kInf, -kInf, kNan});
    expectMisses(rays);
}

TEST_F(Hostile, OriginsThatAreNotFinite) {
    Queries rays = randomRays(kRays, 3.0, 1.0);
    for (ProbeQuery& ray : rays) ray.origin = spoiled(ray.origin, {kInf, -kInf, kNan});
    expectMisses(rays);
}

TEST_F(Hostile, SecondaryRaysThatAreNotFinite) {
    Queries rays = randomRays(kRays, 1.2, 1.0);
    for (ProbeQuery& ray : rays) {
        ray.secondary = true;
        dvec3& spoilt = random_() % 2 ? ray.origin : ray.direction;
        spoilt = spoiled(spoilt, {kInf, -kInf, kNan});
    }
    expectMisses(rays);
}

TEST_F(Hostile, DirectionsOfZero) {
    Queries rays = randomRays(kRays, 3.0, 1.0);
    for (std::size_t k = 0; k < rays.size(); ++k) {
        rays[k].direction = dvec3(k & 1 ? 0.0 : -0.0, k & 2 ? 0.0 : -0.0, k & 4 ? 0.0 : -0.0);
        rays[k].secondary = (k & 8) != 0;
    }
    expectMisses(rays);
}

// Also from inside the solid, where any other ray hits at once.
TEST_F(Hostile, DirectionsOfZeroInsideTheSolid) {
    Queries rays = randomRays(kRays, 0.5, 0.3);
    for (ProbeQuery& ray : rays) ray.direction = dvec3(0.0);
    expectMisses(rays);
}

TEST_F(Hostile, DenormalDirections) {
    Queries rays = randomRays(kRays, 3.0, 1.0);
    for (std::size_t k = 0; k < rays.size(); ++k)
        rays[k].direction *= k % 2 ? 1e-310 : kFloatTiny / glm::length(rays[k].direction);
    expectMissesOrTheRightHits(rays);
}

// One or two coordinates all but vanish: rays like any other.
TEST_F(Hostile, DenormalCoordinates) {
    Queries rays = randomRays(kRays, 3.0, 1.0);
    for (std::size_t k = 0; k < rays.size(); ++k) {
        dvec3& v = k % 2 ? rays[k].origin : rays[k].direction;
        double kept = v[int(k % 3)];
        v = spoiled(v, {kTiny, -kTiny, kFloatTiny, -kFloatTiny, 1e-39, 0.0});
        v[int(k % 3)] = kept;
    }
    expectContract(probe(world_, rays));
}

TEST_F(Hostile, AtTheCentre) {
    Queries rays = randomRays(kRays, 3.0, 1.0);
    for (ProbeQuery& ray : rays) ray.origin = spoiled(dvec3(0.0), {kTiny, -kTiny, kFloatTiny, 1e-39, -0.0});
    std::vector<layout::ProbeHit> hits = trace(rays);
    for (std::size_t k = 0; k < hits.size(); ++k) ASSERT_EQ(hits[k].flags & 3u, 3u) << describe(rays, k);
}

TEST_F(Hostile, HugeDirections) {
    Queries rays = randomRays(kRays, 3.0, 1.0);
    for (ProbeQuery& ray : rays) ray.direction *= std::pow(10.0, uniform(random_, 30.0, 307.0));
    expectMissesOrTheRightHits(rays);
}

// Beyond what float holds, towards the sphere and away from it.
TEST_F(Hostile, OriginsFarBeyondFloat) {
    Queries rays = randomRays(kRays, 1.0, 0.0);
    for (ProbeQuery& ray : rays) {
        ray.direction = (random_() % 2 ? -1.0 : 1.0) * ray.origin;
        ray.origin *= std::pow(10.0, uniform(random_, 8.0, 300.0));
    }
    trace(rays);
}

TEST_F(Hostile, LengthsThatAreNoLengths) {
    Queries rays = randomRays(kRays, 3.0, 1.0);
    for (std::size_t k = 0; k < rays.size(); ++k) {
        const double lengths[] = {0.0, -0.0, -1.0, -kInf, kTiny, -1e30};
        rays[k].length = lengths[k % std::size(lengths)];
        rays[k].secondary = k % 2 != 0;
    }
    expectMisses(rays);
}

}  // namespace
}  // namespace dsphere::conformance
