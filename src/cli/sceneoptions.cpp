#include "cli/sceneoptions.h"

#include "base/error.h"
#include "cli/commands.h"
#include "geo/mapfile.h"
#include "render/raster.h"
#include "scene/heightmapscene.h"
#include "scene/parser.h"

#include <algorithm>
#include <cmath>

namespace dsphere::cli {

namespace {

void applyFilm(Film& film, const SceneOptions& options) {
    if (!options.resolution.empty()) {
        film.width = options.resolution[0];
        film.height = options.resolution[1];
    }
    if (options.quick) {
        film.width = std::max(1, film.width / 4);
        film.height = std::max(1, film.height / 4);
    }
    if (film.width < 1 || film.height < 1 || film.width > 65536 || film.height > 65536)
        throwUsage("--resolution: {}x{} is outside 1 to 65536", film.width, film.height);
    if (!options.crop.empty()) std::copy(options.crop.begin(), options.crop.end(), film.crop.begin());
    const auto& [x0, x1, y0, y1] = film.crop;
    if (!(x0 >= 0.0 && x0 < x1 && x1 <= 1.0 && y0 >= 0.0 && y0 < y1 && y1 <= 1.0))
        throwUsage("--cropwindow: {},{},{},{}: expected 0 <= x0 < x1 <= 1 and 0 <= y0 < y1 <= 1", x0, x1, y0, y1);
    Box box = cropBox(film);
    if (box.width() < 1 || box.height() < 1)
        throwUsage("--cropwindow: {},{},{},{} holds no pixel of {}x{}", x0, x1, y0, y1, film.width, film.height);
}

void exaggerate(Scene& scene, double factor) {
    if (!std::isfinite(factor)) throwUsage("--exaggeration: expected a finite number");
    for (Shape& shape : scene.shapes) {
        auto* sphere = std::get_if<DisplacedSphere>(&shape.geometry);
        if (!sphere) continue;
        sphere->max_displacement *= factor;
        if (sphere->height_scale) *sphere->height_scale *= factor;
    }
}

// Above a place of the first displaced sphere, looking straight down, north up, east to the right.
void lookFromAbove(Scene& scene, const std::vector<double>& latlon) {
    auto planet = std::find_if(scene.shapes.begin(), scene.shapes.end(), [](const Shape& shape) {
        return std::holds_alternative<DisplacedSphere>(shape.geometry);
    });
    if (planet == scene.shapes.end()) throwUsage("--lookat-latlon: the scene has no displacedsphere");
    if (!(std::abs(latlon[0]) <= 90.0 && std::isfinite(latlon[1]) && latlon[2] > 0.0))
        throwUsage("--lookat-latlon: expected a latitude in [-90, 90], a longitude and an altitude > 0");
    double lat = glm::radians(latlon[0]), lon = glm::radians(latlon[1]);
    dvec3 outward(std::cos(lat) * std::sin(lon), std::sin(lat), std::cos(lat) * std::cos(lon));
    dvec3 north(-std::sin(lat) * std::sin(lon), std::cos(lat), -std::sin(lat) * std::cos(lon));
    const auto& sphere = std::get<DisplacedSphere>(planet->geometry);
    dvec3 eye = transformPoint(planet->world_from_object, outward * (sphere.radius * (1.0 + latlon[2])));
    dvec3 centre = transformPoint(planet->world_from_object, dvec3(0.0));
    dvec3 ahead = glm::normalize(centre - eye), up = transformVector(planet->world_from_object, north);
    dvec3 east = glm::normalize(glm::cross(ahead, up));
    dmat4 world_from_camera(dvec4(east, 0.0), dvec4(glm::cross(east, ahead), 0.0), dvec4(ahead, 0.0), dvec4(eye, 1.0));
    scene.camera.camera_from_world = glm::inverse(world_from_camera);
}

}  // namespace

void addSceneOptions(CLI::App& command, SceneOptions& options) {
    command
        .add_option("scene", options.scene,
                    "Scene file (.pbrt), or - for standard input; or a heightmap, shown over its own range of values")
        ->required();
    command.add_option("--resolution", options.resolution, "Film size in pixels")
        ->type_size(2)
        ->expected(1)
        ->delimiter(',')
        ->type_name("W,H");
    command.add_option("--cropwindow", options.crop, "Part of the film to render, as fractions, y downward")
        ->type_size(4)
        ->expected(1)
        ->delimiter(',')
        ->type_name("X0,X1,Y0,Y1");
    addChoice<Marcher>(command, "--marcher", options.marcher,
                       {{"exact", Marcher::Exact},
                        {"naive", Marcher::Naive},
                        {"naive-shell", Marcher::NaiveShell},
                        {"lipschitz", Marcher::Lipschitz}},
                       "How to find hits: exact (the default), or a baseline", "exact|naive|naive-shell|lipschitz");
    command.add_option("--exaggeration", options.exaggeration, "Multiply all displacements")->type_name("X");
    command
        .add_option("--lookat-latlon", options.latlon,
                    "Look straight down on the first displaced sphere from a latitude and longitude in degrees and an "
                    "altitude in radii; north is up, east to the right")
        ->expected(3)
        ->delimiter(',')
        ->type_name("LAT,LON,ALT");
    addMapOptions(command, options.map);
    command.add_flag("--quick", options.quick, "A quarter of the resolution and one sample a pixel");
}

bool isHeightmap(const std::string& name) {
    return name != "-" && geo::looksLikeMap(name);
}

Scene loadScene(const SceneOptions& options) {
    const bool is_map = isHeightmap(options.scene);
    if (!is_map) requireNone(options.map, options.scene);
    Scene scene = is_map ? heightmapScene(options.scene) : parseSceneFile(options.scene);
    if (is_map) applyTo(scene, options.map);
    applyFilm(scene.film, options);
    if (options.exaggeration != 1.0) exaggerate(scene, options.exaggeration);
    if (!options.latlon.empty()) lookFromAbove(scene, options.latlon);
    if (options.quick) scene.sampler.pixel_samples = 1;
    if (options.samples) scene.sampler.pixel_samples = *options.samples;
    if (options.seed) scene.sampler.seed = *options.seed;
    return scene;
}

}  // namespace dsphere::cli
