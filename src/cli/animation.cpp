#include "cli/animation.h"

#include "base/error.h"
#include "cli/header.h"
#include "cli/outputs.h"
#include "cli/print.h"
#include "cli/rendered.h"
#include "cli/sceneondevice.h"
#include "reference/ground.h"

#include <memory>
#include <optional>

namespace dsphere::cli {

namespace {

void printFrames(const FrameCounts& counts, double device_seconds, const RenderOptions& options) {
    const double each = counts.written > 0 ? 1.0 / counts.written : 0.0;
    if (options.common.json) {
        const nlohmann::ordered_json json = {{"frames", counts.written},
                                             {"skipped", counts.skipped},
                                             {"seconds", counts.seconds},
                                             {"device_seconds", device_seconds},
                                             {"writing_seconds", counts.writing_seconds}};
        printText(jsonText(json));
    }
    if (options.common.quiet) return;
    printErr("frames   {} written, {} were there\n", counts.written, counts.skipped);
    printErr("time     {:.2f} s in all; a frame {:.3f} s, {:.3f} s on the device, {:.3f} s to write beside it\n",
             counts.seconds, each * counts.seconds, each * device_seconds, each * counts.writing_seconds);
}

Target checkFrames(const RenderOptions& options, const Scene& scene, const FramePlan& plan,
                   const std::vector<int>& missing) {
    if (!options.resume.empty() || options.write_partial)
        throwUsage("--frames excludes --resume and --write-partial; see --skip-existing");
    if (options.shard.wanted()) throwUsage("--frames excludes --tile and --samples");
    const int first = missing.empty() ? plan.range.first : missing.front();
    Target target = checkTarget(options, scene, plan.name.of(first));
    if (target.format == Format::Exr && plan.motion && plan.motion->exposureAt(0))
        throwUsage("{}: column exposure: an EXR holds light as it is; exposure is for .png", options.frames.path);
    std::vector<NamedFile> inputs = inputsOf(scene);
    if (plan.motion) inputs.push_back({options.frames.path, "--path"});
    for (const int number : missing) checkOutputs({{plan.name.of(number), "a frame"}}, inputs);
    return target;
}

}  // namespace

int renderAnimation(const RenderOptions& options, Scene& scene, const MarchMethod& method) {
    const FramePlan plan(options.frames, options.outfile.empty() ? scene.film.filename : options.outfile);
    const std::vector<int> missing = plan.missing();
    const Shard whole = wholePicture(scene);
    const Target target = checkFrames(options, scene, plan, missing);
    FrameCounts counts{.skipped = plan.range.count() - int(missing.size())};
    FrameNotices notices;
    double device_seconds = 0.0;
    if (!missing.empty()) {
        SceneOnDevice shown(scene, options.scene, options.common, method, target.planes());
        ProgressLine line(options.common.progress, options.common.quiet, "render");
        const RenderFrame render = [&](Frame frame, const FrameProgress& progress) {
            shown.moving().change(frame.scene);
            notices.add(frame.number, reference::warnOfBuriedEye(frame.scene, shown.moving().maps()));
            const RenderStats before = shown.renderer().stats();
            const auto progressOfPlanes = [&](double) { return progress(0.0); };
            auto rendered = std::make_shared<Rendered>(
                renderAll(shown.renderer(), frame.scene, whole, target, {}, progressOfPlanes, progress));
            shown.device().checkValidation();
            const RenderStats& after = shown.renderer().stats();
            notices.add(frame.number,
                        noticesOf(nonFinitePixels(rendered->colour), after.given_up_pixels - before.given_up_pixels));
            std::optional<double> seconds = after.device_seconds - before.device_seconds;
            device_seconds += *seconds;
            if (options.reproducible) seconds.reset();
            return [&, seconds, rendered, frame = std::move(frame)] {
                const Origin origin = originOf(frame.scene, shown.moving().maps(), method, shown.device().info());
                const int samples = rendered->colour.samples();
                RenderOptions of_frame = options;
                if (frame.exposure) of_frame.exposure = frame.exposure;
                Target file = target;
                file.path = frame.path;
                writeTarget(file, std::move(*rendered).picture(), makeMetadata(frame.scene, origin, samples, seconds),
                            of_frame);
            };
        };
        renderFrames(plan, missing, scene, line, counts, render);
    }
    if (!options.common.quiet) printNotices(notices.all());
    printFrames(counts, device_seconds, options);
    return int(ExitCode::Ok);
}

}  // namespace dsphere::cli
