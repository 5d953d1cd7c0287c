// Rays of one's own against the certified reference.

#include "query/certify.h"
#include "tests/query/fixture.h"
#include "tests/support/keepdriver.h"

#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

namespace dsphere::query {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

class Rays : public QueryTest {
  protected:
    std::vector<Answer> trace(World& world, const std::vector<QueryRay>& rays) {
        std::vector<Answer> answers(rays.size());
        world.engine.trace(
            rays.size(), [&](std::size_t i) { return rays[i]; },
            [&](std::size_t i, const Answer& answer) { answers[i] = answer; });
        EXPECT_EQ(world.engine.runaways(), 0u);
        return answers;
    }

    void expectCertified(World& world, const std::vector<QueryRay>& rays, Frame frame = Frame::World) {
        const std::vector<Answer> answers = trace(world, rays);
        Certifier certifier(world.scene, world.maps, frame, false);
        std::uint64_t enclosed = 0;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const Truth truth = certifier.check(i, rays[i], answers[i]);
            const QueryHit& hit = answers[i].hit;
            if (hit.status == QueryStatus::Hit && std::abs(hit.t - truth.t_low) < 1e-9 * (1.0 + hit.t)) ++enclosed;
        }
        const verify::Report& report = certifier.report();
        EXPECT_EQ(fmt::format("{}", fmt::join(certifier.violations(), "\n")), "");
        EXPECT_GT(report.hits, rays.size() / 8);
        EXPECT_LE(report.tangent, 3u);
        EXPECT_LT(report.distanceQuantile(0.999), 1e-10);
        EXPECT_GT(enclosed, report.distances.size() * 99 / 100);
    }
};

/// Near, far, grazing, polar, from inside, along axes, with ends, and none at all, at a body of that greatest radius.
std::vector<QueryRay> manyRays(std::size_t count, double radius, unsigned seed) {
    std::mt19937_64 random(seed);
    const auto uniform = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    const auto unit = [&] {
        std::normal_distribution<double> normal;
        return glm::normalize(dvec3(normal(random), normal(random), normal(random)));
    };
    std::vector<QueryRay> rays;
    for (std::size_t i = 0; i < count; ++i) {
        const dvec3 target = unit() * radius * uniform(0.0, 1.02);
        dvec3 origin = unit() * radius * (1.0 + std::pow(10.0, uniform(-3.0, 0.3))), direction = target - origin;
        QueryRay ray;
        const int kind = int(i % 9);
        if (kind == 1) origin *= std::pow(10.0, uniform(0.0, 6.0)), direction = target - origin;
        if (kind == 2) {
            const dvec3 foot = unit() * radius * uniform(0.9, 1.0005);
            direction = glm::normalize(glm::cross(foot, unit())) * std::pow(10.0, uniform(-3.0, 3.0));
            origin = foot - glm::normalize(direction) * radius * std::pow(10.0, uniform(0.1, 2.0));
        }
        if (kind == 3) {
            const double off = std::pow(10.0, uniform(-6.0, -1.0)) * radius;
            const dvec3 pole(off * uniform(-1.0, 1.0), i % 2 ? radius : -radius, -off);
            origin = pole * 2.5 + unit() * radius;
            direction = pole - origin;
        }
        if (kind == 4) origin = target, direction = unit();
        if (kind == 5) {
            direction = dvec3(0.0);
            direction[int(i / 9 % 3)] = i % 2 ? 1.0 : -1.0;
            origin = -2.0 * radius * direction + (i % 5 ? target * 0.9 : dvec3(0.0));
        }
        if (kind == 6) ray.t_min = uniform(0.0, 0.5), ray.t_max = uniform(0.5, 1.5);
        ray.origin = {origin.x, origin.y, origin.z};
        ray.direction = {direction.x, direction.y, direction.z};
        if (kind == 7) ray.origin[i / 9 % 3] = i % 2 ? kInfinity : std::nan("");
        if (kind == 8 && i % 2) ray.direction = {0.0, 0.0, 0.0};
        if (kind == 8 && i % 2 == 0)
            for (double& x : ray.origin) x *= 1e200;
        rays.push_back(ray);
    }
    return rays;
}

