#include "tests/conformance/world.h"

#include "scene/transforms.h"

#include <cmath>
#include <cstdlib>
#include <string_view>

namespace dsphere::conformance {

namespace {

DisplacedSphere asTested(DisplacedSphere sphere) {
    if (testSurface() == TestSurface::BSpline) sphere.filter = Filter::BSpline;
    if (testSurface() == TestSurface::Ripples) sphere.ripples = Ripples{};
    return sphere;
}

}  // namespace

TestSurface testSurface() {
    const char* name = std::getenv("DSPHERE_TEST_SURFACE");
    if (!name) return TestSurface::AsGiven;
    return std::string_view(name) == "bspline" ? TestSurface::BSpline : TestSurface::Ripples;
}

World::World() {
    scene.name = "conformance";
    scene.film.width = 200;
    scene.film.height = 150;
}

int World::addMap(RawMap raw, const DisplacedSphere& sphere) {
    maps.maps.push_back(std::make_unique<Heightmap>(makeHeightmap(std::move(raw), asTested(sphere))));
    return int(maps.maps.size()) - 1;
}

void World::addSphere(const DisplacedSphere& sphere, int map, const dmat4& world_from_object) {
    scene.shapes.push_back({asTested(sphere), world_from_object, Matte{HeightRamp{.ramp = "viridis"}}, {scene.name}});
    maps.map_of_shape.push_back(map);
    maps.reliefs.push_back(makeRelief(asTested(sphere), *maps.maps[std::size_t(map)], {scene.name}));
}

void World::addPlain(const Geometry& geometry, const dmat4& world_from_object) {
    scene.shapes.push_back({geometry, world_from_object, Matte{ConstantColour{dvec3(0.7, 0.5, 0.2)}}, {scene.name}});
    maps.map_of_shape.push_back(-1);
    maps.reliefs.push_back({});
}

void World::addSun(const dvec3& towards) {
    scene.lights.emplace_back(DistantLight{glm::normalize(towards), dvec3(3.0, 2.8, 2.5)});
}

void World::addLamp(const dvec3& position, double intensity) {
    scene.lights.emplace_back(PointLight{position, dvec3(intensity)});
}

void World::lookAt(const dvec3& eye, const dvec3& target, const dvec3& up, double fov) {
    scene.camera.camera_from_world = lookAtMatrix(eye, target, up).value();
    scene.camera.fov_degrees = fov;
}

World sphereWorld(RawMap raw, const DisplacedSphere& sphere) {
    World world;
    world.addSphere(sphere, world.addMap(std::move(raw), sphere));
    return world;
}

World sphereWorld(RawMap raw, double percent) {
    DisplacedSphere sphere;
    sphere.max_displacement = percent;
    return sphereWorld(std::move(raw), sphere);
}

// The sphere's silhouette is at the angle asin(1 / distance).
double pictureFov(double distance, double share) {
    return glm::degrees(2.0 * std::atan(std::tan(std::asin(1.0 / distance)) / share));
}

dmat4 translation(const dvec3& offset) {
    dmat4 m(1.0);
    m[3] = dvec4(offset, 1.0);
    return m;
}

dmat4 scaling(const dvec3& factors) {
    dmat4 m(1.0);
    for (int k = 0; k < 3; ++k) m[k][k] = factors[k];
    return m;
}

dmat4 turned(double degrees) {
    return rotationMatrix(degrees, dvec3(0.0, 1.0, 0.0));
}

dvec3 direction(double longitude, double latitude) {
    return {std::cos(latitude) * std::sin(longitude), std::sin(latitude), std::cos(latitude) * std::cos(longitude)};
}

dvec3 east(double longitude) {
    return {std::cos(longitude), 0.0, -std::sin(longitude)};
}

dvec3 north(double longitude, double latitude) {
    return {-std::sin(latitude) * std::sin(longitude), std::cos(latitude), -std::sin(latitude) * std::cos(longitude)};
}

double nodeLongitude(const Heightmap& map, int i) {
    double column = map.registration == Registration::Texel ? i + 0.5 : i;
    return 2.0 * kPi * (column / map.width) + glm::radians(map.longitude_origin);
}

double nodeLatitude(const Heightmap& map, int j) {
    bool texel = map.registration == Registration::Texel;
    return kPi * (0.5 - (texel ? (j + 0.5) / map.height : j / (map.height - 1.0)));
}

}  // namespace dsphere::conformance
