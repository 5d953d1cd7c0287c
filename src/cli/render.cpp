#include "base/error.h"
#include "cli/commands.h"
#include "cli/resume.h"
#include "cli/sceneoptions.h"
#include "image/picture.h"
#include "render/raster.h"
#include "render/renderer.h"
#include "surface/fingerprint.h"

#include <nlohmann/json.hpp>

#include <bit>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <future>
#include <optional>

namespace dsphere::cli {

namespace {

struct RenderOptions {
    CommonOptions common;
    SceneOptions scene;
    std::string outfile, aov, resume;
    Tone tone;
    double clamp = 0.0;   ///< Integrator::clamp
    float detail = 0.0f;  ///< pixels; 0: exact
    bool write_partial = false;
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

// As pbrt stores them: row vectors, so the matrix is transposed against ours.
std::array<float, 16> headerMatrix(const dmat4& m) {
    std::array<float, 16> values;
    for (int i = 0; i < 16; ++i) values[std::size_t(i)] = float(m[i / 4][i % 4]);
    return values;
}

dmat4 ndcFromWorld(const Raster& raster) {
    dvec2 size = raster.screen_max - raster.screen_min;
    dmat4 ndc(1.0);  // from the screen window (over z in perspective) to [0, 1], y upward
    ndc[0][0] = 1.0 / size.x;
    ndc[1][1] = 1.0 / size.y;
    dvec2 shift = -raster.screen_min / size;
    if (raster.projection == Projection::Perspective)
        ndc[2] = dvec4(shift, 1.0, 1.0), ndc[3] = dvec4(0.0);
    else
        ndc[3] = dvec4(shift, 0.0, 1.0);
    return ndc * raster.camera_from_world;
}

Metadata makeMetadata(const Scene& scene, const Origin& origin, int samples, double seconds) {
    Metadata metadata = {{"scene", scene.name},
                         {"samplesPerPixel", samples},
                         {"renderTimeSeconds", float(seconds)},
                         {"worldToCamera", headerMatrix(scene.camera.camera_from_world)},
                         {"worldToNDC", headerMatrix(ndcFromWorld(makeRaster(scene.camera, scene.film)))}};
    origin.tell(metadata);
    return metadata;
}

Origin originOf(const Scene& scene, const SceneMaps& maps, const MarchMethod& method, const gpu::DeviceInfo& device) {
    Hash hash;
    hash.word(fingerprint(scene, maps));
    hash.word(std::uint64_t(method.marcher));
    hash.word(std::bit_cast<std::uint32_t>(method.threshold));
    hash.word(std::bit_cast<std::uint32_t>(method.detail));
    const Film& film = scene.film;
    return {.seed = scene.sampler.seed,
            .fingerprint = fmt::format("{:016x}", hash.value()),
            .device = device.name,
            .driver = device.driver,
            .software = std::string("dsphere ") + DSPHERE_VERSION,
            .data = cropBox(film),
            .display = {0, 0, film.width, film.height}};
}

// Wrong options must not cost a render first.
std::uint32_t checkOutput(const RenderOptions& options, const std::filesystem::path& path, int samples) {
    std::uint32_t aovs = parseAovs(options.aov);
    std::string extension = path.extension().string();
    if (extension != ".png" && extension != ".exr")
        throw Error(ExitCode::Usage, fmt::format("{}: unknown picture format '{}'; .png and .exr are supported",
                                                 path.string(), extension));
    if (extension == ".png" && aovs)
        throw Error(ExitCode::Usage, fmt::format("{}: a PNG cannot hold --aov outputs; write .exr", path.string()));
    if (extension == ".exr" && options.tone.curve != ToneCurve::Linear)
        throw Error(ExitCode::Usage, fmt::format("{}: an EXR holds light as it is; --tone is for .png", path.string()));
    if (samples < 0 || samples > 65536)
        throw Error(ExitCode::Usage, fmt::format("--spp: {} is outside 0 to 65536", samples));
    if (!(options.clamp >= 0.0 && std::isfinite(options.clamp)))
        throw Error(ExitCode::Usage, fmt::format("--clamp: {} is not a number of 0 or more", options.clamp));
    if (samples == 0 && !options.resume.empty()) throw Error(ExitCode::Usage, "--resume needs --spp above 0");
    if (samples == 0 && !aovs) throw Error(ExitCode::Usage, "--spp 0 renders no colour, so it needs --aov");
    checkWritable(path);
    return aovs;
}

struct Result {
    std::filesystem::path picture;
    const gpu::DeviceInfo& device;
    const Renderer& renderer;
    const SceneMaps& maps;
    double seconds;

