#include "cli/sceneoptions.h"

#include "base/error.h"
#include "scene/parser.h"

#include <algorithm>
#include <map>

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
        throwUsage(fmt::format("--cropwindow: {},{},{},{}: expected 0 <= x0 < x1 <= 1 and 0 <= y0 < y1 <= 1", x0, x1,
                               y0, y1));
}

}  // namespace

void addSceneOptions(CLI::App& command, SceneOptions& options) {
    static const std::map<std::string, Marcher> marchers = {
        {"exact", Marcher::Exact}, {"naive", Marcher::Naive}, {"naive-shell", Marcher::NaiveShell}};
    command.add_option("scene", options.scene, "Scene file (.pbrt), or - for standard input")->required();
    command.add_option("--resolution", options.resolution, "Film size in pixels")
        ->expected(2)
        ->delimiter(',')
        ->type_name("W,H");
    command.add_option("--cropwindow", options.crop, "Part of the film to render, as fractions, y downward")
        ->expected(4)
        ->delimiter(',')
        ->type_name("X0,X1,Y0,Y1");
    command.add_option("--marcher", options.marcher, "How to find hits: exact, naive or naive-shell (baselines)")
        ->transform(CLI::CheckedTransformer(marchers, CLI::ignore_case))
        ->type_name("exact|naive|naive-shell");
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
