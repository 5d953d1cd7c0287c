#include "image/generate.h"

#include "base/error.h"
#include "cli/commands.h"
#include "cli/outputs.h"
#include "cli/print.h"
#include "image/greymap.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace dsphere::cli {

namespace {

struct GenerateOptions {
    MapKind kind = MapKind::Moon;
    std::string outfile;
    std::vector<int> size = {2048, 1024};
    std::uint32_t seed = 1;
    bool quiet = false, json = false;
    ProgressMode progress = ProgressMode::Auto;
};

const std::map<std::string, MapKind> kKinds = {
    {"moon", MapKind::Moon},     {"fractal", MapKind::Fractal},           {"terraces", MapKind::Terraces},
    {"spikes", MapKind::Spikes}, {"checkerboard", MapKind::Checkerboard}, {"random", MapKind::Random}};

std::string nameOf(MapKind kind) {
    return std::ranges::find_if(kKinds, [kind](const auto& named) { return named.second == kind; })->first;
}

int runGenerate(const GenerateOptions& options) {
    int width = options.size[0], height = options.size[1];
    constexpr int kMost = 1 << 20;
    if (width < 1 || height < 1 || width > kMost || height > kMost)
        throw Error(ExitCode::Usage, fmt::format("--size: {}x{} is outside 1 to {}", width, height, kMost));
    checkGreyMapName(options.outfile);
    checkOutputs({{options.outfile, "--outfile"}}, {});
    const MapGenerator generator(options.kind, width, height, options.seed);
    {
        ProgressLine line(options.progress, options.quiet, "generate");
        writeGreyMap(
            options.outfile, width, height, [&](int j, std::span<std::uint16_t> row) { generator.fillRow(j, row); },
            [&](double share) { return line.update(share); });
    }
    if (!options.json) return int(ExitCode::Ok);
    nlohmann::ordered_json json = {{"map", options.outfile}, {"kind", nameOf(options.kind)},
                                   {"width", width},         {"height", height},
                                   {"seed", options.seed},   {"bytes", std::filesystem::file_size(options.outfile)}};
    printText(jsonText(json));
    return int(ExitCode::Ok);
}

}  // namespace

void addGenerate(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("generate", "Make a 16-bit heightmap from a formula and a seed");
    auto options = std::make_shared<GenerateOptions>();
    addChoice<MapKind>(*command, "kind", options->kind, kKinds, "What to make",
                       "moon|fractal|terraces|spikes|checkerboard|random")
        ->required();
    command->add_option("-o,--outfile", options->outfile, "Map to write: .png, .pgm, .tif or .tiff")
        ->type_name("FILE")
        ->required();
    command->add_option("--size", options->size, "Texels across and down; default: 2048,1024")
        ->type_size(2)
        ->expected(1)
        ->delimiter(',')
        ->type_name("W,H");
    command->add_option("--seed", options->seed, "Another seed makes another map; default: 1")->type_name("N");
    command->add_flag("--json", options->json, "Print what was made as JSON");
    command->add_flag("--quiet", options->quiet, "Print errors only");
    addProgressOption(*command, options->progress);
    command->callback([options, &action] { action = [options] { return runGenerate(*options); }; });
}

}  // namespace dsphere::cli
