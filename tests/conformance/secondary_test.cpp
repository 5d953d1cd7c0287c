// Rays that start on the surface: free of it where they leave, stopped where they do not.

#include "base/parallel.h"
#include "reference/firsthit.h"
#include "tests/conformance/fixture.h"
#include "tests/support/testmaps.h"

#include <atomic>
#include <cmath>

namespace dsphere::conformance {
namespace {

struct SecondaryCase {
    std::string name;
    RawMap (*map)(int width, int height, std::uint32_t seed);
    double percent;
    int rows = 256;

    friend void PrintTo(const SecondaryCase& c, std::ostream* out) { *out << c.name; }
};

class Secondary : public Conformance, public testing::WithParamInterface<SecondaryCase> {
  protected:
    World world_ = sphereWorld(GetParam().map(512, GetParam().rows, 1), GetParam().percent);
    PackedScene packed_ = packScene(world_.scene, world_.maps);
    std::unique_ptr<RayProbe> probe_ = makeProbe(packed_);
    reference::Surface surface_{*world_.maps.maps[0], world_.maps.reliefs[0]};
    Random random_{41};

    /// P' of camera rays' hits, rounded to float, with directions to all sides.
    Queries starts() {
        Queries queries;
        for (const layout::ProbeHit& hit : probe_->trace(randomRays(3 * kRays, 3.0, 0.9, 42))) {
            if (hit.flags != 1u || int(queries.size()) == kRays) continue;
            dvec3 start(glm::vec3(dvec3(hit.position) + 1e-6 * dvec3(hit.normal)));
            queries.push_back({.origin = start, .direction = randomUnit(random_), .secondary = true});
        }
        return queries;
    }

    // To the end of the query's length; t is in units of R, since the direction is unit.
    reference::Ray referenceRay(const ProbeQuery& query, double length) const {
        return {.origin = query.origin * world_.unit(),
                .direction = query.direction * world_.unit(),
                .t_max = length,
                .may_start_inside = false};
    }

    bool hits(const reference::Ray& ray) const { return reference::firstHit(surface_, ray).hit; }

    // The verdict flips when the ray is moved sideways by at most 1e-6 R, or its end by the bound along the ray.
    bool excused(const ProbeQuery& query, bool device_hit) const {
        reference::Ray ray = referenceRay(query, query.length);
        for (const reference::Ray& moved : reference::sidewaysRays(surface_, ray))
            if (hits(moved) == device_hit) return true;
        reference::FirstHit whole = reference::firstHit(surface_, referenceRay(query, 1e30));
        if (!whole.hit) return false;
        double cosine = std::abs(glm::dot(surface_.normal(whole.position), query.direction));
        return std::abs(whole.t() - query.length) <= verify::contract::kAlongRay / cosine;
    }