TEST_F(Rays, AFractalIsCertified) {
    World planet_world = world(planet("\"float maxdispl\" 5"));
    expectCertified(planet_world, manyRays(9000, 1.05, 1));
}

TEST_F(Rays, ACoarseSteepMapIsCertified) {
    World spikes = world(planet("\"float maxdispl\" 60", "coarse.pgm"));
    expectCertified(spikes, manyRays(9000, 1.6, 2));
}

TEST_F(Rays, ABodyInMetresIsCertified) {
    World moon = world(planet("\"float radius\" 1737400 \"float maxdispl\" 2"));
    expectCertified(moon, manyRays(9000, 1737400.0 * 1.02, 3));
}

TEST_F(Rays, SplinesAndRipplesAreCertified) {
    World spline = world(planet("\"float maxdispl\" 15 \"string filter\" \"bspline\""));
    expectCertified(spline, manyRays(9000, 1.15, 4));
    World ripples =
        world("Shape \"displacedsphere\" \"string displacementfunction\" \"ripples\" \"float maxdispl\" 20\n");
    expectCertified(ripples, manyRays(9000, 1.2, 5));
}

TEST_F(Rays, ThreePlacedShapesAreCertified) {
    const std::string shapes = "AttributeBegin Translate .5 0 0 Rotate 30 1 2 3 " +
                               planet("\"float radius\" .5 \"float maxdispl\" 10") +
                               "AttributeEnd AttributeBegin Translate -.5 .2 .1 Scale .4 -.4 .4 " +
                               planet("\"float maxdispl\" 20", "coarse.pgm") +
                               "AttributeEnd Translate 0 -.6 .3 Shape \"sphere\" \"float radius\" .3\n";
    World three = world(shapes);
    expectCertified(three, manyRays(9000, 0.8, 6));
    World body = world(shapes, {.frame = Frame::Body});
    expectCertified(body, manyRays(9000, 0.8, 7), Frame::Body);
}

TEST_F(Rays, RaysThatAreNoneHaveTheStatus255) {
    World planet_world = world(planet("\"float maxdispl\" 5"));
    const double nan = std::nan("");
    const std::vector<QueryRay> rays = {{{0, 0, 4}, {0, 0, 0}},
                                        {{nan, 0, 4}, {0, 0, -1}},
                                        {{0, 0, 4}, {0, kInfinity, -1}},
                                        {{0, 0, 4}, {0, 0, -1}, nan},
                                        {{0, 0, 4}, {0, 0, -1}, 0.0, nan},
                                        {{0, 0, 4}, {0, 0, -1e-300}},
                                        {{0, 0, 4}, {0, 0, -1}, 5.0, 1.0},
                                        {{0, 0, 1e300}, {0, 1e300, -1}},
                                        {{0, 0, 4}, {0, 0, -1e-200}}};
    const std::vector<Answer> answers = trace(planet_world, rays);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(answers[i].hit.status, QueryStatus::Invalid) << i;
    EXPECT_EQ(answers[6].hit.status, QueryStatus::Miss);
    EXPECT_EQ(answers[7].hit.status, QueryStatus::Miss);
    EXPECT_EQ(answers[8].hit.status, QueryStatus::Hit);
    EXPECT_TRUE(std::isnan(answers[6].hit.t) && std::isnan(answers[6].hit.position[0]));
    EXPECT_TRUE(std::isnan(answers[6].hit.height) && answers[6].hit.id == 0);
}

