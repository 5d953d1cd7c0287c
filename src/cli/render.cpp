#include "base/error.h"
#include "cli/commands.h"
#include "cli/frames.h"
#include "cli/header.h"
#include "cli/outputs.h"
#include "cli/placecamera.h"
#include "cli/print.h"
#include "cli/resume.h"
#include "cli/sceneondevice.h"
#include "cli/sceneoptions.h"
#include "cli/signals.h"
#include "image/picture.h"
#include "reference/ground.h"

#include <unistd.h>

#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <optional>

namespace dsphere::cli {

namespace {

constexpr const char* kStandardOutput = "-";

enum class Format { Png, Exr };

struct RenderOptions {
    CommonOptions common;
    SceneOptions scene;
    std::string outfile, aov, resume;
    FrameOptions frames;
    std::optional<Format> format;
    std::optional<double> exposure;
    ToneCurve tone = ToneCurve::Linear;
    double clamp = 0.0;   ///< Integrator::clamp
    float detail = 0.0f;  ///< pixels; 0: exact
    bool alpha = false, write_partial = false, reproducible = false;
};

/// Where the picture goes, and the planes that it is made of.
struct Target {
    std::filesystem::path path;  ///< "-": standard output
    Format format = Format::Png;
    std::uint32_t aovs = 0, colours = kColourPlanes;

    /// What the first pass renders.
    std::uint32_t planes() const { return aovs ? aovs : colours; }
    bool isOutput() const { return path == kStandardOutput; }
    std::string name() const { return isOutput() ? "standard output" : path.string(); }
};

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
    return std::chrono::duration<double>(Clock::now() - start).count();
}

void addDetail(CLI::App& command, float& detail) {
    const CLI::callback_t read = [&detail](const CLI::results_t& words) {
        detail = 0.0f;
        if (words[0] == "exact") return true;
        if (!CLI::detail::lexical_cast(words[0], detail) || !(detail > 0.0f) || !std::isfinite(detail))
            throw CLI::ValidationError("--detail", "expected exact or a number of pixels above 0, not " + words[0]);
        return true;
    };
    command
        .add_option("--detail", read,
                    "exact (the default), or how many pixels the surface may be off where texels are smaller than "
                    "pixels: faster, and without aliasing")
        ->type_name("exact|PIXELS");
}

Format formatOf(const RenderOptions& options, const std::filesystem::path& path) {
    if (path == kStandardOutput) return options.format.value_or(Format::Png);
    if (options.format) throwUsage("--format is for -o -; the name of a file says its format");
    const std::string extension = extensionOf(path);
    if (extension != ".png" && extension != ".exr")
        throwUsage("{}: unknown picture format '{}'; .png and .exr are supported", path.string(),
                   path.extension().string());
    return extension == ".png" ? Format::Png : Format::Exr;
}

void checkSampling(const RenderOptions& options, int samples, std::uint32_t aovs) {
    if (samples < 0 || samples > 65536) throwUsage("--spp: {} is outside 0 to 65536", samples);
    if (!(options.clamp >= 0.0 && std::isfinite(options.clamp)))
        throwUsage("--clamp: {} is not a number of 0 or more", options.clamp);
    if (samples == 0 && !options.resume.empty()) throwUsage("--resume needs --spp above 0");
    if (samples == 0 && !aovs) throwUsage("--spp 0 renders no colour, so it needs --aov");
    if (options.detail > 0.0f && options.scene.marcher != Marcher::Exact)
        throwUsage("--detail is of the exact marcher; the baselines march the map itself");
}

void checkFormat(const RenderOptions& options, const Target& target) {
    const std::string name = target.name();
    if (options.exposure && !std::isfinite(*options.exposure))
        throwUsage("--exposure: {} is not a finite number of stops", *options.exposure);
    if (target.format == Format::Png && target.aovs)
        throwUsage("{}: a PNG cannot hold --aov outputs; write .exr", name);
    if (target.format == Format::Png) return;
    if (options.tone != ToneCurve::Linear) throwUsage("{}: an EXR holds light as it is; --tone is for .png", name);
    if (options.exposure) throwUsage("{}: an EXR holds light as it is; --exposure is for .png", name);
}

// Wrong options must not cost a render first.
Target checkTarget(const RenderOptions& options, const Scene& scene, const std::filesystem::path& path) {
    Target target{.path = path};
    target.aovs = parseAovs(options.aov);
    target.format = formatOf(options, target.path);
    if (target.format == Format::Exr || options.alpha) target.colours |= kAlphaPlane;
    checkFormat(options, target);
    checkSampling(options, scene.sampler.pixel_samples, target.aovs);
    if (target.isOutput() && options.common.json) throwUsage("-o - and --json both write to standard output");
    if (target.isOutput() && isatty(STDOUT_FILENO))
        throwUsage("-o -: standard output is a terminal, which shows no pictures; redirect it");
    std::vector<NamedFile> inputs = inputsOf(scene);
    checkOutputs({{target.path, options.outfile.empty() ? "the scene's Film" : "--outfile"}}, inputs);
    return target;
}

struct Result {
    const Target& target;
    const gpu::DeviceInfo& device;
    const SceneRenderer& renderer;
    const SceneMaps& maps;
    double seconds;
    std::size_t non_finite_pixels;

