#include "base/error.h"
#include "bench/contender.h"
#include "bench/environment.h"
#include "bench/sidebyside.h"
#include "bench/suite.h"
#include "cli/commands.h"
#include "cli/outputs.h"
#include "cli/print.h"
#include "cli/sceneoptions.h"
#include "image/picture.h"
#include "report/baseline.h"
#include "report/csv.h"
#include "report/json.h"
#include "report/report.h"
#include "report/table.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <thread>

namespace dsphere::cli {

namespace {

struct BenchOptions {
    CommonOptions common;
    std::vector<std::string> scenes, methods, views;
    std::vector<int> maps, resolution;
    std::vector<double> displacements;
    std::optional<int> repeats;
    std::optional<std::uint64_t> samples;
    std::string csv, json, html, markdown, baseline, beside_mesh;
    bool quick = false;
    MapOptions map;
};

// A minute on two slow cores: small maps, a quarter of the pixels, one setting a method.
void makeQuick(bench::Suite& suite, bench::Plan& plan, const BenchOptions& options) {
    suite.widths = {1024, 2048};
    suite.percents = {5.0};
    suite.width = 640;
    suite.height = 360;
    plan.repeats = 3;
    plan.seconds = 0.5;
    plan.setups = 1;
    plan.samples = 500;
    if (options.methods.empty())
        plan.methods =
            bench::chooseMethods(bench::haveEmbree() ? std::vector<std::string>{"exact", "naive 3e-6", "lipschitz",
                                                                                "smooth", "grid", "triangles"}
                                                     : std::vector<std::string>{});
}

/// What is to be measured, and the files that it takes.
struct Work {
    std::vector<bench::Source> sources;
    std::vector<NamedFile> inputs;
};

Work sceneWork(const BenchOptions& options) {
    if (!options.maps.empty() || !options.displacements.empty() || !options.views.empty())
        throw Error(ExitCode::Usage, "--maps, --displacements and --views are of the default suite, not of scenes");
    Work work;
    for (const std::string& name : options.scenes) {
        SceneOptions scene_options;
        scene_options.scene = name;
        scene_options.resolution = options.resolution;
        scene_options.quick = options.quick;
        scene_options.map = options.map;
        // Parsed before anything is measured: a mistake in the last scene must not cost the first one's time.
        Scene scene = loadScene(scene_options);
        bench::requirePlanet(scene);
        work.sources.push_back({[scene] { return bench::sceneWorkload(scene); }, 1});
        for (NamedFile& file : inputsOf(scene)) work.inputs.push_back(std::move(file));
    }
    return work;
}

Work chooseWork(bench::Suite suite, const BenchOptions& options) {
    if (!options.scenes.empty()) return sceneWork(options);
    if (options.map != MapOptions())
        throwUsage("--nodata, --radius and their like are of a map, not of the default suite");
    if (!options.maps.empty()) suite.widths = options.maps;
    if (!options.displacements.empty()) suite.percents = options.displacements;
    if (!options.resolution.empty()) suite.width = options.resolution[0], suite.height = options.resolution[1];
    suite.views = options.views;
    return {bench::suiteSources(suite), {}};
}

// Beside the report in Markdown.
std::filesystem::path figurePath(const BenchOptions& options) {
    return std::filesystem::path(options.markdown).replace_extension(".svg");
}

void checkReports(const BenchOptions& options, std::vector<NamedFile> inputs) {
    std::vector<NamedFile> outputs;
    const auto add = [&](const std::filesystem::path& path, const char* option) {
        if (!path.empty()) outputs.push_back({path, option});
    };
    add(options.csv, "--csv");
    add(options.json, "--json-file");
    add(options.html, "--html");
    add(options.markdown, "--markdown");
    if (!options.markdown.empty()) add(figurePath(options), "--markdown's figure");
    add(options.beside_mesh, "--beside-mesh");
    if (!options.baseline.empty()) inputs.push_back({options.baseline, "the baseline"});
    checkOutputs(outputs, inputs);
}

void writeReports(const BenchOptions& options, const report::Results& results) {
    auto write = [&](const std::filesystem::path& path, const std::string& text) {
        report::writeText(path, text);
        if (!options.common.quiet) printErr("wrote {}\n", path.string());
    };
    if (!options.csv.empty()) write(options.csv, report::csv(results));
    if (!options.json.empty()) write(options.json, jsonText(report::toJson(results)));
    if (!options.html.empty()) write(options.html, report::html(results));
    if (options.markdown.empty()) return;
    const std::filesystem::path figure = figurePath(options);
    std::string drawing = report::figureFile(results);
    if (!drawing.empty()) write(figure, drawing);
    write(options.markdown, report::markdown(results, drawing.empty() ? "" : figure.filename().string()));
}

// In place of a measurement.
int runSideBySide(const BenchOptions& options) {
    if (options.scenes.size() != 1) throw Error(ExitCode::Usage, "--beside-mesh draws one scene: name it");
    const Work work = sceneWork(options);
    checkReports(options, work.inputs);
    const bench::Workload workload = work.sources[0].make();
    gpu::Device device = openDevice(options.common);
    const bench::SideBySide drawn = bench::drawSideBySide(device, workload);
    checkValidation(device);
    writePng(options.beside_mesh, drawn.picture);
    print("pixels that both hit  {}\nthat one alone hits   {}\nin other shadow       {}\n", drawn.hits, drawn.one_sided,
          drawn.other_shadow);
    print("normals               median {:.3f}, greatest {:.1f} degrees apart (white: {} degrees)\n",
          drawn.median_degrees, drawn.greatest_degrees, bench::kWhiteDegrees);
    print("shades                {:.5f} apart in the mean (white: {})\n", drawn.mean_shade, bench::kWhiteShade);
    return int(ExitCode::Ok);
}

int runBench(const BenchOptions& options) {
    if (!options.beside_mesh.empty()) return runSideBySide(options);
    bench::Suite suite;
    bench::Plan plan;
    plan.methods = bench::chooseMethods(options.methods);
    if (options.quick) makeQuick(suite, plan, options);
    plan.repeats = options.repeats.value_or(plan.repeats);
    plan.setups = std::min(plan.setups, plan.repeats);
    plan.samples = options.samples.value_or(plan.samples);
    const Work work = chooseWork(suite, options);
    checkReports(options, work.inputs);
    std::optional<report::Results> before;
    if (!options.baseline.empty()) before = report::readResults(options.baseline);

    const double load = bench::systemLoad();
    if (load > 0.5 * std::thread::hardware_concurrency() && !options.common.quiet)
        printErr("the machine is busy (load {:.1f}): speeds will be low and uneven\n", load);
    auto start = std::chrono::steady_clock::now();
    // No caches: set-up times are of shaders that no driver has seen.
    gpu::Device device = openDevice(options.common, false);
    std::chrono::duration<double> opening = std::chrono::steady_clock::now() - start;
    report::Results results;
    {
        ProgressLine line(options.common.progress, options.common.quiet, "bench");
        results.views = bench::measure(device, work.sources, plan, [&](double share) { return line.update(share); });
    }
    checkValidation(device);
    results.environment = bench::describeEnvironment(device, opening.count(), load);
    results.quick = options.quick;
    results.repeats = plan.repeats;
    results.samples = plan.samples;
    writeReports(options, results);
    std::string changes = before ? report::changes(results, *before) : "";
    if (options.common.json) {
        printText(jsonText(report::toJson(results)));
        printErrorText(changes);
    } else {
        print("{}{}", report::table(results), changes);
    }
    return int(ExitCode::Ok);
}

void addSuiteOptions(CLI::App& command, BenchOptions& options) {
    command.add_option("scene", options.scenes, "Scenes (.pbrt) to measure instead of the default suite")
        ->type_name("SCENE");
    command.add_option("--maps", options.maps, "Widths of the suite's fractal maps; default: 1024,4096,8192")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->type_name("W,...");
    command.add_option("--displacements", options.displacements, "Their displacements in percent; default: 5,15,50")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->type_name("P,...");
    command.add_option("--views", options.views, "Their views, separated by commas; default: all")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->type_name("whole|limb|horizon");
    command
        .add_option("--methods", options.methods,
                    "Families of methods, or single ones (\"naive 3e-6\", \"grid 1/2\"), separated by commas; default: "
                    "all. Meshes (grid, triangles) need a build with Embree")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->type_name("exact|detail|naive|lipschitz|smooth|iterated|grid|triangles");
    command.add_option("--resolution", options.resolution, "Pixels; default: 1280,720, or the scene's film")
        ->type_size(2)
        ->expected(1)
        ->delimiter(',')
        ->check(CLI::Range(1, 65536).description(""))
        ->type_name("W,H");
    command.add_option("--repeats", options.repeats, "Timed runs of each method; default: 7")
        ->check(CLI::Range(1, 1000).description(""))
        ->type_name("N");
    command.add_option("--sample", options.samples, "Pixels a view to hold against the reference; default: 4000")
        ->check(CLI::Range(1, 1 << 30).description(""))
        ->type_name("N");
    command.add_flag("--quick", options.quick,
                     "Small maps, few pixels (of a scene: a quarter each way), few repeats: under a minute");
}

}  // namespace

void addBench(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("bench", "Measure speed against error, beside other methods");
    auto options = std::make_shared<BenchOptions>();
    addSuiteOptions(*command, *options);
    addMapOptions(*command, options->map);
    auto file = [&](const char* name, std::string& path, const char* help) {
        command->add_option(name, path, help)->type_name("FILE");
    };
    file("--csv", options->csv, "Write a line a view and method");
    file("--json-file", options->json, "Write what --json prints; --baseline reads it");
    file("--html", options->html, "Write a report with plots, in one file");
    file("--markdown", options->markdown, "Write a report, and beside it its figure as .svg");
    file("--beside-mesh", options->beside_mesh,
         "Measure nothing: draw the scene and Embree's triangles of it side by side into this .png");
    file("--baseline", options->baseline, "Print the change since the run that wrote this JSON");
    addCommonOptions(*command, options->common);
    command->callback([options, &action] { action = [options] { return runBench(*options); }; });
}

}  // namespace dsphere::cli
