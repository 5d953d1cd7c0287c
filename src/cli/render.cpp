#include "base/error.h"
#include "cli/animation.h"
#include "cli/commands.h"
#include "cli/header.h"
#include "cli/placecamera.h"
#include "cli/rendered.h"
#include "cli/resume.h"
#include "cli/sceneondevice.h"
#include "cli/signals.h"

#include <chrono>
#include <memory>
#include <optional>

namespace dsphere::cli {

namespace {

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

// An interruption ends it at once, by an Error, or after the sample in progress if a part is to be written.
Rendered renderOne(SceneRenderer& renderer, const Scene& scene, const Shard& shard, const RenderOptions& options,
                   const Target& target, SampleSums start) {
    ProgressLine line(options.common.progress, options.common.quiet, "render");
    const auto update = [&](double share) { return line.update(share); };
    const auto updateOrThrow = [&](double share) {
        if (line.update(share)) return true;
        if (!options.write_partial) throw Error(ExitCode::Interrupted, "interrupted; nothing was written");
        line.say("interrupted: completing the sample in progress; once more to stop at once");
        return false;
    };
    return renderAll(renderer, scene, shard, target, std::move(start), update, updateOrThrow);
}

[[noreturn]] void throwPartial(const RenderOptions& options, const Target& target, int samples, int wanted) {
    std::string how = fmt::format("go on by the same command with --resume {}", target.path.string());
    if (target.isOutput()) how = "go on from the file that it went to by the same command with --resume";
    if (target.format == Format::Png) how = "a .png cannot be gone on with";
    if (options.reproducible) how = "a picture of --reproducible cannot be gone on with";
    throw Error(ExitCode::Interrupted, fmt::format("interrupted; wrote {} with {} of {} samples a pixel; {}",
                                                   target.name(), samples, wanted, how));
}

int runRender(const RenderOptions& options) {
    Clock::time_point start = Clock::now();
    std::optional<Completing> completing;  // lasts until all else is taken down
    Scene scene = loadScene(options.scene);
    if (!options.common.quiet) printNotices(scene.notices);
    scene.integrator.clamp = options.clamp;
    scene.integrator.hide_distance = options.alpha;
    const MarchMethod method(options.scene.marcher, MarchMethod().threshold, options.detail);
    if (options.frames.wanted()) return renderAnimation(options, scene, method);
    Target target = checkTarget(options, scene, options.outfile.empty() ? scene.film.filename : options.outfile);
    Shard shard = shardOf(options.shard, scene);
    SceneOnDevice shown(scene, options.scene, options.common, method, target.planes());
    const SceneMaps& maps = shown.moving().maps();
    if (!options.common.quiet) printCameraNotices(scene, maps);
    shown.renderer().setCrop(shard.box);
    if (shard.part) shard.part->turns = shown.device().turns(traitsOf(scene), method);
    Origin origin = originOf(scene, maps, method, shown.device().info());
    origin.data = shard.box;
    Earlier earlier;
    if (!options.resume.empty()) earlier = readEarlier(options.resume, origin, shard.first, shard.last);
    if (earlier.sums.samples() > 0 && !earlier.sums.parts().front().sums.find("A")) target.colours = kColourPlanes;
    if (options.write_partial) completing.emplace();
    Rendered rendered = renderOne(shown.renderer(), scene, shard, options, target, std::move(earlier.sums));
    shown.device().checkValidation();
    const int done = rendered.colour.samples();
    const std::size_t non_finite = nonFinitePixels(rendered.colour);
    std::optional<double> seconds = earlier.device_seconds + shown.renderer().stats().device_seconds;
    if (options.reproducible) seconds.reset();
    Metadata metadata = makeMetadata(scene, origin, done, seconds);
    if (shard.part) tellPart(metadata, *shard.part);
    writeTarget(target, std::move(rendered).picture(), metadata, options);
    if (done < shard.samples()) throwPartial(options, target, done, shard.samples());
    const Result result{target, shown.device().info(), shown.renderer(), maps, secondsSince(start), non_finite};
    if (!options.common.quiet) printNotices(noticesOf(non_finite, shown.renderer().stats().given_up_pixels));
    if (options.common.json) printJson(result);
    if (!options.common.quiet) printReport(result, options.common.verbose);
    return int(ExitCode::Ok);
}

}  // namespace

void addRender(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("render", "Render a scene to a picture");
    auto options = std::make_shared<RenderOptions>();
    addRenderOptions(*command, *options);
    command->callback([options, &action] { action = [options] { return runRender(*options); }; });
}

}  // namespace dsphere::cli
