#include "cli/sceneoptions.h"

#include "base/error.h"
#include "cli/commands.h"
#include "scene/parser.h"

#include <algorithm>

namespace dsphere::cli {

namespace {

[[noreturn]] void throwUsage(const std::string& message) {
    throw Error(ExitCode::Usage, message);
}

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
        throwUsage(fmt::format("--resolution: {}x{} is outside 1 to 65536", film.width, film.height));
    if (options.crop.empty()) return;
    std::copy(options.crop.begin(), options.crop.end(), film.crop.begin());
    const auto& [x0, x1, y0, y1] = film.crop;
    if (!(x0 >= 0.0 && x0 < x1 && x1 <= 1.0 && y0 >= 0.0 && y0 < y1 && y1 <= 1.0))
        throwUsage(
            fmt::format("--cropwindow: {},{},{},{}: expected 0 <= x0 < x1 <= 1 and 0 <= y0 < y1 <= 1", x0, x1, y0, y1));
}

}  // namespace

void addSceneOptions(CLI::App& command, SceneOptions& options) {
    command.add_option("scene", options.scene, "Scene file (.pbrt), or - for standard input")->required();
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
                       {{"exact", Marcher::Exact}, {"naive", Marcher::Naive}, {"naive-shell", Marcher::NaiveShell}},
                       "How to find hits: exact (the default), or a baseline", "exact|naive|naive-shell");
    command.add_flag("--quick", options.quick, "A quarter of the resolution and one sample a pixel");
}

Scene loadScene(const SceneOptions& options) {
    Scene scene = parseSceneFile(options.scene);
    applyFilm(scene.film, options);
    if (options.quick) scene.sampler.pixel_samples = 1;
    if (options.samples) scene.sampler.pixel_samples = *options.samples;
    if (options.seed) scene.sampler.seed = *options.seed;
    return scene;
}

}  // namespace dsphere::cli
