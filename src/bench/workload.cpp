#include "bench/workload.h"

#include "base/error.h"
#include "base/parallel.h"
#include "bench/views.h"
#include "image/generate.h"

#include <algorithm>
#include <cmath>

namespace dsphere::bench {

namespace {

constexpr std::uint32_t kMapSeed = 1;

Light sun() {
    return DistantLight{glm::normalize(kSun), dvec3(3.0)};
}

double spanPercent(const DisplacedSphere& sphere, const Relief& relief) {
    if (!sphere.height_scale) return sphere.max_displacement;
    return 100.0 * (relief.greatest_radius - relief.least_radius) / sphere.radius;
}

bool isPlanet(const Shape& shape) {
    return std::holds_alternative<DisplacedSphere>(shape.geometry);
}

}  // namespace

RawMap suiteMap(int width) {
    int height = width / 2;
    RawMap map;
    map.width = width;
    map.height = height;
    map.samples.resize(std::size_t(width) * std::size_t(height));
    map.full_scale = 65535.0;
    map.type = "fractal";
    const MapGenerator generator(MapKind::Fractal, width, height, kMapSeed);
    parallelFor(std::size_t(height), [&](std::size_t j) {
        std::vector<std::uint16_t> row(std::size_t(width), 0);
        generator.fillRow(int(j), row);
        std::ranges::copy(row, map.samples.begin() + std::ptrdiff_t(j * row.size()));
    });
    return map;
}

Workload suiteWorkload(RawMap map, double percent) {
    Workload workload;
    workload.map = fmt::format("fractal {}x{}", map.width, map.height);
    workload.width = map.width;
    workload.height = map.height;
    workload.percent = percent;
    DisplacedSphere sphere;
    sphere.max_displacement = percent;
    workload.scene.name = workload.map;
    workload.scene.shapes.push_back({sphere, dmat4(1.0), {}, {workload.map}});
    workload.scene.lights = {sun()};
    workload.maps.maps.push_back(std::make_unique<Heightmap>(makeHeightmap(std::move(map), sphere)));
    workload.maps.map_of_shape = {0};
    workload.maps.reliefs = {makeRelief(sphere, *workload.maps.maps[0], {workload.map})};
    return workload;
}

void requirePlanet(const Scene& scene) {
    if (std::ranges::none_of(scene.shapes, isPlanet)) throwInvalid("{}: bench needs a displacedsphere", scene.name);
}

Workload sceneWorkload(Scene scene) {
    requirePlanet(scene);
    scene.shapes = {Shape(*std::ranges::find_if(scene.shapes, isPlanet))};
    auto distant = std::ranges::find_if(scene.lights,
                                        [](const Light& light) { return std::holds_alternative<DistantLight>(light); });
    scene.lights = {distant == scene.lights.end() ? sun() : Light(*distant)};
    // What is raced is marching: whatever else light would do is left out.
    if (!std::holds_alternative<Matte>(scene.shapes[0].material)) scene.shapes[0].material = Matte{};
    scene.integrator = {};
    scene.pixel_filter = {};
    Workload workload;
    workload.maps = loadSceneMaps(scene);
    workload.map = scene.name;
    workload.width = workload.maps.maps[0]->width;
    workload.height = workload.maps.maps[0]->height;
    workload.percent = spanPercent(std::get<DisplacedSphere>(scene.shapes[0].geometry), workload.maps.reliefs[0]);
    workload.views = {{"camera", scene.camera, scene.film}};
    workload.scene = std::move(scene);
    return workload;
}

Scene smoothScene(const Workload& workload) {
    Scene scene = workload.scene;
    const Relief& relief = workload.maps.reliefs[0];
    scene.shapes[0].geometry = Sphere{0.5 * (relief.least_radius + relief.greatest_radius)};
    scene.shapes[0].material = {};
    return scene;
}

}  // namespace dsphere::bench