    double raysPerSecond() const {
        const RenderStats& stats = renderer.stats();
        return stats.device_seconds > 0.0 ? double(stats.camera_rays) / stats.device_seconds : 0.0;
    }
};

void printJson(const Result& result) {
    const RenderStats& stats = result.renderer.stats();
    nlohmann::ordered_json json = {{"picture", result.target.path.string()},
                                   {"device", result.device.name},
                                   {"driver", result.device.driver},
                                   {"seconds", result.seconds},
                                   {"device_seconds", stats.device_seconds},
                                   {"camera_rays", stats.camera_rays},
                                   {"camera_rays_per_second", result.raysPerSecond()},
                                   {"retried_pixels", stats.retried_pixels},
                                   {"non_finite_pixels", result.non_finite_pixels},
                                   {"map_bytes", result.renderer.mapBytes()},
                                   {"image_bytes", result.renderer.imageBytes()},
                                   {"maps", nlohmann::ordered_json::array()}};
    for (const auto& map : result.maps.maps)
        json["maps"].push_back({{"path", map->path}, {"nodata_texels", map->nodata_count}});
    printText(jsonText(json));
}

void printReport(const Result& result, bool verbose) {
    double mib = 1.0 / 1048576.0;
    std::error_code ignored;
    const bool output = result.target.isOutput();
    printErr("picture  {}\ndevice   {} ({})\n",
             output ? result.target.name() : std::filesystem::absolute(result.target.path, ignored).string(),
             result.device.name, result.device.driver);
    printErr("time     {:.2f} s in all, {:.3f} s on the device\n", result.seconds,
             result.renderer.stats().device_seconds);
    printErr("speed    {:.1f} million camera rays a second, with their shadow rays\n", result.raysPerSecond() * 1e-6);
    for (const auto& map : result.maps.maps)
        if (map->nodata_count > 0)
            printErr("nodata   {} of {} texels of {}, filled from their neighbours\n", map->nodata_count,
                     map->samples.size(), map->path);
    if (!verbose) return;
    printErr("maps     {:.1f} MiB on the device\n", double(result.renderer.mapBytes()) * mib);
    printErr("images   {:.1f} MiB on the device\n", double(result.renderer.imageBytes()) * mib);
    printErr("retried  {} pixels in full precision\n", result.renderer.stats().retried_pixels);
}

/// What is rendered of a picture: all of it, or fewer samples than the scene asks for.
struct Rendered {
    Image planes;
    SampleSums colour;