    double raysPerSecond() const {
        const RenderStats& stats = renderer.stats();
        return stats.device_seconds > 0.0 ? double(stats.camera_rays) / stats.device_seconds : 0.0;
    }
};

void printJson(const Result& result) {
    const RenderStats& stats = result.renderer.stats();
    nlohmann::ordered_json json = {{"picture", result.picture.string()},
                                   {"device", result.device.name},
                                   {"driver", result.device.driver},
                                   {"seconds", result.seconds},
                                   {"device_seconds", stats.device_seconds},
                                   {"camera_rays", stats.camera_rays},
                                   {"camera_rays_per_second", result.raysPerSecond()},
                                   {"retried_pixels", stats.retried_pixels},
                                   {"map_bytes", result.renderer.mapBytes()},
                                   {"image_bytes", result.renderer.imageBytes()},
                                   {"maps", nlohmann::ordered_json::array()}};
    for (const auto& map : result.maps.maps)
        json["maps"].push_back({{"path", map->path}, {"nodata_texels", map->nodata_count}});
    fmt::print("{}\n", json.dump(2));
}

void printReport(const Result& result, bool verbose) {
    double mib = 1.0 / 1048576.0;
    fmt::print(stderr, "picture  {}\ndevice   {} ({})\n", std::filesystem::absolute(result.picture).string(),
               result.device.name, result.device.driver);
    fmt::print(stderr, "time     {:.2f} s in all, {:.3f} s on the device\n", result.seconds,
               result.renderer.stats().device_seconds);
    fmt::print(stderr, "speed    {:.1f} million camera rays a second, with their shadow rays\n",
               result.raysPerSecond() * 1e-6);
    for (const auto& map : result.maps.maps)
        if (map->nodata_count > 0)
            fmt::print(stderr, "nodata   {} of {} texels of {}, filled from their neighbours\n", map->nodata_count,
                       map->samples.size(), map->path);
    if (!verbose) return;
    fmt::print(stderr, "maps     {:.1f} MiB on the device\n", double(result.renderer.mapBytes()) * mib);
    fmt::print(stderr, "images   {:.1f} MiB on the device\n", double(result.renderer.imageBytes()) * mib);
    fmt::print(stderr, "retried  {} pixels in full precision\n", result.renderer.stats().retried_pixels);
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

// An interruption ends it at once, by an Error, or after the sample in progress if a part is to be written.
Rendered renderAll(Renderer& renderer, const Scene& scene, const RenderOptions& options, std::uint32_t aovs,
                   SampleSums start) {
    ProgressLine line(options.common.progress, options.common.quiet, "render");
    const auto update = [&](double share) { return line.update(share); };
    const auto updateOrThrow = [&](double share) {
        if (line.update(share)) return true;
        if (!options.write_partial) throw Error(ExitCode::Interrupted, "interrupted; nothing was written");
        line.say("interrupted: completing the sample in progress; once more to stop at once");
        return false;
    };
    Rendered result;
    if (aovs) result.planes = renderer.renderPlanes(aovs, update);
    if (scene.sampler.pixel_samples > 0)
        result.colour = renderer.renderSums(std::move(start), scene.sampler.pixel_samples,
                                            std::uint32_t(scene.sampler.seed), updateOrThrow);
    return result;
}

[[noreturn]] void throwPartial(const std::filesystem::path& path, int samples, int wanted) {
    const std::string how = path.extension() == ".exr"
                                ? fmt::format("go on by the same command with --resume {}", path.string())
                                : "a .png cannot be gone on with";
    throw Error(ExitCode::Interrupted, fmt::format("interrupted; wrote {} with {} of {} samples a pixel; {}",
                                                   path.string(), samples, wanted, how));
}

int runRender(const RenderOptions& options) {
    Clock::time_point start = Clock::now();
    Scene scene = loadScene(options.scene);
    if (!options.common.quiet) printNotices(scene.notices);
    scene.integrator.clamp = options.clamp;
    std::filesystem::path path = options.outfile.empty() ? scene.film.filename : options.outfile;
    int samples = scene.sampler.pixel_samples;
    std::uint32_t aovs = checkOutput(options, path, samples);
    if (options.detail > 0.0f && options.scene.marcher != Marcher::Exact)
        throw Error(ExitCode::Usage, "--detail is of the exact marcher; the baselines march the map itself");
    const MarchMethod method(options.scene.marcher, MarchMethod().threshold, options.detail);
    // A driver compiles while the maps are read. A bad map is what the user hears of first, whatever the device.
    auto reading = std::async(std::launch::async, [&scene] { return loadSceneMaps(scene); });
    std::optional<gpu::Device> opened;
    std::future<void> compiling;
    try {
        opened.emplace(gpu::DeviceOptions{options.common.device, options.common.validation});
        compiling = warmAhead(*opened, traitsOf(scene), method, aovs ? aovs : kColourPlanes);
    } catch (...) {
        reading.get();
        throw;
    }
    gpu::Device& device = *opened;
    SceneMaps maps = reading.get();
    if (!options.common.quiet) printNotices(maps.notices());
    PackedScene packed = packScene(scene, maps, options.detail > 0.0f ? Levels::All : Levels::Finest);
    if (compiling.valid()) compiling.get();
    Renderer renderer(device, packed, scene, method);

    const Origin origin = originOf(scene, maps, method, device.info());
    Earlier earlier;
    if (!options.resume.empty()) earlier = readEarlier(options.resume, origin, samples);
    Rendered rendered = renderAll(renderer, scene, options, aovs, std::move(earlier.sums));
    checkValidation(device);
    const int done = rendered.colour.samples;
    const double seconds = earlier.device_seconds + renderer.stats().device_seconds;
    writePicture(path, std::move(rendered).picture(), makeMetadata(scene, origin, done, seconds), options.tone);
    if (done < samples) throwPartial(path, done, samples);
    const Result result{path, device.info(), renderer, maps, secondsSince(start)};
    if (options.common.json) printJson(result);
    if (!options.common.quiet) printReport(result, options.common.verbose);
    return int(ExitCode::Ok);
}

}  // namespace

void addRender(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("render", "Render a scene to a picture");
    auto options = std::make_shared<RenderOptions>();
    addSceneOptions(*command, options->scene);
    command->add_option("-o,--outfile", options->outfile, "Picture to write, .png or .exr; default: the scene's Film")
        ->type_name("FILE");
    command->add_option("--spp", options->scene.samples, "Samples a pixel; 0: only the --aov outputs");
    command->add_option("--seed", options->scene.seed, "Seed of the sample positions");
    command
        ->add_option("--aov", options->aov,
                     "Further outputs into the .exr: all, or t,P,N,Ns,u,v,Albedo,id,lit,"
                     "steps,residual")
        ->type_name("LIST");
    command->add_option("--exposure", options->tone.exposure, "Stops to brighten a .png by");
    addChoice<ToneCurve>(
        *command, "--tone", options->tone.curve,
        {{"linear", ToneCurve::Linear}, {"aces", ToneCurve::Aces}, {"reinhard", ToneCurve::Reinhard}},
        "Curve of a .png's light, after --exposure: linear (the default) cuts at 1; aces: Narkowicz 2015; reinhard: x "
        "/ (1 + x)",
        "linear|aces|reinhard");
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
    addCommonOptions(*command, options->common);
    command->callback([options, &action] { action = [options] { return runRender(*options); }; });
}

}  // namespace dsphere::cli
