#include "verify/verify.h"

#include "base/error.h"
#include "cli/anydevice.h"
#include "cli/commands.h"
#include "cli/outputs.h"
#include "cli/placecamera.h"
#include "cli/print.h"
#include "cli/readmaps.h"
#include "cli/sceneoptions.h"
#include "image/picture.h"

#include <nlohmann/json.hpp>

#include <cmath>

namespace dsphere::cli {

namespace {

struct VerifyOptions {
    CommonOptions common;
    SceneOptions scene;
    std::uint64_t samples = 0;
    std::string outfile = "dsphere-verify";
};

// R, G, B and t of the device minus the reference's; 0 where both miss.
Image difference(const Image& device, const Image& reference) {
    Image result{device.data, device.display, {}};
    for (const char* name : {"R", "G", "B", "t"}) {
        Channel& channel = result.addFloat(name);
        const auto& a = device.at(name).floats();
        const auto& b = reference.at(name).floats();
        for (std::size_t i = 0; i < a.size(); ++i) channel.floats()[i] = a[i] == b[i] ? 0.0f : a[i] - b[i];
    }
    return result;
}

// Of the pictures that a failure leaves.
std::string evidencePath(const VerifyOptions& options, const char* what) {
    return fmt::format("{}-{}.exr", options.outfile, what);
}

void writeEvidence(const VerifyOptions& options, const Scene& scene, const SceneMaps& maps, const Image& device,
                   const Progress& progress) {
    Image reference = verify::referenceImage(scene, maps, progress);
    auto write = [&](const char* what, const Image& image) {
        const std::string path = evidencePath(options, what);
        writeExr(path, image, {});
        if (!options.common.quiet) printErr("wrote {}\n", path);
    };
    write("device", device);
    write("reference", reference);
    write("difference", difference(device, reference));
}

void printFaults(const verify::Report& report, const Image& image) {
    int width = image.data.width();
    for (const verify::Fault& fault : report.faults)
        printErr("pixel {}, {}: {}\n", image.data.x0 + int(fault.ray) % width, image.data.y0 + int(fault.ray) / width,
                 fault.what);
}

int runVerify(const VerifyOptions& options) {
    Scene scene = loadScene(options.scene);
    checkOutputs({{evidencePath(options, "device"), "the device's picture"},
                  {evidencePath(options, "reference"), "the reference's picture"},
                  {evidencePath(options, "difference"), "the difference"}},
                 inputsOf(scene));
    SceneMaps maps = readMaps(scene, options.scene, options.common);
    placeCamera(scene, maps, options.scene);
    if (!options.common.quiet) {
        printNotices(scene.notices), printNotices(maps.notices());
        printCameraNotices(scene, maps);
    }
    AnyDevice device(options.common);
    const PackedScene packed = packScene(scene, maps);
    Image planes;
    {  // what the renderer holds is free for the reference after this
        const auto renderer = device.makeRenderer(packed, scene, options.scene.marcher);
        planes = renderer->renderPlanes(kVerifyPlanes, {});
    }
    verify::Outcome outcome;
    {
        ProgressLine line(options.common.progress, options.common.quiet, "verify");
        outcome = verify::verifyPlanes(std::move(planes), scene, maps, options.samples,
                                       [&](double share) { return line.update(share); });
    }
    device.checkValidation();
    const verify::Report& report = outcome.report;
    std::vector<std::string> violations = report.violations();
    if (options.common.json) {
        nlohmann::ordered_json json = {
            {"scene", scene.name}, {"device", device.info().name}, {"driver", device.info().driver}};
        json.update(report.json());
        printText(jsonText(json));
    } else {
        print("{} on {}\n\n{}\n", scene.name, device.info().name, report.table());
        print("{}\n", violations.empty() ? "The contract holds." : "The contract is broken:");
        for (const std::string& line : violations) print("  {}\n", line);
    }
    if (violations.empty()) return int(ExitCode::Ok);
    if (!options.common.quiet) printFaults(report, outcome.device);
    ProgressLine line(options.common.progress, options.common.quiet, "reference picture");
    writeEvidence(options, scene, maps, outcome.device, [&](double share) { return line.update(share); });
    return int(ExitCode::ComparisonFailed);
}

}  // namespace

void addVerify(CLI::App& app, Action& action) {
    CLI::App* command =
        app.add_subcommand("verify", "Hold every pixel of a device against the certified CPU reference");
    auto options = std::make_shared<VerifyOptions>();
    addSceneOptions(*command, options->scene);
    command->add_option("--sample", options->samples, "Compare this many pixels, drawn at random; default: all")
        ->check(CLI::NonNegativeNumber)
        ->check(CLI::NonNegativeNumber.description(""))
        ->type_name("N");
    command
        ->add_option("-o,--outfile", options->outfile,
                     "Where a failure leaves its pictures: NAME-device.exr, -reference.exr, -difference.exr")
        ->type_name("NAME")
        ->capture_default_str();
    addCommonOptions(*command, options->common, Devices::AndHost);
    command->callback([options, &action] { action = [options] { return runVerify(*options); }; });
}

}  // namespace dsphere::cli
