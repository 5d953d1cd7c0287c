#include "cli/sceneoptions.h"

#include "base/error.h"
#include "base/limits.h"
#include "cli/commands.h"
#include "geo/mapfile.h"
#include "render/raster.h"
#include "scene/heightmapscene.h"
#include "scene/motion.h"
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
    if (film.width < 1 || film.height < 1 || film.width > limits::kResolution || film.height > limits::kResolution)
        throwUsage("--resolution: {}x{} is outside 1 to {}", film.width, film.height, limits::kResolution);
    if (!options.crop.empty()) std::copy(options.crop.begin(), options.crop.end(), film.crop.begin());
    const auto& [x0, x1, y0, y1] = film.crop;
    if (!(x0 >= 0.0 && x0 < x1 && x1 <= 1.0 && y0 >= 0.0 && y0 < y1 && y1 <= 1.0))
        throwUsage("--cropwindow: {},{},{},{}: expected 0 <= x0 < x1 <= 1 and 0 <= y0 < y1 <= 1", x0, x1, y0, y1);
    Box box = cropBox(film);
    if (box.width() < 1 || box.height() < 1)
        throwUsage("--cropwindow: {},{},{},{} holds no pixel of {}x{}", x0, x1, y0, y1, film.width, film.height);
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
                    "Look at the first displaced sphere from above a latitude and longitude in degrees: ALT is the "
                    "height above the ground there, in radii of the shape (its \"float radius\"). Straight down, north "
                    "up and east to the right, unless --heading and --pitch say otherwise")
        ->expected(3)
        ->delimiter(',')
        ->type_name("LAT,LON,ALT");
    command
        .add_option("--heading", options.heading,
                    "With --lookat-latlon: what is ahead, or up in a picture that looks straight down, in degrees: 0 "
                    "north (the default), 90 east")
        ->type_name("DEG");
    command
        .add_option("--pitch", options.pitch,
                    "With --lookat-latlon: degrees above the horizontal, 0 level, -90 straight down (the default)")
        ->type_name("DEG");
    addMapOptions(command, options.map);
    command
        .add_option("--mem-limit", options.memory_limit,
                    "Memory for heights, as 512M or 2G: a larger map stays in its file, and parts of it are read when "
                    "rays need them; the picture is the same. Default: half of the device's")
        ->transform(CLI::AsSizeValue(false).description(""))
        ->type_name("SIZE");
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
    if (!std::isfinite(options.exaggeration)) throwUsage("--exaggeration: expected a finite number");
    if (options.exaggeration != 1.0) exaggerate(scene, options.exaggeration);
    if (options.quick) scene.sampler.pixel_samples = 1;
    if (options.samples) scene.sampler.pixel_samples = *options.samples;
    if (options.seed) scene.sampler.seed = *options.seed;
    return scene;
}

}  // namespace dsphere::cli
