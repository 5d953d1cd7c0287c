#include "verify/selftest.h"

#include "base/error.h"
#include "cli/anydevice.h"
#include "cli/print.h"

#include <nlohmann/json.hpp>

namespace dsphere::cli {

namespace {

verify::Candidate candidateOf(AnyDevice& target) {
    return {target.info().name, [&target](const PackedScene& packed, const Scene& scene) {
                return target.makeRenderer(packed, scene, Marcher::Exact);
            }};
}

AnyDevice hostDevice(host::Precision precision) {
    CommonOptions options;
    options.device = hostName(precision);
    return AnyDevice(options);
}

void printRow(const verify::SelftestRow& row) {
    print("{:<36} {}\n", row.scene, verify::stepName(row.step));
    for (const verify::SceneResult& result : row.results) {
        const verify::Report& report = result.report;
        print("  {:<34} {:>6} {:>6} {:>9.2g} {:>9.2g} {:>7} {:>7} {:>9.2g} {:>7.2f}\n", result.device.substr(0, 34),
              report.hits, report.wrong_verdicts + report.later_roots, report.distanceQuantile(1.0),
              report.normalQuantile(verify::contract::kNormalShare), report.wrong_shadows, report.wrong_colours,
              report.worst_colour, 100.0 * result.paths_off);
    }
    for (const std::string& fault : row.reference_faults) print("    reference: {}\n", fault);
    for (const verify::SceneResult& result : row.results)
        for (const std::string& fault : result.faults) print("    {}: {}\n", result.device, fault);
}

nlohmann::ordered_json rowJson(const verify::SelftestRow& row) {
    nlohmann::ordered_json json = {{"scene", row.scene},
                                   {"step", verify::stepName(row.step)},
                                   {"reference_faults", row.reference_faults},
                                   {"devices", nlohmann::ordered_json::array()}};
    for (const verify::SceneResult& result : row.results) {
        nlohmann::ordered_json one = {{"device", result.device}};
        one.update(result.report.json());
        one["paths_off"] = result.paths_off;
        one["faults"] = result.faults;
        json["devices"].push_back(one);
    }
    return json;
}

void printHead(const gpu::DeviceInfo& device) {
    print("{} ({}), dsphere {}\n\n", device.name, device.driver, DSPHERE_VERSION);
    print("{:<36} {:>6} {:>6} {:>9} {:>9} {:>7} {:>7} {:>9} {:>7}\n", "scene: step at fault", "hits", "wrong",
          "distance", "normals", "shadows", "colours", "of bound", "paths");
}

int runSelftest(const CommonOptions& options) {
    AnyDevice target(options), in_double = hostDevice(host::Precision::Double),
                               in_float = hostDevice(host::Precision::Float);
    const verify::Candidate device = candidateOf(target);
    if (!options.json) printHead(target.info());
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    int faults = 0;
    for (int i = 0; i < verify::testSceneCount(); ++i) {
        const verify::SelftestRow row = verify::selftestScene(i, candidateOf(in_double), candidateOf(in_float),
                                                              target.isVulkan() ? &device : nullptr);
        faults += row.step != verify::Step::None;
        if (options.json)
            rows.push_back(rowJson(row));
        else
            printRow(row), finishOutput();
    }
    target.checkValidation();
    if (options.json)
        printText(jsonText(nlohmann::ordered_json{{"device", target.info().name},
                                                  {"driver", target.info().driver},
                                                  {"version", DSPHERE_VERSION},
                                                  {"passed", faults == 0},
                                                  {"scenes", rows}}));
    else if (faults == 0)
        print("\nAll {} scenes hold.\n", verify::testSceneCount());
    else
        print("\n{} of {} scenes fail.\n", faults, verify::testSceneCount());
    return int(faults == 0 ? ExitCode::Ok : ExitCode::ComparisonFailed);
}

}  // namespace

void addSelftest(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand(
        "selftest", "Render and verify small scenes on a device and on the host; name the step of each fault");
    auto options = std::make_shared<CommonOptions>();
    addCommonOptions(*command, *options, Devices::AndHost);
    command->callback([options, &action] { action = [options] { return runSelftest(*options); }; });
}

}  // namespace dsphere::cli
