// Whole pictures with their shadows: where the camera stands, how objects are placed, several of them.

#include "reference/surface.h"
#include "scene/transforms.h"
#include "tests/conformance/fixture.h"
#include "tests/support/testmaps.h"

#include <cmath>

namespace dsphere::conformance {
namespace {

const dvec3 kUp(0.0, 1.0, 0.0);
const dvec3 kSun(1.0, 0.7, 0.4);

DisplacedSphere rough(double percent = 15.0) {
    DisplacedSphere sphere;
    sphere.max_displacement = percent;
    return sphere;
}

RawMap ground() {
    return test::fractalMap(512, 256);
}

World sunny(double percent = 15.0) {
    World world = sphereWorld(ground(), rough(percent));
    world.addSun(kSun);
    return world;
}

using Distance = Conformance;

// At 1e-3 R above the ground, along the horizon, over an ordinary place.
TEST_F(Distance, ThousandthAboveGround) {
    World world = sunny();
    reference::Surface surface(*world.maps.maps[0], world.maps.reliefs[0]);
    for (double longitude : {0.4, 2.9}) {
        dvec3 w = direction(longitude, 0.3), eye = (surface.radius(w) + 1e-3 * world.unit()) * w;
        world.lookAt(eye, eye + east(longitude) - 0.15 * w, w, 70.0);
        verify::Report report = picture(world).report;
        EXPECT_GT(report.hits, 2000u);
        expectContract(report);
    }
}

// In the deepest valley, under the level of the highest peak.
TEST_F(Distance, InsideTheShellAboveGround) {
    World world = sunny();
    const Heightmap& map = *world.maps.maps[0];
    const Relief& relief = world.maps.reliefs[0];
    auto lowest = std::size_t(std::min_element(map.samples.begin(), map.samples.end()) - map.samples.begin());
    double longitude = nodeLongitude(map, int(lowest % 512)), latitude = nodeLatitude(map, int(lowest / 512));
    dvec3 w = direction(longitude, latitude);
    dvec3 eye = glm::mix(relief.least_radius, relief.greatest_radius, 0.4) * w;
    world.lookAt(eye, eye + north(longitude, latitude) - 0.3 * w, w, 80.0);
    verify::Report report = picture(world).report;
    EXPECT_GT(report.hits, 7000u);
    EXPECT_EQ(report.distances.size(), report.hits) << "a hit is flagged as inside";
    expectContract(report);
}

// Every ray hits at once, flagged.
TEST_F(Distance, InsideTheSolid) {
    World world = sunny();
    for (double depth : {0.0, 0.5, 0.97}) {
        world.lookAt(depth * direction(0.3, 0.2), {2.0, 0.5, 0.1}, kUp, 60.0);
        verify::Report report = picture(world).report;
        EXPECT_EQ(report.hits, report.rays);
        EXPECT_TRUE(report.distances.empty()) << "a hit is not flagged as inside";
        expectContract(report);
    }
}

struct FarCase {
    std::string name;
    double distance;  ///< in units of R

    friend void PrintTo(const FarCase& c, std::ostream* out) { *out << c.name; }
};

class FarAway : public Conformance, public testing::WithParamInterface<FarCase> {};

TEST_P(FarAway, HalfThePicture) {
    World world = sunny();
    double distance = GetParam().distance;
    world.lookAt(world.unit() * distance * direction(-0.8, 0.25), dvec3(0.0), kUp, pictureFov(distance, 0.5));
    verify::Report report = picture(world).report;
    EXPECT_GT(report.hits, 3000u);
    expectContract(report);
}

// Four spheres of some 20 pixels' radius, one in each corner: their rays are far from the picture's axis.
TEST_P(FarAway, InAllFourCorners) {
    World world;
    int map = world.addMap(ground(), rough());
    world.addSun({1.0, 0.5, 3.0});
    double distance = GetParam().distance, fov = pictureFov(distance, 0.27);
    double edge = distance * std::tan(glm::radians(0.5 * fov));  // half the picture's height at that distance
    for (double x : {-1.0, 1.0})
        for (double y : {-0.68, 0.68}) world.addSphere(rough(), map, translation(edge * dvec3(x, y, 0.0)));
    world.lookAt({0.0, 0.0, distance}, dvec3(0.0), kUp, fov);
    verify::Report report = picture(world).report;
    EXPECT_GT(report.hits, 3000u);
    expectContract(report);
}

INSTANTIATE_TEST_SUITE_P(At, FarAway,
                         testing::Values(FarCase{"3R", 3.0}, FarCase{"1e2R", 1e2}, FarCase{"1e4R", 1e4},
                                         FarCase{"1e6R", 1e6}),
                         caseName<FarCase>);

// The small sphere at the edge of a wide picture, where a pixel is many of its radii away from the axis.
TEST_F(Distance, SmallAtTheEdgeOfAWidePicture) {
    World world;
    int map = world.addMap(ground(), rough());
    world.addSun({1.0, 0.5, 3.0});
    for (double x : {-1.25, 1.25})
        for (double y : {-0.93, 0.93}) world.addSphere(rough(), map, translation(25.0 * dvec3(x, y, 0.0)));
    world.lookAt({0.0, 0.0, 25.0}, dvec3(0.0), kUp, 90.0);
    world.scene.film.width = 1000;
    world.scene.film.height = 750;
    verify::Report report = picture(world).report;
    EXPECT_GT(report.hits, 2000u);
    expectContract(report);
}

struct PlacedCase {
    std::string name;
    dmat4 world_from_object;
    double radius = 1.0;

