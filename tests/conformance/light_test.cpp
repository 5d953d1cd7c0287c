// Light on the device against the reference: direct light of every pixel, for every material under every light; and the
// means of traced paths.

#include "reference/pathtracer.h"
#include "reference/surface.h"
#include "tests/conformance/fixture.h"
#include "tests/support/testcolours.h"
#include "tests/support/testmaps.h"

#include <glm/gtc/matrix_transform.hpp>

#include <array>

namespace dsphere::conformance {
namespace {

const Material kMatte = Matte{ConstantColour{dvec3(0.7, 0.4, 0.2)}},
               kRoughMatte = Matte{ConstantColour{dvec3(0.7)}, 30.0}, kConductor = Conductor{.alpha = 0.25},
               kSmoothConductor = Conductor{.alpha = 0.03}, kRoughConductor = Conductor{dvec3(0.0), dvec3(1.0), 0.9},
               kPlastic = Plastic{ConstantColour{dvec3(0.3, 0.5, 0.1)}, dvec3(0.4), 0.1},
               kMirror = Mirror{dvec3(0.9, 0.8, 0.7)};

/// One a shape.
using Materials = std::array<Material, 4>;

/// Each has all kinds of material, and its matte one is rough, so that one shader serves them all.
const Materials kEvery[] = {{kRoughMatte, kConductor, kPlastic, kMirror},
                            {kSmoothConductor, kMirror, kRoughMatte, kPlastic},
                            {kPlastic, kRoughConductor, kMirror, kRoughMatte}};

Materials all(const Material& material) {
    return {material, material, material, material};
}

/// A planet, a ball, a disk and a ground of triangles.
World objects(const Materials& materials) {
    DisplacedSphere sphere;
    sphere.max_displacement = 15.0;
    World world = sphereWorld(test::fractalMap(128, 64), sphere);
    world.addPlain(Sphere{0.5}, translation({1.6, -0.3, 0.7}));
    world.addPlain(Disk{0.1, 0.8, 0.2}, translation({-1.5, 0.2, 0.3}) * glm::rotate(dmat4(1.0), 0.7, dvec3(1, 0.5, 0)));
    world.addPlain(
        TriangleMesh{{{-4, -1.3, -4}, {4, -1.3, -4}, {4, -1.3, 4}, {-4, -1.3, 4}}, {{0, 1, 2}, {0, 2, 3}}, {}},
        dmat4(1.0));
    for (std::size_t i = 0; i < materials.size(); ++i) world.scene.shapes[i].material = materials[i];
    world.lookAt({1.2, 1.4, 4.2}, {0.1, -0.2, 0.0}, dvec3(0.0, 1.0, 0.0), 50.0);
    world.scene.sampler.seed = 3;  // says nothing to the planes
    return world;
}

void addEmitter(World& world, const Geometry& geometry, const dmat4& placed, const dvec3& radiance, bool two_sided) {
    world.addPlain(geometry, placed);
    world.scene.lights.emplace_back(AreaLight{int(world.scene.shapes.size()) - 1, radiance, two_sided});
}

void addSky(World& world) {
    InfiniteLight sky;
    sky.radiance = dvec3(0.4, 0.5, 0.7);
    world.scene.lights.emplace_back(sky);
}

/// Bright and dark by places, one texel of it a sun.
void addSkyImage(World& world) {
    std::vector<float> light;
    for (int j = 0; j < 16; ++j)
        for (int i = 0; i < 32; ++i) {
            const bool sun = i == 9 && j == 4;
            for (float share : {0.9f, 1.0f, 1.2f})
                light.push_back(sun ? 15.0f : share * 0.05f * float((i * 7 + j * 5) % 11));
        }
    world.maps.images.push_back(std::make_unique<ColourMap>(test::lightOf(32, 16, light), "sky"));
    world.maps.light_image = int(world.maps.images.size()) - 1;
    world.maps.image_of_shape.resize(world.scene.shapes.size(), -1);
    InfiniteLight sky;
    sky.map_path = "sky";
    sky.world_from_light = dmat3(glm::rotate(dmat4(1.0), -kPi / 2 + 0.2, dvec3(1.0, 0.2, 0.0)));
    world.scene.lights.emplace_back(sky);
}

struct LightCase {
    const char* name;
    void (*add)(World&);
};

const std::vector<LightCase> kLights = {
    {"Sun",
     [](World& world) {
         world.addSun({1.0, 1.5, 1.2});
     }},
    {"Lamp",
     [](World& world) {
         world.addLamp({1.5, 2.0, 1.8}, 6.0);
     }},
    {"Ball",
     [](World& world) {
         addEmitter(world, Sphere{0.4}, translation({-0.4, 2.1, 1.6}), dvec3(8, 7, 6), false);
     }},
    {"Panel",
     [](World& world) {
         addEmitter(world, Disk{0.05, 0.9, 0.3},
                    translation({-1.2, 2.2, 0.9}) * glm::rotate(dmat4(1.0), 1.9, dvec3(1.0, 0.4, 0.0)), dvec3(9, 8, 6),
                    true);
     }},
    {"Sky", addSky},
    {"SkyImage", addSkyImage},
};

using Lighting = Conformance;

TEST_F(Lighting, OfEveryMaterialUnderEveryLight) {
    for (const LightCase& light : kLights)
        for (const Materials& materials : kEvery) {
            SCOPED_TRACE(std::string(light.name) + " on set " + std::to_string(&materials - kEvery));
            World world = objects(materials);
            world.scene.film.width = 100;
            world.scene.film.height = 75;
            light.add(world);
            const verify::Report report = smallPicture(world).report;
            expectContract(report);
            EXPECT_GE(report.colours, 4000u);
        }
}

// From 2e-3 and 2e-4 R above the ground, towards the sun's reflection in it: the hit's own rounding would turn the view
// by more than facets so smooth allow.
TEST_F(Lighting, OfSmoothFacetsNearBy) {
    for (const double height : {2e-3, 2e-4}) {
        SCOPED_TRACE(height);
        World world = sphereWorld(test::fractalMap(128, 64), 2.0);
        world.scene.shapes[0].material = Conductor{.alpha = 0.03};
        const dvec3 up = direction(0.4, 0.3), ahead = east(0.4);
        world.addSun(3.0 * ahead + 2.0 * up);
        const reference::Surface surface(*world.maps.maps[0], world.maps.reliefs[0]);
        const dvec3 eye = (surface.radius(up) + height * world.unit()) * up;
        world.lookAt(eye, eye + 3.0 * ahead - 2.0 * up, up, 90.0);
        const verify::Report report = picture(world).report;
        expectContract(report);
        EXPECT_GE(report.colours, 10000u);
    }
}

TEST_F(Lighting, OfManyLightsAtOnce) {
    World world = objects(kEvery[0]);
    for (const LightCase& light : kLights)
        if (light.add != addSky) light.add(world);  // a scene has one infinite light
    expectContract(picture(world).report);
}

TEST_F(Lighting, OnCheckerboardsOfEveryShape) {
    World world = objects(all(Matte{Checkerboard{dvec3(0.9, 0.1, 0.2), dvec3(0.1, 0.5, 0.9), 12.0, 7.0}}));
    world.addSun({1.0, 1.5, 1.2});
    expectContract(picture(world).report);
}

/// Bilinear, spline and ripples in one scene, each with another rough material: one shader that knows them all.
TEST_F(Lighting, OfAllSurfacesTogether) {
    World world;
    addEmitter(world, Sphere{0.8}, translation({-3.2, 5.2, 2.6}), dvec3(34, 31, 26), false);
    addSky(world);
    world.addPlain(
        TriangleMesh{{{-9, -1.2, -9}, {9, -1.2, -9}, {9, -1.2, 9}, {-9, -1.2, 9}}, {{0, 1, 2}, {0, 2, 3}}, {}},
        dmat4(1.0));
    DisplacedSphere sphere;
    sphere.max_displacement = 10.0;
    const int map = world.addMap(test::fractalMap(128, 64), sphere);
    world.addSphere(sphere, map, translation({-2.25, 0.0, 0.1}) * turned(25.0));
    world.scene.shapes.back().material = kRoughMatte;
    sphere.filter = Filter::BSpline;
    world.addSphere(sphere, map, translation({0.05, 0.0, -0.6}) * turned(40.0));
    world.scene.shapes.back().material = kPlastic;
    sphere.filter = Filter::Bilinear;
    sphere.ripples = Ripples{12, 10};
    world.addSphere(sphere, world.addMap(test::fractalMap(128, 64), sphere), translation({2.25, 0.0, 0.2}));
    world.scene.shapes.back().material = kSmoothConductor;
    world.lookAt({0.4, 2.3, 8.2}, {0.0, -0.15, 0.0}, dvec3(0.0, 1.0, 0.0), 30.0);
    const verify::Report report = picture(world).report;
    expectContract(report);
    EXPECT_GE(report.hits, 15000u);
}

/// Lights are counted from the first shape's middle, which is not where a mesh's own origin lies.
TEST_F(Lighting, WhereAMeshComesFirst) {
    World world;
    world.addPlain(TriangleMesh{{{-4, -1.3, -4}, {4, -1.3, -4}, {3, -1.2, 5}}, {{0, 1, 2}}, {}}, dmat4(1.0));
    world.addPlain(Sphere{0.5}, translation({0.6, -0.3, 0.7}));
    world.lookAt({1.2, 1.4, 4.2}, {0.1, -0.2, 0.0}, dvec3(0.0, 1.0, 0.0), 50.0);
    world.addLamp({0.5, 1.0, 0.8}, 3.0);
    addEmitter(world, Sphere{0.2}, translation({-0.9, 0.4, 0.6}), dvec3(8, 7, 6), false);
    expectContract(picture(world).report);
}

/// Means of the picture and of the reference's agree within both their errors, known to 1 %.
void expectMeans(const World& world, int device_samples, int reference_samples) {
    const PackedScene packed = packScene(world.scene, world.maps);
    const Image image = renderColour(*makeRenderer(packed, world.scene), device_samples, 5);
    const reference::PathTracer tracer(world.scene, world.maps);
    const reference::Estimate expected = tracer.mean(image.data, reference_samples);
    for (int c = 0; c < 3; ++c) {
        double sum = 0.0;
        for (float value : image.channels[std::size_t(c)].floats()) sum += value;
        const double mean = sum / double(image.pixelCount());
        const double half_width = 1.96 * expected.error[c] * 1.5;  // the device's samples are fewer, but better spread
        EXPECT_LE(half_width, 0.01 * expected.mean[c]) << "the reference is too coarse";
        std::printf("channel %d: half-width %.2g, off by %.2g of the mean\n", c, half_width / expected.mean[c],
                    std::abs(mean / expected.mean[c] - 1.0));
        EXPECT_NEAR(mean, expected.mean[c], 0.01 * expected.mean[c]) << "channel " << c;
    }
}

World small(World world, Integrator::Kind kind, int depth) {
    world.scene.film.width = 32;
    world.scene.film.height = 24;
    world.scene.integrator.kind = kind;
    world.scene.integrator.max_depth = depth;
    return world;
}

TEST_F(Lighting, OfPaths) {
    World world = objects({kMatte, kConductor, kPlastic, kRoughMatte});
    addSkyImage(world);
    addEmitter(world, Sphere{0.4}, translation({-0.4, 2.1, 1.6}), dvec3(8, 7, 6), false);
    expectMeans(small(std::move(world), Integrator::Kind::Path, 5), 128, 112);
}

/// A metal shows a smoother one, whose highlight of the lamp lies beside it: 0.25 radians off. Made rougher after the
/// first reflection, alpha 0.03 to 0.1, it sends several times as much light there. The lamp is below the first one's
/// horizon, so nothing else is seen.
TEST_F(Lighting, OfRegularizedPaths) {
    World world;
    const dmat4 upward = glm::rotate(dmat4(1.0), -0.5 * kPi, dvec3(1.0, 0.0, 0.0));  // normals from +z to +y
    world.addPlain(Disk{0.0, 0.7, 0.0}, upward);
    world.scene.shapes.back().material = Conductor{.alpha = 0.1};
    world.addPlain(Disk{0.0, 0.6, 0.0}, translation({2.4, 2.4, 0.0}) *
                                            glm::rotate(dmat4(1.0), -1.40 - 0.5 * kPi, dvec3(0.0, 0.0, 1.0)) * upward);
    world.scene.shapes.back().material = kSmoothConductor;
    addEmitter(world, Sphere{0.3}, translation({4.5, -0.5, 0.0}), dvec3(80, 70, 60), false);
    world.lookAt({-3.0, 3.0, 0.0}, {0.0, 0.0, 0.0}, dvec3(0.0, 1.0, 0.0), 6.0);
    world = small(std::move(world), Integrator::Kind::Path, 3);
    world.scene.integrator.regularize = true;
    expectMeans(world, 512, 1024);
}

/// Within a dark box, where what comes by two reflections and more is 4 % of the light and roulette ends most of these
/// paths.
TEST_F(Lighting, OfPathsInADarkBox) {
    TriangleMesh box;
    for (int corner = 0; corner < 8; ++corner)
        box.points.push_back(2.0 * dvec3(corner & 1, corner >> 1 & 1, corner >> 2) - 1.0);
    box.triangles = {{0, 1, 3}, {0, 3, 2}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                     {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 3, 7}, {1, 7, 5}};
    World world;
    world.addPlain(box, dmat4(1.0));
    world.scene.shapes.back().material = Matte{ConstantColour{dvec3(0.24, 0.2, 0.1)}};
    addEmitter(world, Sphere{0.5}, translation({0.0, 0.4, 0.0}), dvec3(4, 3, 2), false);
    world.lookAt({-0.9, -0.4, -0.8}, {0.9, -0.9, 0.9}, dvec3(0.0, 1.0, 0.0), 40.0);
    expectMeans(small(std::move(world), Integrator::Kind::Path, 5), 256, 256);
}

/// The same of one material at a time. Specks out of sight have the other kinds: one shader serves all.
TEST_F(Lighting, OfPathsOfOneMaterial) {
    for (const Material& material :
         {kMatte, kRoughMatte, kConductor, kSmoothConductor, kRoughConductor, kPlastic, kMirror}) {
        SCOPED_TRACE(material.index());
        World world = objects(all(material));
        for (const Material& other : {kRoughMatte, kConductor, kPlastic, kMirror}) {
            world.addPlain(Sphere{1e-3}, translation({1.2, 1.4, 9.0}));
            world.scene.shapes.back().material = other;
        }
        addSky(world);
        addEmitter(world, Sphere{0.4}, translation({-0.4, 2.1, 1.6}), dvec3(8, 7, 6), false);
        expectMeans(small(std::move(world), Integrator::Kind::Path, 4), 128, 128);
    }
}

TEST_F(Lighting, OfMirrorsUnderDirectLight) {
    World world = objects(all(kMirror));
    world.scene.shapes[0].material = Matte{};
    world.addSun({1.0, 1.5, 1.2});
    addSky(world);
    expectMeans(small(std::move(world), Integrator::Kind::DirectLighting, 4), 128, 128);
}

TEST_F(Lighting, WithEachPixelFilter) {
    using Kind = PixelFilter::Kind;
    for (Kind kind : {Kind::Gaussian, Kind::Triangle, Kind::Mitchell, Kind::Sinc}) {
        SCOPED_TRACE(nameOf(kind));
        World world = objects(all(kMatte));
        world.scene.pixel_filter.kind = kind;
        world.scene.pixel_filter.radius = dvec2(2.0, 1.5);
        world.addSun({1.0, 1.5, 1.2});
        world = small(std::move(world), Integrator::Kind::DirectLighting, 1);
        world.scene.film.width = 8;  // so that what lies beyond the picture's edges counts
        world.scene.film.height = 6;
        // Negative weights double the error of the reference's mean, so it takes more samples to know it to 1 %.
        const bool signed_weights = kind == Kind::Mitchell || kind == Kind::Sinc;
        expectMeans(world, 4096, signed_weights ? 40960 : 8192);
    }
}

/// In a sky of one radiance nothing stands out from it that loses no light.
TEST_F(Lighting, WhiteFurnace) {
    const Material lossless[] = {Matte{ConstantColour{dvec3(1.0)}}, Mirror{dvec3(1.0)},
                                 Conductor{dvec3(0.0), dvec3(1.0), 0.5}, Conductor{dvec3(0.0), dvec3(1.0), 0.05}};
    World world;  // far apart, so that they do not see each other
    for (std::size_t i = 0; i < std::size(lossless); ++i) {
        world.addPlain(Sphere{1.0}, translation({200.0 * double(i), 0.0, 0.0}));
        world.scene.shapes.back().material = lossless[i];
    }
    world.scene.lights.emplace_back(InfiniteLight{});
    world = small(std::move(world), Integrator::Kind::Path, 3);
    for (std::size_t i = 0; i < std::size(lossless); ++i) {
        SCOPED_TRACE("material " + std::to_string(i));
        const double x = 200.0 * double(i);
        world.lookAt({x, 0.0, 3.0}, dvec3(x, 0.0, 0.0), dvec3(0.0, 1.0, 0.0), 36.0);
        const PackedScene packed = packScene(world.scene, world.maps);
        const Image image = renderColour(*makeRenderer(packed, world.scene), 256, 5);
        double sum = 0.0;
        for (float value : image.channels[0].floats()) sum += value;
        EXPECT_NEAR(sum / double(image.pixelCount()), 1.0, 0.002);
    }
}

TEST_F(Lighting, DependsOnSamplesAlone) {
    World world = small(objects(all(kPlastic)), Integrator::Kind::Path, 4);
    addSky(world);
    const PackedScene packed = packScene(world.scene, world.maps);
    const auto renderer = makeRenderer(packed, world.scene);
    const Image first = renderColour(*renderer, 4, 9), again = renderColour(*renderer, 4, 9);
    const Image other = renderColour(*renderer, 4, 10);
    EXPECT_EQ(first.channels[0].floats(), again.channels[0].floats());
    EXPECT_NE(first.channels[0].floats(), other.channels[0].floats());
}

}  // namespace
}  // namespace dsphere::conformance