    Image picture() && {
        if (colour.samples == 0) return std::move(planes);
        Image image = pictureOf(std::move(colour));
        image.channels.insert(image.channels.end(), std::make_move_iterator(planes.channels.begin()),
                              std::make_move_iterator(planes.channels.end()));
        return image;
    }
};

// `update_planes` is told the share that is done of the AOVs; false ends all by an Error. `update` is told that of the
// colour; false ends it after the sample in progress. Both may throw.
Rendered renderAll(SceneRenderer& renderer, const Scene& scene, const Target& target, SampleSums start,
                   const Progress& update_planes, const Progress& update) {
    Rendered result;
    if (target.aovs) result.planes = renderer.renderPlanes(target.aovs, update_planes);
    if (scene.sampler.pixel_samples > 0)
        result.colour = renderer.renderSums(std::move(start), scene.sampler.pixel_samples,
                                            std::uint32_t(scene.sampler.seed), update, target.colours);
    return result;
}

// An interruption ends it at once, by an Error, or after the sample in progress if a part is to be written.
Rendered renderOne(SceneRenderer& renderer, const Scene& scene, const RenderOptions& options, const Target& target,
                   SampleSums start) {
    ProgressLine line(options.common.progress, options.common.quiet, "render");
    const auto update = [&](double share) { return line.update(share); };
    const auto updateOrThrow = [&](double share) {
        if (line.update(share)) return true;
        if (!options.write_partial) throw Error(ExitCode::Interrupted, "interrupted; nothing was written");
        line.say("interrupted: completing the sample in progress; once more to stop at once");
        return false;
    };
    return renderAll(renderer, scene, target, std::move(start), update, updateOrThrow);
}

[[noreturn]] void throwPartial(const RenderOptions& options, const Target& target, int samples, int wanted) {
    std::string how = fmt::format("go on by the same command with --resume {}", target.path.string());
    if (target.isOutput()) how = "go on from the file that it went to by the same command with --resume";
    if (target.format == Format::Png) how = "a .png cannot be gone on with";
    if (options.reproducible) how = "a picture of --reproducible cannot be gone on with";
    throw Error(ExitCode::Interrupted, fmt::format("interrupted; wrote {} with {} of {} samples a pixel; {}",
                                                   target.name(), samples, wanted, how));
}

void writeTarget(const Target& target, const Image& picture, const Metadata& metadata, const RenderOptions& options) {
    if (target.format == Format::Exr)
        writeExr(target.path, picture, metadata);
    else
        writePng(target.path, picture, {options.exposure.value_or(0.0), options.tone});
}

Notices noticesOf(std::size_t non_finite_pixels) {
    if (non_finite_pixels == 0) return {};
    return {{Notice::Kind::Warning, fmt::format("{} pixels hold light that is not finite", non_finite_pixels)}};
}

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
    const int first = missing.empty() ? plan.range.first : missing.front();
    Target target = checkTarget(options, scene, plan.name.of(first));
    if (target.format == Format::Exr && plan.motion && plan.motion->exposureAt(0))
        throwUsage("{}: column exposure: an EXR holds light as it is; exposure is for .png", options.frames.path);
    std::vector<NamedFile> inputs = inputsOf(scene);
    if (plan.motion) inputs.push_back({options.frames.path, "--path"});
    for (const int number : missing) checkOutputs({{plan.name.of(number), "a frame"}}, inputs);
    return target;
}