    friend void PrintTo(const PlacedCase& c, std::ostream* out) { *out << c.name; }
};

class Placed : public Conformance, public testing::WithParamInterface<PlacedCase> {};

// The camera moves with the object, so that pictures differ by the transform alone.
TEST_P(Placed, Picture) {
    const auto& [name, m, radius] = GetParam();
    World world;
    DisplacedSphere sphere = rough();
    sphere.radius = radius;
    world.addSphere(sphere, world.addMap(ground(), sphere), m);
    world.addSun(kSun);
    double size = world.unit();
    dvec3 centre = transformPoint(m, dvec3(0.0)), eye = transformPoint(m, size * dvec3(1.2, 0.9, 2.6));
    world.lookAt(eye, centre, kUp, 45.0);
    world.addLamp(eye + 0.4 * glm::length(eye - centre) * kUp, 3.0 * glm::dot(eye - centre, eye - centre));
    verify::Report report = picture(world).report;
    EXPECT_GT(report.hits, 1000u);
    expectContract(report);
}

const dmat4 kTilted = rotationMatrix(37.0, glm::normalize(dvec3(1.0, -2.0, 0.5)));

INSTANTIATE_TEST_SUITE_P(
    By, Placed,
    testing::Values(PlacedCase{"Nothing", dmat4(1.0)}, PlacedCase{"RadiusMillionth", dmat4(1.0), 1e-6},
                    PlacedCase{"RadiusBillion", dmat4(1.0), 1e9},
                    PlacedCase{"Translation", translation({3.0, -1.0, 7.0})},
                    PlacedCase{"FarTranslation", translation({700.0, -300.0, 650.0})}, PlacedCase{"Rotation", kTilted},
                    PlacedCase{"UniformScale", scaling(dvec3(250.0))},
                    PlacedCase{"NonUniformScale", kTilted* scaling({1.0, 0.4, 2.0}) * kTilted},
                    PlacedCase{"Mirror", scaling({-1.0, 1.0, 1.0})},
                    PlacedCase{"AllAtOnce", translation({-40.0, 9.0, 5.0}) * kTilted* scaling({-2.0, 3.0, 1.5})}),
    caseName<PlacedCase>);

using Several = Conformance;

// Three displaced spheres that share a map and run through each other.
TEST_F(Several, IntersectingSpheres) {
    World world;
    int map = world.addMap(ground(), rough());
    world.addSphere(rough(), map, translation({-0.6, 0.0, 0.0}));
    world.addSphere(rough(40.0), map, translation({0.6, 0.2, 0.1}) * kTilted);
    world.addSphere(rough(-20.0), map, translation({0.0, 0.9, -0.3}) * scaling({1.0, 0.7, 1.2}));
    world.addSun(kSun);
    world.addLamp({-1.5, 2.0, 3.0}, 20.0);
    world.lookAt({0.4, 1.0, 5.5}, {0.0, 0.3, 0.0}, kUp, 40.0);
    verify::Report report = picture(world).report;
    EXPECT_GT(report.shadow_rays, 10000u);
    expectContract(report);
}

// Their heights share an image, in which narrow ones would fit side by side.
TEST_F(Several, WithMapsOfSeveralWidths) {
    World world;
    int k = 0;
    for (const auto& [width, height] : {std::pair(1024, 16), std::pair(300, 16), std::pair(512, 64)}) {
        const double angle = 2.0 / 3.0 * kPi * k++;
        world.addSphere(rough(), world.addMap(test::fractalMap(width, height), rough()),
                        translation({1.3 * std::cos(angle), 1.3 * std::sin(angle), 0.0}) * kTilted);
    }
    world.addSun(kSun);
    world.lookAt({0.3, 0.5, 7.0}, dvec3(0.0), kUp, 45.0);
    verify::Report report = picture(world).report;
    EXPECT_GT(report.hits, 7000u);
    expectContract(report);
}

// From so far that t alone cannot tell which of them comes first.
TEST_F(Several, IntersectingSpheresFarAway) {
    for (double distance : {1e2, 1e4, 1e6}) {
        World world;
        int map = world.addMap(ground(), rough());
        world.addSphere(rough(), map, translation({-0.4, 0.0, 0.0}));
        world.addSphere(rough(40.0), map, translation({0.3, 0.2, 0.1}) * kTilted);
        world.addPlain(Sphere{1.0}, translation({0.0, -0.5, 0.2}));
        world.addPlain(Disk{0.0, 1.5, 0.0}, kTilted);
        world.addSun(kSun);
        world.lookAt(distance * direction(0.2, 0.3), dvec3(0.0), kUp, pictureFov(distance, 0.5));
        verify::Report report = picture(world).report;
        EXPECT_GT(report.hits, 3000u);
        expectContract(report);
    }
}

// Shadows fall from the displaced sphere onto the plain one and the ground, and from them onto it.
TEST_F(Several, SphereAndDiskAsGround) {
    World world;
    world.addSphere(rough(), world.addMap(ground(), rough()), kTilted);
    world.addPlain(Disk{0.0, 6.0, 0.3}, translation({0.0, -1.2, 0.0}) * rotationMatrix(-90.0, dvec3(1.0, 0.0, 0.0)));
    world.addPlain(Sphere{0.5}, translation({1.4, -0.5, 0.8}));
    world.addSun(kSun);
    world.addSun({-1.0, 0.3, 0.6});
    world.addLamp({-2.0, 1.5, 2.0}, 10.0);
    world.lookAt({0.5, 1.2, 6.0}, {0.2, -0.2, 0.0}, kUp, 45.0);
    verify::Report report = picture(world).report;
    EXPECT_GT(report.shadow_rays, 40000u);
    expectContract(report);
}

}  // namespace
}  // namespace dsphere::conformance
