#include "geo/import.h"
#include "base/error.h"
#include "cli/commands.h"

#include <nlohmann/json.hpp>

namespace dsphere::cli {

namespace {

struct Options {
    std::string outfile;
    std::vector<std::string> inputs;
    std::vector<int> resolution;
    bool quiet = false, json = false;
    ProgressMode progress = ProgressMode::Auto;
};

int runImport(const Options& options) {
    geo::ImportOptions import;
    import.inputs.assign(options.inputs.begin(), options.inputs.end());
    import.output = options.outfile;
    if (!options.resolution.empty()) import.resolution = {options.resolution[0], options.resolution[1]};
    checkWritable(options.outfile);
    geo::ImportResult result;
    {
        ProgressLine line(options.progress, options.quiet, "import");
        import.progress = [&](double share) { return line.update(share);
    };
    result = geo::importMaps(import);
}
if (!options.quiet) printNotices(result.notices);
if (!options.json) return int(ExitCode::Ok);
nlohmann::ordered_json json = {{"map", options.outfile},   {"width", result.width},
                               {"height", result.height},  {"type", result.type},
                               {"inputs", options.inputs}, {"bytes", std::filesystem::file_size(options.outfile)}};
fmt::print("{}\n", json.dump(2));
return int(ExitCode::Ok);
}  // namespace

}  // namespace dsphere::cli

void addImport(CLI::App& app, Action& action) {
    CLI::App* command =
        app.add_subcommand("import", "Make one map of a whole planet of tiles, pieces and other projections");
    auto options = std::make_shared<Options>();
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
