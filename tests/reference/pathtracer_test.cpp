// The path tracer against closed forms. Bounds are 5 standard errors, which fails once in 10^6 for other numbers; the
// seeds are fixed.

#include "reference/pathtracer.h"

#include "tests/reference/maps.h"
#include "tests/support/testcolours.h"

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>

namespace dsphere::reference::test {
namespace {

constexpr Box kFilm{0, 0, 8, 8};

/// A unit sphere that fills the film of an orthographic camera looking along +z.
Scene sphereScene(const Material& material, int max_depth) {
    Scene scene;
    scene.camera.projection = Projection::Orthographic;
    scene.camera.camera_from_world = glm::translate(dmat4(1.0), dvec3(0.0, 0.0, 5.0));
    scene.camera.screen_window = {{-0.6, 0.6, -0.6, 0.6}};
    scene.film.width = scene.film.height = 8;
    scene.integrator = {.kind = Integrator::Kind::Path, .max_depth = max_depth};
    Shape shape;
    shape.geometry = Sphere{1.0};
    shape.material = material;
    scene.shapes.push_back(shape);
    return scene;
}

void addSky(Scene& scene, double radiance) {
    InfiniteLight sky;
    sky.radiance = dvec3(radiance);
    scene.lights.emplace_back(sky);
}

SceneMaps noMaps(const Scene& scene) {
    SceneMaps maps;
    maps.map_of_shape.assign(scene.shapes.size(), -1);
    maps.reliefs.resize(scene.shapes.size());
    return maps;
}

Matte matte(double albedo) {
    Matte material;
    material.reflectance = ConstantColour{dvec3(albedo)};
    return material;
}

void expectMean(const Estimate& estimate, double value, double slack = 1e-6) {
    EXPECT_NEAR(estimate.mean.g, value, 5.0 * estimate.error.g + slack) << "error " << estimate.error.g;
    EXPECT_LT(estimate.error.g, 0.02 * value);
}

// A convex body under a sky of 1 sends back its albedo, by lights alone or by paths.
TEST(PathTracer, SkyOnAMatteSphere) {
    for (auto kind : {Integrator::Kind::DirectLighting, Integrator::Kind::Path}) {
        Scene scene = sphereScene(matte(0.6), 5);
        scene.integrator.kind = kind;
        addSky(scene, 2.0);
        const SceneMaps maps = noMaps(scene);
        expectMean(PathTracer(scene, maps).mean(kFilm, 50), 1.2);
    }
}

TEST(PathTracer, LosslessMetalVanishesInTheSky) {
    for (double alpha : {0.05, 0.5, 1.0}) {
        Conductor metal{.eta = dvec3(0.0), .k = dvec3(0.0), .alpha = alpha};
        Scene scene = sphereScene(metal, 5);
        addSky(scene, 1.0);
        const SceneMaps maps = noMaps(scene);
        expectMean(PathTracer(scene, maps).mean(kFilm, 100), 1.0);
    }
}

TEST(PathTracer, MirrorShowsTheSky) {
    for (auto kind : {Integrator::Kind::DirectLighting, Integrator::Kind::Path})
        for (int depth : {0, 1}) {
            Scene scene = sphereScene(Mirror{.reflectance = dvec3(0.7)}, depth);
            scene.integrator.kind = kind;
            addSky(scene, 1.0);
            const SceneMaps maps = noMaps(scene);
            EXPECT_NEAR(PathTracer(scene, maps).mean(kFilm, 1).mean.r, depth * 0.7, 1e-12);
        }
}

// White ground in a white sky stays white however often light bounces in its valleys.
TEST(PathTracer, DisplacedWhiteFurnace) {
    Scene scene = sphereScene(matte(1.0), 100);
    scene.shapes[0].geometry = DisplacedSphere{};
    addSky(scene, 1.0);
    SceneMaps maps;
    maps.maps.push_back(std::make_unique<Heightmap>(noiseMap(16, 8, Registration::Texel, 3)));
    maps.map_of_shape = {0};
    maps.reliefs = {makeRelief(0.8, 25.0)};
    expectMean(PathTracer(scene, maps).mean({2, 2, 6, 6}, 60), 1.0, 1e-3);
}

/// Two parallel squares, side 2e3 and 1 apart, facing each other; the camera is between them and looks down.
Scene slit(double albedo, int max_depth) {
    Scene scene = sphereScene(matte(albedo), max_depth);
    scene.camera.camera_from_world = dmat4(1.0);
    scene.shapes.clear();
    for (double z : {0.5, -0.5}) {
        Shape wall;
        wall.geometry = TriangleMesh{.points = {{-1e3, -1e3, z}, {1e3, -1e3, z}, {1e3, 1e3, z}, {-1e3, 1e3, z}},
                                     .triangles = {{0, 1, 2}, {0, 2, 3}},
                                     .uvs = {}};
        wall.material = matte(albedo);
        scene.shapes.push_back(wall);
    }
    return scene;
}

// Between a floor of albedo a and a ceiling that shines with L = 1 and reflects a as well, nothing escapes: the path's
// vertices lie on floor and ceiling by turns, and those on the ceiling, the odd ones, add a^n.
TEST(PathTracer, InterreflectionsAreASeries) {
    const double albedo = 0.5;
    for (int depth : {1, 2, 3, 4}) {
        Scene scene = slit(albedo, depth);
        scene.shapes[1].geometry = Disk{.height = -0.5, .radius = 1e3};
        scene.lights.emplace_back(AreaLight{.shape = 1, .radiance = dvec3(1.0), .two_sided = false});
        double expected = 0.0;
        for (int n = 1; n <= depth; n += 2) expected += std::pow(albedo, n);
        const SceneMaps maps = noMaps(scene);
        const Estimate estimate = PathTracer(scene, maps).mean({3, 3, 5, 5}, 4000);
        EXPECT_NEAR(estimate.mean.g, expected, 5.0 * estimate.error.g + 1e-4) << depth;
        EXPECT_LT(estimate.error.g, 0.02);
    }
}

// The floor under a spherical lamp straight above: a L sin^2(theta_max); light is met by both samples, or by one.
TEST(PathTracer, AreaLightByBothSamples) {
    for (auto kind : {Integrator::Kind::DirectLighting, Integrator::Kind::Path}) {
        Scene scene = slit(0.5, 1);
        scene.integrator.kind = kind;
        scene.camera.screen_window = {{-1e-4, 1e-4, -1e-4, 1e-4}};
        scene.shapes[1].geometry = Sphere{0.5};
        scene.shapes[1].world_from_object = glm::translate(dmat4(1.0), dvec3(0.0, 0.0, -1.0));
        scene.lights.emplace_back(AreaLight{.shape = 1, .radiance = dvec3(4.0), .two_sided = false});
        const SceneMaps maps = noMaps(scene);
        expectMean(PathTracer(scene, maps).mean(kFilm, 100), 0.5 * 4.0 / 9.0);
    }
}

// One bounce by both samples is what light samples alone bring, whatever reflects and shines: densities that did not
// fit together would show.
TEST(PathTracer, OneBounceIsDirectLight) {
    for (const Material& material :
         {Material(Conductor{.alpha = 0.4}), Material(Plastic{.alpha = 0.3}), Material(Matte{.sigma = 30.0})}) {
        Scene scene = sphereScene(material, 1);
        addSky(scene, 1.0);
        auto add = [&](const decltype(Shape::geometry)& geometry, const dmat4& place) {
            Shape shape;
            shape.geometry = geometry;
            shape.world_from_object = place;
            scene.lights.emplace_back(
                AreaLight{.shape = int(scene.shapes.size()), .radiance = dvec3(5.0), .two_sided = false});
            scene.shapes.push_back(shape);
        };
        add(Sphere{0.4}, glm::translate(dmat4(1.0), dvec3(1.0, 1.0, -1.2)));
        add(Disk{.radius = 0.6, .inner_radius = 0.1}, glm::translate(dmat4(1.0), dvec3(-1.0, 1.0, -1.5)));
        SceneMaps maps = noMaps(scene);
        maps.images.push_back(std::make_unique<ColourMap>(dsphere::test::randomLight(16, 8), "sky"));
        maps.light_image = 0;
        Estimate found[2];
        for (auto kind : {Integrator::Kind::DirectLighting, Integrator::Kind::Path}) {
            scene.integrator.kind = kind;
            found[int(kind)] = PathTracer(scene, maps).mean(kFilm, 1500, 1 + std::uint64_t(kind));
            EXPECT_LT(found[int(kind)].error.g, 0.01 * found[int(kind)].mean.g);
        }
        EXPECT_NEAR(found[0].mean.g, found[1].mean.g, 5.0 * std::hypot(found[0].error.g, found[1].error.g));
    }
}

TEST(PathTracer, CameraSeesEmittersAndSky) {
    Scene scene = sphereScene(matte(0.0), 0);
    scene.camera.screen_window = {{-4.0, 4.0, -4.0, 4.0}};
    scene.lights.emplace_back(AreaLight{.shape = 0, .radiance = dvec3(3.0), .two_sided = false});
    addSky(scene, 1.0);
    const SceneMaps maps = noMaps(scene);
    // The disk of area pi in a square of 64.
    expectMean(PathTracer(scene, maps).mean(kFilm, 2000), 1.0 + 2.0 * kPi / 64.0);
}

// The mean over the filter of a step from 1 to 0 within the pixel.
TEST(PathTracer, FilterWeighsPlaces) {
    Scene scene = sphereScene(matte(0.0), 0);
    scene.shapes[0].geometry = TriangleMesh{
        .points = {{0.3, -9, 0}, {9, -9, 0}, {9, 9, 0}, {0.3, 9, 0}}, .triangles = {{0, 1, 2}, {0, 2, 3}}, .uvs = {}};
    scene.camera.screen_window = {{-4.0, 4.0, -4.0, 4.0}};
    addSky(scene, 1.0);
    scene.pixel_filter = {.kind = PixelFilter::Kind::Gaussian, .radius = dvec2(2.0, 1.0), .falloff = 0.7};
    // Pixel 4's centre is at x = 0.5; the mesh covers what lies right of 0.3.
    auto kernel = [](double x) { return std::exp(-0.7 * x * x) - std::exp(-0.7 * 4.0); };
    double whole = 0.0, left = 0.0;
    for (int k = 0; k < 4000; ++k) {
        const double x = -2.0 + (k + 0.5) / 1000.0;
        whole += kernel(x);
        if (x < -0.2) left += kernel(x);
    }
    const SceneMaps maps = noMaps(scene);
    expectMean(PathTracer(scene, maps).mean({4, 4, 5, 5}, 40000), left / whole);
}

}  // namespace
}  // namespace dsphere::reference::test
