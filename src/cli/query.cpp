#include "query/stream.h"

#include "base/error.h"
#include "cli/commands.h"
#include "cli/outputs.h"
#include "cli/print.h"
#include "cli/readmaps.h"
#include "cli/sceneoptions.h"

#include <nlohmann/json.hpp>

namespace dsphere::cli {

namespace {

struct QueryCommand {
    CommonOptions common;
    SceneOptions scene;
    std::string rays, outfile;
    std::optional<query::FileFormat> format, output_format;
    query::Frame frame = query::Frame::World;
    std::vector<std::string> fields;
    bool any = false, certify = false;
};

query::Record chooseFields(const QueryCommand& options) {
    std::vector<std::string> names = options.fields;
    if (names.empty())
        names = options.any ? std::vector<std::string>{"status"} : query::Record::everyName(options.certify);
    query::Record record(names);
    for (const char* name : {"t_low", "t_high", "tangent"})
        if (record.has(name) && !options.certify) throwUsage("--fields: {} needs --certify", name);
    for (const std::string& name : names)
        if (options.any && name != "status") throwUsage("--fields: --any finds the status alone, not {}", name);
    return record;
}

RayWishes wishesOf(const query::Record& record, bool certify, const Scene& scene) {
    const bool others = std::ranges::any_of(
        scene.shapes, [](const Shape& shape) { return !std::holds_alternative<DisplacedSphere>(shape.geometry); });
    return {.normal = record.has("N") || certify,
            .lit = record.has("lit"),
            .place = others && (record.has("u") || record.has("v"))};
}

/// What the host has to find for these fields; --certify judges position and normal too.
query::AnswerParts partsOf(const query::Record& record, bool certify) {
    const auto hasAny = [&](std::initializer_list<const char*> names) {
        return std::ranges::any_of(names, [&](const char* name) { return record.has(name); });
    };
    query::AnswerParts parts;
    parts.position = certify || record.has("P");
    parts.normal = certify || record.has("N");
    parts.place = hasAny({"u", "v", "lat", "lon", "height", "metres"});
    parts.root = parts.position || parts.normal || parts.place || record.has("t");
    return parts;
}

void printSummary(const QueryCommand& options, const Scene& scene, const gpu::Device& device,
                  const query::StreamCounts& counts, const query::Certifier* certifier) {
    const auto say = [&](const std::string& text) {
        if (options.outfile == "-")
            printErrorText(text);
        else
            printText(text);
    };
    if (options.common.json) {
        nlohmann::ordered_json json = {{"scene", scene.name},      {"device", device.info().name},
                                       {"rays", counts.rays},      {"hits", counts.hits},
                                       {"inside", counts.inside},  {"invalid", counts.invalid},
                                       {"seconds", counts.seconds}};
        if (certifier) json["certified"] = certifier->report().json();
        say(jsonText(json));
        return;
    }
    if (options.common.quiet) return;
    printErr("{} rays on {}: {} hits, {} starting inside, {} not valid; {:.2f} million rays/s\n", counts.rays,
             device.info().name, counts.hits, counts.inside, counts.invalid,
             double(counts.rays) * 1e-6 / std::max(counts.seconds, 1e-9));
    if (certifier) say(certifier->report().table() + "\n");
}

int judge(const QueryCommand& options, const query::Certifier& certifier) {
    const std::vector<std::string> violations = certifier.violations();
    for (const std::string& line : violations) printErr("broken: {}\n", line);
    if (!options.common.quiet)
        for (const verify::Fault& fault : certifier.report().faults) printErr("ray {}: {}\n", fault.ray, fault.what);
    return int(violations.empty() ? ExitCode::Ok : ExitCode::ComparisonFailed);
}

int runQuery(const QueryCommand& options) {
    const query::Record record = chooseFields(options);
    const query::FileFormat format = options.output_format.value_or(
        options.outfile == "-" ? query::FileFormat::Csv : query::formatOfName(options.outfile));
    if (options.rays == "-" && options.scene.scene == "-")
        throwUsage("the scene and the rays cannot both come from standard input");
    const Scene scene = loadScene(options.scene);
    std::vector<NamedFile> inputs = inputsOf(scene);
    inputs.push_back({options.rays, "the rays"});
    checkOutputs({{options.outfile, "the answers"}}, inputs);
    const SceneMaps maps = readMaps(scene, options.scene, options.common);
    if (!options.common.quiet) printNotices(scene.notices), printNotices(maps.notices());
    const query::Geography geography(scene, maps, options.frame);
    const auto reader = query::openRays(options.rays, options.format, geography);
    const PackedScene packed = packScene(scene, maps);
    gpu::Device device = openDevice(options.common);
    const DeviceScene device_scene(device, packed);
    query::Engine engine(device, scene, maps, packed, device_scene,
                         {.frame = options.frame,
                          .wishes = wishesOf(record, options.certify, scene),
                          .parts = partsOf(record, options.certify)});
    std::optional<query::Certifier> certifier;
    if (options.certify) certifier.emplace(scene, maps, options.frame, record.has("tangent"));
    query::HitWriter writer(options.outfile, format, record, reader->count());
    query::StreamCounts counts;
    {
        ProgressLine line(options.common.progress, options.common.quiet, "query");
        counts = query::streamRays(*reader, engine, record, writer, certifier ? &*certifier : nullptr,
                                   [&](double share) { return line.update(share); });
    }
    checkValidation(device);
    if (engine.runaways() > 0)
        throwFailure("{} rays were ended by a limit of steps: please report the scene", engine.runaways());
    writer.finish();
    printSummary(options, scene, device, counts, certifier ? &*certifier : nullptr);
    return certifier ? judge(options, *certifier) : int(ExitCode::Ok);
}

void addFormat(CLI::App& command, const std::string& name, std::optional<query::FileFormat>& format,
               const std::string& help) {
    addChoice<std::optional<query::FileFormat>>(
        command, name, format, {{"npy", query::FileFormat::Npy}, {"csv", query::FileFormat::Csv}}, help, "npy|csv");
}

}  // namespace

void addQuery(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("query", "Find the first hits of rays of your own");
    auto options = std::make_shared<QueryCommand>();
    command->add_option("scene", options->scene.scene, "Scene file (.pbrt), or - for standard input; or a heightmap")
        ->required();
    command
        ->add_option("rays", options->rays,
                     "Rays: a NumPy array of float64, N x 6 (origin, direction) or N x 8 (tmin and tmax too), or a CSV "
                     "file with named columns; - for standard input")
        ->required();
    command
        ->add_option("-o,--outfile", options->outfile,
                     "Answers, in the rays' order: .npy or .csv; - for CSV on standard output")
        ->type_name("FILE")
        ->required();
    command
        ->add_option("--fields", options->fields,
                     "What to write of each answer, default all: status,t,P,N,u,v,lat,lon,height,metres,id,lit, with "
                     "--certify also t_low,t_high,tangent")
        ->delimiter(',')
        ->type_name("NAMES");
    addChoice<query::Frame>(
        *command, "--frame", options->frame, {{"world", query::Frame::World}, {"body", query::Frame::Body}},
        "Space of rays and answers: world (the default), or the first displaced sphere's own", "world|body");
    addFormat(*command, "--format", options->format, "Format of the rays; default: their content decides");
    addFormat(*command, "--output-format", options->output_format,
              "Format of the answers; default: by the name's ending");
    command->add_flag("--any", options->any, "Find only whether anything lies between tmin and tmax");
    command->add_flag("--certify", options->certify,
                      "Ask the certified reference too; exit code 5 where the device is wrong");
    command->add_option("--exaggeration", options->scene.exaggeration, "Multiply all displacements")->type_name("X");
    addMapOptions(*command, options->scene.map);
    addCommonOptions(*command, options->common);
    command->callback([options, &action] { action = [options] { return runQuery(*options); }; });
}

}  // namespace dsphere::cli
