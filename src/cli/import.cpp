#include "geo/import.h"
#include "base/error.h"
#include "cli/commands.h"
#include "cli/outputs.h"
#include "cli/print.h"

#include <nlohmann/json.hpp>

namespace dsphere::cli {

namespace {

struct ImportCommand {
    std::string outfile;
    std::vector<std::string> inputs;
    std::vector<int> resolution;
    bool quiet = false, json = false;
    ProgressMode progress = ProgressMode::Auto;
};

int runImport(const ImportCommand& command) {
    geo::ImportOptions options;
    options.inputs.assign(command.inputs.begin(), command.inputs.end());
    options.output = command.outfile;
    if (!command.resolution.empty()) options.resolution = {command.resolution[0], command.resolution[1]};
    std::vector<NamedFile> inputs;
    for (const std::string& input : command.inputs) inputs.push_back({input, "an input"});
    checkOutputs({{command.outfile, "OUT.tif"}}, inputs);
    geo::ImportResult result;
    {
        ProgressLine line(command.progress, command.quiet, "import");
        options.progress = [&line](double share) { return line.update(share); };
        result = geo::importMaps(options);
    }
    if (!command.quiet) printNotices(result.notices);
    if (!command.json) return int(ExitCode::Ok);
    const nlohmann::ordered_json json = {
        {"map", command.outfile}, {"width", result.width},    {"height", result.height},
        {"type", result.type},    {"inputs", command.inputs}, {"bytes", std::filesystem::file_size(command.outfile)}};
    printText(jsonText(json));
    return int(ExitCode::Ok);
}

}  // namespace

void addImport(CLI::App& app, Action& action) {
    CLI::App* command =
        app.add_subcommand("import", "Make one map of a whole planet of tiles, pieces and other projections");
    auto options = std::make_shared<ImportCommand>();
    command->add_option("outfile", options->outfile, "Map to write: .tif or .tiff")->type_name("OUT.tif")->required();
    command->add_option("inputs", options->inputs, "Maps with a place on the planet; later ones lie over earlier ones")
        ->type_name("IN")
        ->required();
    command
        ->add_option("--resolution", options->resolution,
                     "Columns and rows of the map; default: texels as small as those of the finest input")
        ->type_size(2)
        ->expected(1)
        ->delimiter(',')
        ->type_name("W,H");
    command->add_flag("--json", options->json, "Print what was made as JSON");
    command->add_flag("--quiet", options->quiet, "Print errors only");
    addProgressOption(*command, options->progress);
    command->callback([options, &action] { action = [options] { return runImport(*options); }; });
}

}  // namespace dsphere::cli