// A flat sphere of radius 1: all in closed form.
TEST_F(Rays, EveryFieldOfAFlatSphere) {
    World flat = world("Translate 10 0 0 Scale 2 2 2 Shape \"displacedsphere\"\n", {.wishes = {.lit = true}});
    const std::vector<QueryRay> rays = {{{18, 0, 0}, {-2, 0, 0}},        // from +x: longitude 90
                                        {{10, 5, 0}, {0, -1, 0}},        // the north pole
                                        {{10, 0, 5}, {0, 0, -1}, 4, 9},  // begins inside
                                        {{10, 0, 5}, {0, 0, -1}, 0, 2.9}};
    const std::vector<Answer> answers = trace(flat, rays);
    const QueryHit& east = answers[0].hit;
    EXPECT_EQ(east.status, QueryStatus::Hit);
    EXPECT_NEAR(east.t, 3.0, 1e-14);
    EXPECT_NEAR(east.position[0], 12.0, 1e-14);
    EXPECT_FLOAT_EQ(east.normal[0], 1.0f);
    EXPECT_NEAR(east.u, 0.75, 1e-15);
    EXPECT_NEAR(east.v, 0.5, 1e-15);
    EXPECT_NEAR(east.longitude, 90.0, 1e-12);
    EXPECT_NEAR(east.latitude, 0.0, 1e-12);
    EXPECT_EQ(east.height, 0.0);
    EXPECT_EQ(east.id, 1u);
    EXPECT_EQ(east.lit, 1u) << "the sun stands there";
    EXPECT_NEAR(answers[1].hit.latitude, 90.0, 1e-12);
    EXPECT_FLOAT_EQ(answers[1].hit.normal[1], 1.0f);
    EXPECT_EQ(answers[2].hit.status, QueryStatus::Inside);
    EXPECT_EQ(answers[2].hit.t, 4.0);
    EXPECT_NEAR(answers[2].hit.position[2], 1.0, 1e-15);
    EXPECT_EQ(answers[3].hit.status, QueryStatus::Miss) << "ends before it";
}

TEST_F(Rays, MetresAreWhatTheMapSaysItsValuesMean) {
    std::string map = "P5\n# Offset -100\n# Scale 0.01\n4 2\n65535\n";
    for (int i = 0; i < 8; ++i) map += "\x75\x30";  // 30000
    folder_.write("metres.pgm", map);
    const std::vector<QueryRay> down = {{{3, 0, 0}, {-1, 0, 0}}};
    World known = world(planet("", "metres.pgm"));
    const QueryHit hit = trace(known, down)[0].hit;
    EXPECT_EQ(hit.height, 30000.0);
    EXPECT_NEAR(hit.metres, 200.0, 1e-9);
    World unknown = world(planet(""));
    EXPECT_TRUE(std::isnan(trace(unknown, down)[0].hit.metres));
}

TEST_F(Rays, AnswersKeepTheOrderAcrossBlocks) {
    World planet_world = world(planet("\"float maxdispl\" 5"));
    constexpr std::size_t kCount = 300'001;
    std::vector<std::uint8_t> seen(kCount);
    std::atomic<std::uint64_t> wrong = 0;
    // Ray i looks down at longitude i / 1000 degrees.
    planet_world.engine.trace(
        kCount,
        [](std::size_t i) {
            const double lon = glm::radians(double(i) / 1000.0);
            return QueryRay{{3.0 * std::sin(lon), 0.0, 3.0 * std::cos(lon)}, {-std::sin(lon), 0.0, -std::cos(lon)}};
        },
        [&](std::size_t i, const Answer& answer) {
            ++seen[i];
            const double off = answer.hit.longitude - double(i) / 1000.0;
            if (std::abs(off - 360.0 * std::round(off / 360.0)) > 1e-9) ++wrong;
        });
    EXPECT_EQ(wrong, 0u);
    EXPECT_EQ(std::count(seen.begin(), seen.end(), 1), std::ptrdiff_t(kCount));
}

// Those that enter far apart are traced in another order, and those that pass by not at all.
TEST_F(Rays, TheOrderOfRaysChangesNothing) {
    World planet_world = world(planet("\"float maxdispl\" 5"));
    std::vector<QueryRay> rows;
    for (int j = 0; j < 100; ++j)
        for (int i = 0; i < 200; ++i) rows.push_back({{0, 0, 4}, {0.4 * (i - 99.5) / 100, 0.4 * (j - 49.5) / 50, -1}});
    std::vector<std::size_t> order(rows.size());
    std::iota(order.begin(), order.end(), 0u);
    std::ranges::shuffle(order, std::mt19937(1));
    std::vector<QueryRay> shuffled;
    for (const std::size_t i : order) shuffled.push_back(rows[i]);
    const std::vector<Answer> expected = trace(planet_world, rows), answers = trace(planet_world, shuffled);
    std::size_t hits = 0, different = 0;
    for (std::size_t k = 0; k < order.size(); ++k) {
        const QueryHit &hit = answers[k].hit, &same = expected[order[k]].hit;
        hits += hit.status == QueryStatus::Hit;
        const bool equal = hit.status == QueryStatus::Hit ? hit.t == same.t && hit.normal == same.normal : true;
        different += hit.status != same.status || !equal;
    }
    EXPECT_GT(hits, order.size() / 4);
    EXPECT_LT(hits, order.size() * 3 / 4);
    EXPECT_EQ(different, 0u);
}