int runFrames(const RenderOptions& options, Scene& scene, const MarchMethod& method) {
    const Completing completing;  // frames that are rendered are written
    const FramePlan plan(options.frames, options.outfile.empty() ? scene.film.filename : options.outfile);
    const std::vector<int> missing = plan.missing();
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
            const double before = shown.renderer().stats().device_seconds;
            const auto progressOfPlanes = [&](double) { return progress(0.0); };
            auto rendered = std::make_shared<Rendered>(
                renderAll(shown.renderer(), frame.scene, target, {}, progressOfPlanes, progress));
            shown.device().checkValidation();
            notices.add(frame.number, noticesOf(nonFinitePixels(rendered->colour)));
            std::optional<double> seconds = shown.renderer().stats().device_seconds - before;
            device_seconds += *seconds;
            if (options.reproducible) seconds.reset();
            return [&, seconds, rendered, frame = std::move(frame)] {
                const Origin origin = originOf(frame.scene, shown.moving().maps(), method, shown.device().info());
                const int samples = rendered->colour.samples;
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

int runRender(const RenderOptions& options) {
    Clock::time_point start = Clock::now();
    std::optional<Completing> completing;  // lasts until all else is taken down
    Scene scene = loadScene(options.scene);
    if (!options.common.quiet) printNotices(scene.notices);
    scene.integrator.clamp = options.clamp;
    scene.integrator.hide_distance = options.alpha;
    const MarchMethod method(options.scene.marcher, MarchMethod().threshold, options.detail);
    if (options.frames.wanted()) return runFrames(options, scene, method);
    Target target = checkTarget(options, scene, options.outfile.empty() ? scene.film.filename : options.outfile);
    const int samples = scene.sampler.pixel_samples;
    SceneOnDevice shown(scene, options.scene, options.common, method, target.planes());
    const SceneMaps& maps = shown.moving().maps();
    if (!options.common.quiet) printCameraNotices(scene, maps);
    const Origin origin = originOf(scene, maps, method, shown.device().info());
    Earlier earlier;
    if (!options.resume.empty()) earlier = readEarlier(options.resume, origin, samples);
    if (earlier.sums.samples > 0 && !earlier.sums.sums.find("A")) target.colours = kColourPlanes;
    if (options.write_partial) completing.emplace();
    Rendered rendered = renderOne(shown.renderer(), scene, options, target, std::move(earlier.sums));
    shown.device().checkValidation();
    const int done = rendered.colour.samples;
    const std::size_t non_finite = nonFinitePixels(rendered.colour);
    std::optional<double> seconds = earlier.device_seconds + shown.renderer().stats().device_seconds;
    if (options.reproducible) seconds.reset();
    writeTarget(target, std::move(rendered).picture(), makeMetadata(scene, origin, done, seconds), options);
    if (done < samples) throwPartial(options, target, done, samples);
    const Result result{target, shown.device().info(), shown.renderer(), maps, secondsSince(start), non_finite};
    if (!options.common.quiet) printNotices(noticesOf(non_finite));
    if (options.common.json) printJson(result);
    if (!options.common.quiet) printReport(result, options.common.verbose);
    return int(ExitCode::Ok);
}

void addPictureOptions(CLI::App& command, RenderOptions& options) {
    command
        .add_option("-o,--outfile", options.outfile,
                    "Picture to write, .png or .exr; default: the scene's Film; - is standard output")
        ->type_name("FILE");
    addChoice<std::optional<Format>>(command, "--format", options.format, {{"png", Format::Png}, {"exr", Format::Exr}},
                                     "What -o - writes; default: png", "png|exr");
    command
        .add_option("--aov", options.aov,
                    "Further outputs into the .exr: all, or t,P,N,Ns,u,v,Albedo,id,lit,"
                    "steps,residual")
        ->type_name("LIST");
    command.add_flag("--alpha", options.alpha,
                     "Transparent where nothing is hit, infinite lights behind the shapes too: a .png gets an alpha "
                     "channel, which an .exr always has");
    command.add_option("--exposure", options.exposure, "Stops to brighten a .png by")->type_name("STOPS");
    addChoice<ToneCurve>(
        command, "--tone", options.tone,
        {{"linear", ToneCurve::Linear}, {"aces", ToneCurve::Aces}, {"reinhard", ToneCurve::Reinhard}},
        "Curve of a .png's light, after --exposure: linear (the default) cuts at 1; aces: Narkowicz 2015; reinhard: x "
        "/ (1 + x)",
        "linear|aces|reinhard");
    command.add_flag("--reproducible", options.reproducible,
                     "Leave the time, the device and its driver out of the .exr's header: runs then write the same "
                     "bytes, and --resume cannot go on from them");
}

}  // namespace

void addRender(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("render", "Render a scene to a picture");
    auto options = std::make_shared<RenderOptions>();
    addSceneOptions(*command, options->scene);
    command->add_option("--spp", options->scene.samples, "Samples a pixel; 0: only the --aov outputs");
    command->add_option("--seed", options->scene.seed, "Seed of the sample positions");
    addPictureOptions(*command, *options);
    command
        ->add_option("--clamp", options->clamp,
                     "Scale down samples whose greatest channel is above X, to X: fewer bright specks, some light "
                     "lost; 0 (the default): none")
        ->type_name("X");
    command->add_flag("--write-partial", options->write_partial,
                      "When interrupted, complete the sample in progress and write the picture of those done");
    command
        ->add_option("--resume", options->resume,
                     "An .exr that render wrote of the same scene and options with fewer samples: go on from it; the "
                     "picture is that of an uninterrupted render, bit for bit")
        ->type_name("FILE.exr");
    addDetail(*command, options->detail);
    addFrameOptions(*command, options->frames);
    addCommonOptions(*command, options->common, Devices::AndHost);
    command->callback([options, &action] { action = [options] { return runRender(*options); }; });
}

}  // namespace dsphere::cli
