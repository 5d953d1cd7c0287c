// Rays in the planes and on the lines where coordinates vanish or wrap: centre, poles, seam, meridians, equator.

#include "tests/conformance/fixture.h"
#include "tests/support/testmaps.h"

#include <cmath>

namespace dsphere::conformance {
namespace {

using Axes = Conformance;

constexpr double kDoubleUlp = 0x1p-52, kFloatUlp = 0x1p-23;  // of 1

/// Steep everywhere, at the poles too.
RawMap steepMap(int width = 512, int height = 256) {
    return test::randomMap(width, height);
}

World gridlineWorld(RawMap raw, double percent) {
    DisplacedSphere sphere;
    sphere.max_displacement = percent;
    sphere.registration = Registration::Gridline;
    return sphereWorld(std::move(raw), sphere);
}

TEST_F(Axes, ThroughTheCentre) {
    Random random(2);
    Queries rays;
    for (int k = 0; k < kRays; ++k) {
        dvec3 from = uniform(random, 1.01, 50.0) * randomUnit(random);
        rays.push_back({.origin = from, .direction = -from});
    }
    expectContract(probe(sphereWorld(steepMap(), 15.0), rays));
}

TEST_F(Axes, OneUlpBesideTheCentre) {
    Random random(3);
    Queries rays;
    for (double ulp : {kDoubleUlp, kFloatUlp}) {
        for (int k = 0; k < kRays / 2; ++k) {
            dvec3 from = 3.0 * randomUnit(random), beside = ulp * randomAcross(random, from);
            rays.push_back({.origin = from + beside, .direction = -from});
        }
    }
    expectContract(probe(sphereWorld(steepMap(), 15.0), rays));
}

// Along the axis exactly, then one ulp (of 1 or of the least number) and more beside it and tilted by as much.
Queries poleRays(double side) {
    Random random(4);
    Queries rays;
    const double tiny[] = {0.0, -0.0, 0x1p-1074, -0x1p-149, kDoubleUlp, -kDoubleUlp, kFloatUlp, -kFloatUlp};
    auto offset = [&] { return random() % 2 ? tiny[random() % std::size(tiny)] : logarithmic(random, 1e-18, 1e-2); };
    for (int k = 0; k < kRays; ++k) {
        ProbeQuery ray{.origin = {0.0, side * uniform(random, 1.001, 20.0), 0.0}, .direction = {0.0, -side, 0.0}};
        if (k % 4 != 0) ray.origin += dvec3(offset(), 0.0, offset());
        if (k % 4 == 2) ray.direction += dvec3(offset(), 0.0, offset());
        rays.push_back(ray);
    }
    return rays;
}

TEST_F(Axes, DownTheAxisOntoTheNorthPole) {
    // A pole is the apex of a cone: all patches of its row meet there, with as many normals.
    expectContractButNormals(probe(sphereWorld(steepMap(), 15.0), poleRays(1.0)));
}

TEST_F(Axes, UpTheAxisOntoTheSouthPole) {
    expectContractButNormals(probe(sphereWorld(steepMap(), 15.0), poleRays(-1.0)));
}

TEST_F(Axes, FromTheCentreAndTheAxisWithin) {
    Random random(6);
    Queries rays;
    for (int k = 0; k < kRays; ++k) {
        const double y = k % 2 ? 0.0 : uniform(random, -0.8, 0.8);
        rays.push_back({.origin = {0.0, y, 0.0}, .direction = randomUnit(random)});
    }
    const verify::Report report = probe(sphereWorld(steepMap(), 15.0), rays);
    expectContract(report);
    EXPECT_EQ(report.hits, report.rays);
}

// The cosines of its first parallels round to those of their neighbours.
TEST_F(Axes, BesideThePolesOfATallMap) {
    Random random(5);
    Queries rays;
    for (int k = 0; k < kManyRays; ++k) {
        const double side = k % 2 ? 1.0 : -1.0;
        const auto beside = [&] {
            return std::abs(logarithmic(random, 1e-6, 2e-2)) * direction(uniform(random, -kPi, kPi), 0.0);
        };
        const dvec3 pole(0.0, side, 0.0);
        rays.push_back(aim((1.0 + uniform(random, 1e-3, 0.1)) * pole + beside(), 0.99 * pole + beside()));
    }
    expectContractButNormals(probe(sphereWorld(test::fractalMap(512, 8192), 5.0), rays));
}

// There columns' edges meet.
TEST_F(Axes, OntoAPoleOfGridlineRegistration) {
    expectContractButNormals(probe(gridlineWorld(test::randomMap(512, 257), 15.0), poleRays(1.0)));
}

// Coarse maps have the greatest caps.
TEST_F(Axes, OntoAPoleOfACoarseMap) {
    expectContractButNormals(probe(sphereWorld(test::randomMap(16, 8), 30.0), poleRays(1.0)));
}

// From all around onto the caps, where the columns run together.
TEST_F(Axes, AslantOntoTheCaps) {
    Random random(5);
    Queries rays;
    for (int k = 0; k < kRays; ++k) {
        double side = k % 2 ? 1.0 : -1.0, latitude = side * (0.5 * kPi - std::abs(logarithmic(random, 1e-7, 0.05)));
        dvec3 at = uniform(random, 0.85, 1.0) * direction(uniform(random, -kPi, kPi), latitude);
        rays.push_back(aim(at + 2.0 * glm::normalize(randomUnit(random) + dvec3(0.0, 1.2 * side, 0.0)), at));
    }
    expectContract(probe(sphereWorld(steepMap(), 15.0), rays));
}

// The plane x = 0 holds the seam (z < 0); atan2 tells its sides apart by the sign of the zero alone.
Queries seamRays(double beside) {
    Random random(6);
    Queries rays;
    auto zero = [&] { return random() % 2 ? beside : -beside; };
    for (int k = 0; k < kRays; ++k) {
        double latitude = uniform(random, -1.5, 1.5), reach = uniform(random, 0.0, 1.0);
        dvec3 from = 3.0 * direction(kPi, latitude), at = reach * direction(kPi, uniform(random, -1.5, 1.5));
        rays.push_back({.origin = {zero(), from.y, from.z}, .direction = {zero(), at.y - from.y, at.z - from.z}});
    }
    return rays;
}

TEST_F(Axes, InTheSeamPlaneWithBothSignsOfZero) {
    expectContract(probe(sphereWorld(steepMap(), 15.0), seamRays(0.0)));
}

// There the seam is an edge between columns.
TEST_F(Axes, InTheSeamPlaneOfGridlineRegistration) {
    expectContractButNormals(probe(gridlineWorld(test::randomMap(512, 257), 15.0), seamRays(0.0)));
}

TEST_F(Axes, OneUlpBesideTheSeamPlane) {
    expectContract(probe(sphereWorld(steepMap(), 15.0), seamRays(kFloatUlp)));
    expectContractButNormals(probe(gridlineWorld(test::randomMap(512, 257), 15.0), seamRays(0x1p-1074)));
}

// Aimed at the seam's neighbourhood from both sides: a column on the wrong side of the wrap shows.
TEST_F(Axes, AcrossTheSeam) {
    Random random(7);
    Queries rays;
    for (int k = 0; k < kRays; ++k) {
        double longitude = kPi + logarithmic(random, 1e-6, 0.05), latitude = uniform(random, -1.4, 1.4);
        dvec3 at = uniform(random, 0.87, 1.0) * direction(longitude, latitude);
        rays.push_back(aim(at + 2.0 * glm::normalize(randomUnit(random) + 1.2 * at), at));
    }
    expectContract(probe(sphereWorld(steepMap(), 15.0), rays));
    expectContract(probe(gridlineWorld(test::randomMap(333, 177), 15.0), rays));
}

// Planes through the axis: at columns' edges, their middles and anywhere.
TEST_F(Axes, InMeridianPlanes) {
    Random random(8);
    World world = sphereWorld(steepMap(), 15.0);
    Queries rays;
    for (int k = 0; k < kRays; ++k) {
        double longitude = nodeLongitude(*world.maps.maps[0], int(random() % 512));
        if (k % 3 == 1) longitude += kPi / 512;
        if (k % 3 == 2) longitude = uniform(random, -kPi, kPi);
        dvec3 from = 3.0 * direction(longitude, uniform(random, -1.6, 1.6));
        rays.push_back(aim(from, uniform(random, -1.0, 1.0) * direction(longitude, uniform(random, -1.5, 1.5))));
    }
    // A third of them run along columns' edges.
    expectContractButNormals(probe(world, rays));
}

Queries equatorRays() {
    Random random(9);
    Queries rays;
    auto zero = [&] { return random() % 2 ? 0.0 : -0.0; };
    for (int k = 0; k < kRays; ++k) {
        double longitude = uniform(random, -kPi, kPi);
        dvec3 from = 3.0 * direction(longitude, 0.0), at = uniform(random, -0.99, 0.99) * east(longitude);
        rays.push_back({.origin = {from.x, zero(), from.z}, .direction = {at.x - from.x, zero(), at.z - from.z}});
    }
    return rays;
}

TEST_F(Axes, InTheEquatorialPlane) {
    expectContract(probe(sphereWorld(steepMap(), 15.0), equatorRays()));
}

// Its equator is an edge between rows.
TEST_F(Axes, InTheEquatorialPlaneOfGridlineRegistration) {
    expectContract(probe(gridlineWorld(test::randomMap(512, 257), 15.0), equatorRays()));
}

}  // namespace
}  // namespace dsphere::conformance