TEST_F(Rays, TheCertifierFindsWhatIsWrong) {
    World planet_world = world(planet("\"float maxdispl\" 5"));
    const std::vector<QueryRay> rays = {{{0, 0, 4}, {0, 0, -1}}, {{0, 4, 4}, {0, 0, -1}}, {{1.0, 0, 4}, {0, 0, -1}}};
    std::vector<Answer> answers = trace(planet_world, rays);
    Certifier right(planet_world.scene, planet_world.maps, Frame::World, true);
    EXPECT_FALSE(right.check(0, rays[0], answers[0]).tangent);
    EXPECT_TRUE(right.violations().empty());
    Certifier certifier(planet_world.scene, planet_world.maps, Frame::World, false);
    answers[0].hit.t += 1e-3;
    certifier.check(0, rays[0], answers[0]);
    answers[1] = answers[0];
    certifier.check(1, rays[1], answers[1]);
    answers[2] = Answer();
    certifier.check(2, rays[2], answers[2]);
    EXPECT_EQ(certifier.report().later_roots, 1u);
    EXPECT_EQ(certifier.report().wrong_verdicts, 2u);
    EXPECT_FALSE(certifier.violations().empty());
}

// A ray that just passes above a flat sphere.
TEST_F(Rays, ARayThatGrazesIsTangent) {
    World flat = world("Shape \"displacedsphere\"\n");
    const std::vector<QueryRay> rays = {{{1.0 + 5e-7, 0, 4}, {0, 0, -1}}, {{1.0 + 5e-6, 0, 4}, {0, 0, -1}}};
    const std::vector<Answer> answers = trace(flat, rays);
    Certifier certifier(flat.scene, flat.maps, Frame::World, true);
    EXPECT_TRUE(certifier.check(0, rays[0], answers[0]).tangent);
    EXPECT_FALSE(certifier.check(1, rays[1], answers[1]).tangent);
}

TEST(QueryLibrary, AsksAFileOfAScene) {
    const test::TempFolder folder;
    folder.write("flat.pbrt", "WorldBegin Shape \"displacedsphere\" \"float radius\" 2");
    Query query((folder.path() / "flat.pbrt").string(), {.device = test::testDevice()});
    const QueryHit hit = query.trace(QueryRay{{0, 0, 5}, {0, 0, -1}});
    EXPECT_EQ(hit.status, QueryStatus::Hit);
    EXPECT_NEAR(hit.t, 3.0, 1e-14);
    EXPECT_NEAR(hit.u, 0.5, 1e-15);
    const std::vector<QueryRay> rays = {{{0, 0, 5}, {0, 0, -1}}, {{0, 5, 5}, {0, 0, -1}}, {{0, 0, 0}, {0, 0, 1}}};
    EXPECT_EQ(query.statuses(rays), (std::vector{QueryStatus::Hit, QueryStatus::Miss, QueryStatus::Inside}));
    const std::vector<CertifiedHit> certified = query.traceCertified(rays);
    for (const CertifiedHit& answer : certified) EXPECT_FALSE(answer.wrong);
    EXPECT_NEAR(certified[0].t_low, 3.0, 1e-12);
    EXPECT_NEAR(certified[0].t_high, 3.0, 1e-12);
    EXPECT_TRUE(std::isnan(certified[1].t_low));
    EXPECT_TRUE(query.trace(std::span<const QueryRay>()).empty());
    EXPECT_THROW(Query((folder.path() / "none.pbrt").string()), std::runtime_error);
}

}  // namespace
}  // namespace dsphere::query
