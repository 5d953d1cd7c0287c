// The comparison of light with answers made up here: those of a device that rounds its inputs to floats are right, the
// same a little wrong are found out.

#include "verify/compare.h"

#include "reference/camera.h"
#include "tests/support/testcolours.h"

#include <gtest/gtest.h>
#include <glm/gtc/matrix_transform.hpp>

#include <cmath>
#include <functional>

namespace dsphere::verify::test {
namespace {

dvec3 rounded(const dvec3& v) {
    return dvec3(glm::vec3(v));
}

/// A unit sphere over a floor of two triangles, seen from aside.
Scene sceneOf(const Material& material) {
    Scene scene;
    scene.film.width = 48;
    scene.film.height = 36;
    scene.sampler.seed = 3;
    scene.camera.fov_degrees = 40.0;
    scene.camera.camera_from_world =
        glm::rotate(glm::translate(dmat4(1.0), dvec3(0.0, 0.2, 6.0)), -0.4, dvec3(1.0, 0.0, 0.0));
    Shape ball, floor;
    ball.geometry = Sphere{1.0};
    ball.material = material;
    floor.geometry = TriangleMesh{
        .points = {{-3, -1, -3}, {3, -1, -3}, {3, -1, 3}, {-3, -1, 3}}, .triangles = {{0, 1, 2}, {0, 2, 3}}, .uvs = {}};
    floor.material = Matte{
        .reflectance = Checkerboard{.even = dvec3(0.9, 0.5, 0.5), .odd = dvec3(0.1), .u_scale = 6.0, .v_scale = 6.0}};
    scene.shapes = {ball, floor};
    return scene;
}

void addEmitter(Scene& scene, const decltype(Shape::geometry)& geometry, const dmat4& place) {
    Shape shape;
    shape.geometry = geometry;
    shape.world_from_object = place;
    scene.lights.emplace_back(
        AreaLight{.shape = int(scene.shapes.size()), .radiance = {9.0, 8.0, 7.0}, .two_sided = false});
    scene.shapes.push_back(shape);
}

void addBall(Scene& scene) {
    addEmitter(scene, Sphere{0.5}, glm::translate(dmat4(1.0), dvec3(-1.5, 2.0, -0.5)));
}
void addDisk(Scene& scene) {
    addEmitter(scene, Disk{.height = 0.0, .radius = 0.7, .inner_radius = 0.2},
               glm::rotate(glm::translate(dmat4(1.0), dvec3(1.5, 1.8, -1.0)), 0.5 * kPi, dvec3(1.0, 0.3, 0.0)));
}
void addSky(Scene& scene) {
    InfiniteLight sky;
    sky.world_from_light = dmat3(glm::rotate(dmat4(1.0), -0.5 * kPi, dvec3(1.0, 0.0, 0.0)));
    scene.lights.emplace_back(sky);
}
void addLamps(Scene& scene) {
    scene.lights.emplace_back(PointLight{.position = {1.0, 2.0, -2.0}, .intensity = dvec3(20.0)});
    scene.lights.emplace_back(
        DistantLight{.direction = glm::normalize(dvec3(-1.0, 2.0, -1.0)), .radiance = dvec3(2.0)});
}

SceneMaps mapsOf(const Scene& scene, bool sky_image) {
    SceneMaps maps;
    maps.map_of_shape.assign(scene.shapes.size(), -1);
    maps.reliefs.resize(scene.shapes.size());
    if (sky_image) {
        maps.images.push_back(std::make_unique<ColourMap>(dsphere::test::randomLight(64, 32), "sky"));
        maps.light_image = 0;
    }
    return maps;
}

/// Every pixel's answer by the reference at rounded inputs, then spoilt.
Report verifyMadeUp(const Scene& scene, const SceneMaps& maps, const std::function<void(LightAnswer&)>& spoil) {
    const Comparison comparison(scene, maps);
    const reference::Tracer& tracer = comparison.tracer();
    Report report;
    for (int y = 0; y < scene.film.height; ++y)
        for (int x = 0; x < scene.film.width; ++x) {
            const reference::CameraRay camera = reference::cameraRay(scene.camera, scene.film, x + 0.5, y + 0.5);
            const WorldRay ray{camera.origin, camera.direction};
            const reference::WorldHit hit = tracer.firstHit(ray.origin, ray.direction);
            const auto index = std::uint64_t(y * scene.film.width + x);
            LightAnswer light;
            if (!hit.hit) {
                light.colour = rounded(tracer.lights().environment(rounded(ray.direction)));
                spoil(light);
                comparison.checkMiss(report, index, ray, light.colour);
                continue;
            }
            reference::ShadingPoint point = tracer.shadingPoint(hit, ray.direction);
            point.object_position = rounded(point.object_position);
            point.position = rounded(point.position);
            point.normals = {rounded(point.normals.geometric), rounded(point.normals.smooth)};
            point.towards_viewer = glm::normalize(rounded(point.towards_viewer));
            light.source = {std::uint32_t(x), std::uint32_t(y), std::uint32_t(scene.sampler.seed), 0};
            light.start = rounded(tracer.beside(point));
            light.position =
                transformPoint(scene.shapes[std::size_t(hit.shape)].world_from_object, point.object_position);
            light.lit = tracer.litLights(point, light.source);
            light.colour = rounded(tracer.directLight(point, light.source, light.lit));
            spoil(light);
            const Answer answer{.hit = true,
                                .shape = hit.shape,
                                .t = hit.t(),
                                .object_position = point.object_position,
                                .normal = point.normals.geometric,
                                .smooth_normal = point.normals.smooth};
            comparison.checkLight(report, index, ray, answer, light);
        }
    return report;
}

void expectRight(const Scene& scene, bool sky_image, const std::string& what) {
    const Report report = verifyMadeUp(scene, mapsOf(scene, sky_image), [](LightAnswer&) {});
    EXPECT_EQ(report.wrong_colours, 0u) << what << ": " << (report.faults.empty() ? "" : report.faults[0].what);
    EXPECT_EQ(report.wrong_shadows, 0u) << what;
    EXPECT_LE(report.tangent_shadows, 2 + report.shadow_rays / 10000) << what;
    EXPECT_GT(report.colours, 900u);
}

const std::pair<const char*, Material> kMaterials[] = {
    {"Oren-Nayar", Matte{.sigma = 30.0}}, {"smooth metal", Conductor{.alpha = 0.001}},
    {"metal", Conductor{.alpha = 0.1}},   {"rough metal", Conductor{.alpha = 1.0}},
    {"plastic", Plastic{.alpha = 0.05}},  {"mirror", Mirror{}},
};

TEST(LightCheck, RoundedAnswersAreRight) {
    for (const auto& [name, material] : kMaterials) {
        Scene scene = sceneOf(material);
        addBall(scene);
        addDisk(scene);
        addLamps(scene);
        addSky(scene);
        expectRight(scene, false, name);
        expectRight(scene, true, std::string(name) + ", sky image");
    }
}

// Half a per cent is found out of nearly all that shine, whatever lights them; a smooth metal's glints alone, and
// texels that are hardly ever drawn, turn more on rounding.
TEST(LightCheck, WrongColoursAreFoundOut) {
    for (const auto& [name, material] : kMaterials) {
        const bool smooth = std::string(name) == "smooth metal";
        for (auto add : {addBall, addDisk, addLamps, addSky})
            for (bool image : {false, true}) {
                if (image && add != addSky) continue;
                Scene scene = sceneOf(material);
                add(scene);
                std::uint64_t bright = 0;
                const Report report = verifyMadeUp(scene, mapsOf(scene, image), [&](LightAnswer& light) {
                    if (light.colour.r > 0.0) ++bright;
                    light.colour *= 1.005;
                });
                EXPECT_GE(double(report.wrong_colours), (smooth ? 0.9 : 0.98) * double(bright)) << name << ' ' << image;
                EXPECT_GT(bright, 100u);
            }
    }
}

TEST(LightCheck, WrongShadowsAreFoundOut) {
    Scene scene = sceneOf(Matte{});
    addBall(scene);
    addSky(scene);
    addLamps(scene);
    // Of a float's P' some lie less above the floor than a ray is moved sideways: those of rays that leave it at less
    // than 4 degrees, one in 18 of the sky's here, pass for tangent. Those are counted, and too many.
    const auto expectFoundOut = [](const Report& report, double spoilt, double certain) {
        EXPECT_GE(double(report.wrong_shadows), certain * spoilt);
        EXPECT_GE(double(report.wrong_shadows + report.tangent_shadows), 0.99 * spoilt);
        EXPECT_FALSE(report.passed());
    };
    const Report sky = verifyMadeUp(scene, mapsOf(scene, true), [](LightAnswer& light) { light.lit ^= 2u; });
    expectFoundOut(sky, double(sky.shadow_rays) / 4.0, 0.94);
    const Report all = verifyMadeUp(scene, mapsOf(scene, true), [](LightAnswer& light) { light.lit = ~light.lit; });
    expectFoundOut(all, double(all.shadow_rays), 0.98);
}

// The samples of another index are as good for pictures and wrong for verify.
TEST(LightCheck, OtherSampleNumbersAreFoundOut) {
    Scene scene = sceneOf(Matte{});
    addBall(scene);
    std::uint64_t bright = 0;
    const Report report = verifyMadeUp(scene, mapsOf(scene, false), [&](LightAnswer& light) {
        if (light.lit != 0) ++bright;
        light.source.index = 1;
    });
    EXPECT_GT(double(report.wrong_colours), 0.9 * double(bright));
    EXPECT_GT(bright, 300u);
}

// Also where no smoother surface gives them: shading normals are then the surface's own.
TEST(LightCheck, WrongShadingNormalsAreFoundOut) {
    const Scene scene = sceneOf(Matte{});
    const SceneMaps maps = mapsOf(scene, false);
    const Comparison comparison(scene, maps);
    const WorldRay ray{{0.0, 0.0, 6.0}, {0.0, 0.0, -1.0}};
    const reference::WorldHit hit = comparison.tracer().firstHit(ray.origin, ray.direction);
    ASSERT_EQ(hit.shape, 0);
    Answer answer{.hit = true, .shape = 0, .t = hit.t(), .object_position = {0.0, 0.0, 1.0}, .normal = {0.0, 0.0, 1.0}};
    for (const dvec3& wrong : {dvec3(0.0), glm::normalize(dvec3(0.0, 0.01, 1.0))}) {
        Report report;
        answer.smooth_normal = answer.normal;
        comparison.checkHit(report, 0, ray, answer);
        EXPECT_TRUE(report.passed()) << report.table();
        answer.smooth_normal = wrong;
        comparison.checkHit(report, 1, ray, answer);
        EXPECT_FALSE(report.passed());
    }
}

TEST(LightCheck, NoNumberIsNoColour) {
    Scene scene = sceneOf(Matte{});
    addSky(scene);
    const Report report =
        verifyMadeUp(scene, mapsOf(scene, false), [](LightAnswer& light) { light.colour.b = std::nan(""); });
    EXPECT_EQ(report.wrong_colours, report.colours);
}

}  // namespace
}  // namespace dsphere::verify::test