    void expectVerdicts(const Queries& queries) {
        std::vector<layout::ProbeHit> answers = probe_->trace(queries);
        ASSERT_GE(queries.size(), kLeastRays);
        std::atomic<std::uint64_t> tangent = 0, hit_count = 0;
        std::atomic<std::size_t> wrong = 0, wrong_ray = 0, broken = 0;
        parallelFor(queries.size(), [&](std::size_t k) {
            bool device_hit = (answers[k].flags & 1u) != 0, truth = hits(referenceRay(queries[k], queries[k].length));
            hit_count += truth;
            for (int c = 0; c < 4; ++c)
                if (!std::isfinite(answers[k].position[c]) || !std::isfinite(answers[k].normal[c])) ++broken;
            if (answers[k].flags & 4u) ++broken;
            if (device_hit == truth) return;
            if (excused(queries[k], device_hit)) {
                ++tangent;
            } else {
                ++wrong;
                wrong_ray = k;
            }
        });
        EXPECT_GT(hit_count, queries.size() / 4) << "too few blocked rays to tell";
        EXPECT_LT(hit_count, queries.size() * 3 / 4 + queries.size() / 8) << "too few free rays to tell";
        EXPECT_EQ(broken, 0u) << "answers that are not finite or ran away";
        EXPECT_EQ(wrong, 0u) << "the last is ray " << wrong_ray;
        EXPECT_LE(double(tangent),
                  verify::contract::kTangentShare * double(queries.size()) + verify::contract::kTangentFree);
    }
};

TEST_P(Secondary, ToAllSides) {
    expectVerdicts(starts());
}

TEST_P(Secondary, OfLimitedLength) {
    Queries queries = starts();
    for (ProbeQuery& query : queries) query.length = std::abs(logarithmic(random_, 1e-3, 2.0));
    expectVerdicts(queries);
}

INSTANTIATE_TEST_SUITE_P(On, Secondary,
                         testing::Values(SecondaryCase{"Fractal", test::fractalMap, 15.0},
                                         SecondaryCase{"Needles", test::spikeMap, 15.0},
                                         SecondaryCase{"Random", test::randomMap, 15.0}),
                         caseName<SecondaryCase>);

class Cracks : public Secondary {};

// Beside the bottom of a steep valley P' lies in its other side: a ray that rises from there is free until it goes in
// again.
TEST_P(Cracks, AreLeftFirst) {
    const Heightmap& map = *world_.maps.maps[0];
    const double unit = world_.unit();
    Queries queries;
    for (int tries = 0; tries < 400 * kRays && int(queries.size()) < kRays; ++tries) {
        const double longitude = uniform(random_, -kPi, kPi);
        const double latitude = nodeLatitude(map, 1 + int(random_() % std::uint64_t(map.height - 2)));
        const dvec3 way = direction(longitude, latitude - uniform(random_, 1e-8, 3e-7));
        const dvec3 p = surface_.radius(way) * way;
        const dvec3 start(glm::vec3((p + 1e-6 * unit * surface_.normal(p)) / unit));
        const dvec3 towards = randomUnit(random_);
        if (surface_.f(start * unit) >= 0.0 || glm::dot(surface_.gradient(start * unit), towards) <= 0.0) continue;
        queries.push_back({.origin = start, .direction = towards, .secondary = true});
    }
    expectVerdicts(queries);
}

INSTANTIATE_TEST_SUITE_P(Of, Cracks, testing::Values(SecondaryCase{"ATallMap", test::randomMap, 0.6, 8192}),
                         caseName<SecondaryCase>);

using Shadows = Conformance;

// P' lies outside the solid, at most 3e-6 R from the surface (1e-6 R of the hit, 2e-6 R of the step), so that shadow
// rays neither start in the solid nor pass over what they should meet.
TEST_F(Shadows, StartOutsideTheSolid) {
    World world = sphereWorld(test::fractalMap(512, 256), 15.0);
    world.addSun({1.0, 0.6, 0.8});
    world.lookAt({1.0, 0.7, 2.7}, dvec3(0.0), {0.0, 1.0, 0.0}, 45.0);
    verify::Outcome outcome = picture(world);
    expectContract(outcome.report);
    reference::Surface surface(*world.maps.maps[0], world.maps.reliefs[0]);
    const Image& image = outcome.device;
    std::uint64_t inside = 0, far_off = 0, starts = 0;
    for (std::size_t i = 0; i < image.pixelCount(); ++i) {
        if (image.at("id").uints()[i] == 0) continue;
        dvec3 start(image.at("start.X").floats()[i], image.at("start.Y").floats()[i], image.at("start.Z").floats()[i]);
        start *= world.unit();
        double height = surface.f(start) / glm::length(surface.gradient(start)) / world.unit();
        ++starts;
        inside += height <= 0.0;
        far_off += height > 3e-6;
    }
    EXPECT_GT(starts, 5000u);
    EXPECT_EQ(inside, 0u);
    EXPECT_EQ(far_off, 0u);
}

}  // namespace
}  // namespace dsphere::conformance
