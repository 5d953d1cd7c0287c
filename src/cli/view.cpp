#include "base/error.h"
#include "cli/commands.h"
#include "cli/placecamera.h"
#include "cli/print.h"
#include "cli/sceneoptions.h"
#include "cli/signals.h"
#include "scene/motion.h"
#include "scene/textfile.h"
#include "viewer/viewer.h"

#include <cmath>

namespace dsphere::cli {

namespace {

struct ViewOptions {
    SceneOptions scene;
    viewer::ViewerOptions viewer;
};

int runView(const ViewOptions& options) {
    requireVulkan(options.viewer.device);
    if (options.scene.scene == "-" || isOpenDescriptor(options.scene.scene))
        throwUsage("view shows files, which it reads again when they change: it takes no scene from standard input");
    if (options.scene.samples && (*options.scene.samples < 1 || *options.scene.samples > 65536))
        throw Error(ExitCode::Usage, fmt::format("--spp: {} is outside 1 to 65536", *options.scene.samples));
    if (!std::isfinite(options.scene.exaggeration))
        throw Error(ExitCode::Usage, "--exaggeration: expected a finite number");
    viewer::ViewerOptions viewer = options.viewer;
    viewer.path = options.scene.scene;
    viewer.method = options.scene.marcher;
    viewer.samples = options.scene.samples;
    viewer.exaggeration = options.scene.exaggeration;
    viewer.exact_size = !options.scene.resolution.empty();
    viewer.open = [scene = options.scene](const std::string& path) {
        SceneOptions named = scene;
        if (path != scene.scene && !isHeightmap(path)) named.map = {};  // they were said of the first map
        named.scene = path;
        named.exaggeration = 1.0;  // the panel's, which begins with it
        Scene opened = loadScene(named);
        Scene seen = opened;
        exaggerate(seen, scene.exaggeration);
        if (!named.latlon.empty() || named.heading || named.pitch) placeCamera(seen, loadSceneMaps(seen), named);
        opened.camera = seen.camera;
        return opened;
    };
    viewer.wrote = [](const std::filesystem::path& file) { print("wrote {}\n", file.string()); };
    viewer.interrupted = [] { return caughtSignal() != 0; };
    namingTheHost([&] { viewer::runViewer(viewer); });
    if (caughtSignal()) throw Error(ExitCode::Interrupted, "interrupted");
    return int(ExitCode::Ok);
}

}  // namespace

void addView(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("view", "Show a scene or a heightmap in a window; H lists the keys");
    auto options = std::make_shared<ViewOptions>();
    addSceneOptions(*command, options->scene);
    command->get_option("scene")->required(false)->description(
        "Scene file (.pbrt; not - for standard input), or a heightmap, shown over its own range of values; none: the "
        "window asks for one");
    command->add_option("--spp", options->scene.samples, "Samples a pixel that a still view refines to");
    command->add_option("--seed", options->scene.seed, "Seed of the sample positions");
    command->add_option("--device", options->viewer.device, "Vulkan device: its index, a part of its name, or cpu")
        ->type_name("INDEX|NAME|cpu");
    command->add_flag("--validation", options->viewer.validation,
                      "Run under the Vulkan validation layers; any message fails at the end");
    // For tests: a line of JSON a frame; the pictures by way of the host.
    command->add_option("--journal", options->viewer.journal)->group("");
    command->add_flag("--present-apart", options->viewer.apart)->group("");
    command->callback([options, &action] { action = [options] { return runView(*options); }; });
}

}  // namespace dsphere::cli
