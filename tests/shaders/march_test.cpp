#include "reference/firsthit.h"
#include "tests/shaders/planet.h"
#include "tests/support/testmaps.h"

#include <gtest/gtest.h>

#include <random>

namespace dsphere::test {
namespace {

glsl64::Pair wide(double value) {
    return {value, 0.0};
}

glsl32::Pair narrow(double value) {
    return {float(value), float(value - double(float(value)))};
}

struct Query {
    dvec3 origin, direction;  // units of R
};

std::vector<Query> randomQueries(int count) {
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    auto vector = [&] { return dvec3(normal(random), normal(random), normal(random)); };
    std::vector<Query> queries;
    for (int k = 0; k < count; ++k) {
        dvec3 origin = glm::normalize(vector()) * (k % 2 ? 3.0 : 1.02);
        dvec3 target = 0.5 * vector();
        if (k % 5 == 0) target = dvec3(0.02 * normal(random), k % 10 ? 0.9 : -0.9, 0.02 * normal(random));
        queries.push_back({origin, glm::normalize(target - origin)});
    }
    return queries;
}

struct Tally {
    int hits = 0, wrong64 = 0, wrong32 = 0;
    int wrong_filter = 0, doubtful = 0;  // of the float filter, which may leave a ray undecided
    int given_up = 0;                    // of these, after the filter's limit of steps
};

// Compares the marcher in both precisions with the certified reference; a tangent ray may have either answer.
Tally compare(const Planet& planet, const std::vector<Query>& queries) {
    Tally tally;
    double unit = planet.unit(), base = planet.packed.reliefs[0].base, scale = planet.packed.reliefs[0].scale;
    for (const Query& query : queries) {
        dvec3 d = query.direction, c = glm::cross(d, glm::cross(query.origin, d));
        double before = -glm::dot(query.origin, d);
        reference::Ray ray{query.origin * unit, d};
        reference::FirstHit truth = reference::firstHit(*planet.surface, ray);
        auto agrees = [&](const reference::FirstHit& hit, bool device, double s) {
            return hit.hit == device && (!device || std::abs(hit.t() / unit - before - s) <= 1e-4);
        };
        auto right = [&](bool hit, double s) {
            if (agrees(truth, hit, s)) return true;
            for (const reference::Ray& moved : reference::sidewaysRays(*planet.surface, ray))
                if (agrees(reference::firstHit(*planet.surface, moved), hit, s)) return true;
            return false;
        };
        glsl64::Line line64{wide(c.x), wide(c.y), wide(c.z), wide(d.x), wide(d.y), wide(d.z)};
        auto walk64 = glsl64::march(glsl64::makeRay(line64, before, 1e30, true), planet.map(), wide(base), scale,
                                    planet.object().shell_squared);
        tally.wrong64 += right(walk64.hit, walk64.hit ? walk64.frame.anchor.s + walk64.sigma : 0.0) ? 0 : 1;
        glsl32::Line line32{narrow(c.x), narrow(c.y), narrow(c.z), narrow(d.x), narrow(d.y), narrow(d.z)};
        auto walk32 = glsl32::march(glsl32::makeRay(line32, float(before), 1e30f, true), planet.map(), narrow(base),
                                    float(scale), planet.object().shell_squared);
        tally.wrong32 += right(walk32.hit, walk32.hit ? walk32.frame.anchor.s + walk32.sigma : 0.0) ? 0 : 1;
        auto ray32 = glsl32::makeRay(line32, float(before), 1e30f, true);
        auto filtered =
            glsl32::filterMarch(ray32, planet.map(), float(base), float(scale), planet.object().shell_squared);
        double s_filtered = 0.0;
        if (filtered.hit)
            s_filtered =
                glm::dot(dvec3(glsl32::filterRefine(ray32, planet.map(), narrow(base), float(scale), filtered).p), d);
        tally.doubtful += filtered.doubtful ? 1 : 0;
        tally.given_up += filtered.steps >= glsl32::kFilterSteps ? 1 : 0;
        tally.wrong_filter += filtered.doubtful || right(filtered.hit, s_filtered) ? 0 : 1;
        tally.hits += truth.hit ? 1 : 0;
        EXPECT_FALSE(walk64.exhausted);
        EXPECT_FALSE(walk32.exhausted);
    }
    return tally;
}

// A fifth of the queries is aimed at the poles, where single floats can decide least.
void expectRight(const Planet& planet, double doubtful_share = 0.02) {
    std::vector<Query> queries = randomQueries(4000);
    Tally tally = compare(planet, queries);
    EXPECT_GT(tally.hits, 1000);
    EXPECT_EQ(tally.wrong64, 0) << "the algorithm";
    EXPECT_EQ(tally.wrong32, 0) << "float precision";
    EXPECT_EQ(tally.wrong_filter, 0) << "the filter";
    EXPECT_EQ(tally.given_up, 0) << "a filter that does not get on";
    EXPECT_LT(tally.doubtful, int(doubtful_share * double(queries.size()))) << "rays left to full precision";
}

// Rays that pass the axis closer than floats can tell on which side, which decides which way their longitude grows; and
// where they come below the greatest radius, so that a walk begins beside the axis.
std::vector<Query> queriesBesideTheAxis(int count) {
    std::mt19937 random(6);
    std::uniform_real_distribution<double> uniform(-1.0, 1.0);
    std::vector<Query> queries;
    for (int k = 0; k < count; ++k) {
        const dvec3 level = glm::normalize(dvec3(uniform(random), 0.0, uniform(random)));
        const dvec3 direction = glm::normalize(level - dvec3(0.0, (k % 2 ? 1.2 : -1.2), 0.0));
        const dvec3 aside = std::pow(10.0, -8.0 + uniform(random)) * dvec3(level.z, 0.0, -level.x);
        const dvec3 on_axis(0.0, (k % 2 ? 1.0 : -1.0) * (1.0 + 3e-6 * uniform(random)), 0.0);
        queries.push_back({on_axis + aside - 2.0 * direction, direction});
    }
    return queries;
}

TEST(Marcher, BesideTheAxis) {
    const Planet planet(checkerboardMap(512, 256), 30.0);
    const Tally tally = compare(planet, queriesBesideTheAxis(4000));
    EXPECT_GT(tally.hits, 1000);
    EXPECT_EQ(tally.wrong64, 0);
    EXPECT_EQ(tally.wrong32, 0);
    EXPECT_EQ(tally.wrong_filter, 0);
}

TEST(Marcher, Fractal) {
    expectRight(Planet(fractalMap(1024, 512), 5.0));
}
TEST(Marcher, SteepFractal) {
    expectRight(Planet(fractalMap(1024, 512), 50.0));
}
TEST(Marcher, Checkerboard) {
    expectRight(Planet(checkerboardMap(512, 256), 25.0));
}
TEST(Marcher, Spikes) {
    expectRight(Planet(spikeMap(1024, 512), 60.0));
}
TEST(Marcher, OddSize) {
    expectRight(Planet(randomMap(257, 129), 15.0));
}
TEST(Marcher, NegativeDisplacement) {
    expectRight(Planet(randomMap(512, 256), -15.0));
}
TEST(Marcher, Gridline) {
    expectRight(Planet(randomMap(90, 46), 30.0, Registration::Gridline));
}
TEST(Marcher, TwoTexels) {
    expectRight(Planet(randomMap(2, 1), 50.0));
}
TEST(Marcher, Terraces) {
    expectRight(Planet(terraceMap(512, 256), 10.0));
}

#ifdef WITH_CURVED
Planet spline(RawMap map, double percent, Registration registration = Registration::Texel) {
    return Planet(std::move(map), percent, registration, Filter::BSpline);
}

TEST(Marcher, SplineOfAFractal) {
    expectRight(spline(fractalMap(1024, 512), 50.0));
}
// Its relief is all but averaged out, nearly level ground, and steep only towards the poles: 163 of the 4,000 in doubt.
TEST(Marcher, SplineOfACheckerboard) {
    expectRight(spline(checkerboardMap(512, 256), 25.0), 0.05);
}
TEST(Marcher, SplineOfSpikes) {
    expectRight(spline(spikeMap(1024, 512), 60.0));
}
TEST(Marcher, SplineOfAGridlineMap) {
    expectRight(spline(randomMap(90, 46), 30.0, Registration::Gridline));
}
TEST(Marcher, SplineOfTwoTexels) {
    expectRight(spline(randomMap(2, 1), -50.0));
}
TEST(Marcher, Ripples) {
    expectRight(Planet(dsphere::Ripples{12, 12}, 15.0));
}
TEST(Marcher, SteepRipples) {
    expectRight(Planet(dsphere::Ripples{60, 41}, 60.0));
}
#endif

}  // namespace
}  // namespace dsphere::test
