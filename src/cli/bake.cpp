#include "query/bake.h"

#include "base/error.h"
#include "cli/commands.h"
#include "cli/outputs.h"
#include "cli/print.h"
#include "cli/sceneoptions.h"
#include "cli/signals.h"
#include "image/greymap.h"
#include "image/picture.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace dsphere::cli {

namespace {

struct BakeCommand {
    CommonOptions common;
    SceneOptions scene;
    std::string outfile;
    std::vector<std::string> quantities, suns;
    std::vector<double> bounds;
    int samples = 64, azimuths = 8;
    double horizon_bound = 0.01;
};

double numberOf(const std::string& word, const std::string& whole) {
    double value = 0.0;
    if (!CLI::detail::lexical_cast(word, value) || !std::isfinite(value))
        throwUsage("--sun {}: '{}' is no number; expected LON,LAT[,DISTANCE[,RADIUS]]", whole, word);
    return value;
}

query::Sun sunOf(const std::string& text) {
    const std::vector<std::string> words = CLI::detail::split(text, ',');
    if (words.size() < 2 || words.size() > 4)
        throwUsage("--sun {}: expected LON,LAT[,DISTANCE[,RADIUS]], degrees and R", text);
    query::Sun sun{.longitude = numberOf(words[0], text), .latitude = numberOf(words[1], text)};
    if (words.size() > 2 && words[2] != "inf") sun.distance = numberOf(words[2], text);
    if (words.size() > 3) sun.radius = numberOf(words[3], text);
    if (std::abs(sun.latitude) > 90.0) throwUsage("--sun {}: a latitude is -90 to 90 degrees", text);
    if (sun.distance && !(*sun.distance > 1.0)) throwUsage("--sun {}: a distance is above 1 R", text);
    if (!(sun.radius >= 0.0 && sun.radius < 90.0)) throwUsage("--sun {}: a radius is 0 to 90 degrees", text);
    return sun;
}

query::BakeGrid gridOf(const BakeCommand& options, const Scene& scene, const SceneMaps& maps) {
    query::BakeGrid grid;
    const Heightmap* map = maps.perShape()[query::bodyOf(scene)];
    if (map && !map->ripples) {
        grid.width = map->width;
        grid.height = map->registration == Registration::Gridline ? map->height - 1 : map->height;
        grid.west = map->longitude_origin;
        grid.east = map->longitude_origin + 360.0;
    }
    if (!options.scene.resolution.empty()) {
        grid.width = options.scene.resolution[0];
        grid.height = options.scene.resolution[1];
    }
    if (grid.width < 2 && options.scene.resolution.empty())
        throwUsage("--resolution: the body has no map to take it from");
    if (!options.bounds.empty()) {
        grid.west = options.bounds[0];
        grid.east = options.bounds[1];
        grid.south = options.bounds[2];
        grid.north = options.bounds[3];
    }
    if (grid.width < 1 || grid.height < 1 || grid.width > 65536 || grid.height > 65536)
        throwUsage("--resolution: {}x{} is outside 1 to 65536", grid.width, grid.height);
    const bool sound = grid.west < grid.east && grid.east <= grid.west + 360.0 && grid.south >= -90.0 &&
                       grid.south < grid.north && grid.north <= 90.0;
    if (!sound)
        throwUsage("--bounds: {},{},{},{}: expected W < E <= W + 360 and -90 <= S < N <= 90", grid.west, grid.east,
                   grid.south, grid.north);
    return grid;
}

/// A plane of the result. low and high: what 0 and 65535 mean in a PNG; NaN: the plane's own range.
struct Layer {
    std::string name;
    std::vector<float> values;
    float low = 0.0f, high = 1.0f;
};

constexpr float kOwnRange = std::numeric_limits<float>::quiet_NaN();

const std::vector<std::string> kQuantities = {"lit", "normal", "slope", "aspect", "height", "sky", "horizon"};

// "lit", or "lit.3" of several.
std::string layerName(const std::string& quantity, std::size_t k, std::size_t count) {
    return count == 1 ? quantity : fmt::format("{}.{:0{}}", quantity, k, fmt::formatted_size("{}", count - 1));
}

void bakeQuantity(std::vector<Layer>& layers, query::Baker& baker, const BakeCommand& options,
                  const std::string& quantity) {
    if (quantity == "height") layers.push_back({"height", baker.height(), kOwnRange, kOwnRange});
    if (quantity == "slope") layers.push_back({"slope", baker.slope(), 0.0f, 90.0f});
    if (quantity == "aspect") layers.push_back({"aspect", baker.aspect(), 0.0f, 360.0f});
    if (quantity == "sky") layers.push_back({"sky", baker.sky(options.samples)});
    for (int axis = 0; quantity == "normal" && axis < 3; ++axis)
        layers.push_back({fmt::format("normal.{}", "XYZ"[axis]), baker.normal(axis), -1.0f, 1.0f});
    for (std::size_t k = 0; quantity == "lit" && k < options.suns.size(); ++k)
        layers.push_back(
            {layerName("lit", k, options.suns.size()), baker.lit(sunOf(options.suns[k]), options.samples)});
    const auto azimuths = std::size_t(options.azimuths);
    for (std::size_t k = 0; quantity == "horizon" && k < azimuths; ++k)
        layers.push_back({layerName("horizon", k, azimuths),
                          baker.horizon(360.0 * double(k) / options.azimuths, options.horizon_bound), -90.0f, 90.0f});
}

void writePlane(const std::string& path, const query::BakeGrid& grid, Layer& layer, bool quiet) {
    if (std::isnan(layer.low)) {
        const auto [least, greatest] = std::ranges::minmax_element(layer.values);
        layer.low = *least;
        layer.high = *greatest > *least ? *greatest : *least + 1.0f;
    }
    const auto level = [&](float value) {
        const float share = (value - layer.low) / (layer.high - layer.low);
        return std::isnan(share) ? std::uint16_t(0)
                                 : std::uint16_t(std::lround(65535.0f * std::clamp(share, 0.0f, 1.0f)));
    };
    const auto fillRow = [&](int j, std::span<std::uint16_t> row) {
        const float* values = layer.values.data() + std::size_t(j) * row.size();
        std::transform(values, values + row.size(), row.begin(), level);
    };
    writeGreyMap(path, grid.width, grid.height, fillRow, [](double) { return caughtSignal() == 0; });
    if (!quiet) printErr("{}: {} from {} (0) to {} (65535)\n", path, layer.name, layer.low, layer.high);
}

void writeLayers(const std::string& path, const query::BakeGrid& grid, std::vector<Layer>& layers, bool quiet) {
    if (std::filesystem::path(path).extension() != ".exr") {
        writePlane(path, grid, layers[0], quiet);
        return;
    }
    const Box box{0, 0, grid.width, grid.height};
    Image image{box, box, {}};
    for (Layer& layer : layers) image.channels.push_back({layer.name, std::move(layer.values)});
    writeExr(path, image,
             {{"west", float(grid.west)},
              {"east", float(grid.east)},
              {"south", float(grid.south)},
              {"north", float(grid.north)}});
}

void checkCommand(const BakeCommand& options) {
    for (const std::string& quantity : options.quantities)
        if (std::ranges::find(kQuantities, quantity) == kQuantities.end())
            throwUsage("--quantities: unknown '{}', expected some of {}", quantity, fmt::join(kQuantities, ","));
    const auto wants = [&](const char* name) { return std::ranges::count(options.quantities, name); };
    for (const std::string& quantity : options.quantities)
        if (wants(quantity.c_str()) > 1) throwUsage("--quantities: '{}' stands twice", quantity);
    if (wants("lit") && options.suns.empty()) throwUsage("--quantities lit: needs a --sun LON,LAT");
    for (const std::string& sun : options.suns) sunOf(sun);
    const std::string ending = std::filesystem::path(options.outfile).extension().string();
    if (ending != ".exr" && ending != ".png")
        throwUsage("{}: expected a name that ends in .exr or .png", options.outfile);
    const bool one = options.quantities.size() == 1 && !wants("normal") && !(wants("lit") && options.suns.size() > 1) &&
                     !(wants("horizon") && options.azimuths > 1);
    if (ending == ".png" && !one) throwUsage("{}: a PNG holds one plane; write an EXR", options.outfile);
}

int runBake(const BakeCommand& options) {
    checkCommand(options);
    SceneOptions for_scene = options.scene;
    for_scene.resolution.clear();
    const Scene scene = loadScene(for_scene);
    checkOutputs({{options.outfile, "the map"}}, inputsOf(scene));
    const SceneMaps maps = loadSceneMaps(scene);
    if (!options.common.quiet) printNotices(scene.notices), printNotices(maps.notices());
    const query::BakeGrid grid = gridOf(options, scene, maps);
    const PackedScene packed = packScene(scene, maps);
    gpu::Device device = openDevice(options.common);
    const DeviceScene device_scene(device, packed);
    std::vector<Layer> layers;
    const auto start = std::chrono::steady_clock::now();
    std::uint64_t rays = 0;
    {
        ProgressLine line(options.common.progress, options.common.quiet, "bake");
        const Progress progress = [&](double share) { return line.update(share); };
        query::Baker baker(device, scene, maps, packed, device_scene, grid, progress);
        for (const std::string& quantity : options.quantities) bakeQuantity(layers, baker, options, quantity);
        rays = baker.rays();
    }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    checkValidation(device);
    writeLayers(options.outfile, grid, layers, options.common.quiet);
    if (!options.common.quiet) printErr("{} texels, {} rays in {:.2f} s\n", grid.count(), rays, seconds);
    return int(ExitCode::Ok);
}

}  // namespace

void addBake(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("bake", "Make maps of what holds at the surface: light, slopes, horizons");
    auto options = std::make_shared<BakeCommand>();
    command->add_option("scene", options->scene.scene, "Scene file (.pbrt), or - for standard input; or a heightmap")
        ->required();
    command->add_option("-o,--outfile", options->outfile, "Map to write: .exr, or .png of 16 bits for one plane")
        ->type_name("FILE")
        ->required();
    command->add_option("--quantities", options->quantities, "Some of lit,normal,slope,aspect,height,sky,horizon")
        ->delimiter(',')
        ->type_name("LIST")
        ->required();
    command->add_option("--resolution", options->scene.resolution, "Texels; default: the heightmap's")
        ->type_size(2)
        ->expected(1)
        ->delimiter(',')
        ->type_name("W,H");
    command->add_option("--bounds", options->bounds, "Degrees of the edges; default: the heightmap's")
        ->type_size(4)
        ->expected(1)
        ->delimiter(',')
        ->type_name("W,E,S,N");
    command
        ->add_option(
            "--sun", options->suns,
            "lit: a light above that place, degrees; its distance from the centre in R (or inf), and the radius "
            "of its disc in degrees. May stand several times: one plane each")
        ->type_name("LON,LAT[,DIST[,RADIUS]]")
        ->take_all()
        ->allow_extra_args(false);
    command->add_option("--samples", options->samples, "lit: of a sun's disc; sky: of the half space; default 64")
        ->check(CLI::Range(1, 65536))
        ->type_name("N");
    command->add_option("--azimuths", options->azimuths, "horizon: one plane each, clockwise from north; default 8")
        ->check(CLI::Range(1, 360))
        ->type_name("K");
    command->add_option("--horizon-bound", options->horizon_bound, "horizon: right to so many degrees; default 0.01")
        ->check(CLI::Range(1e-5, 45.0))
        ->type_name("DEGREES");
    command->add_option("--exaggeration", options->scene.exaggeration, "Multiply all displacements")->type_name("X");
    addCommonOptions(*command, options->common);
    command->callback([options, &action] { action = [options] { return runBake(*options); }; });
}

}  // namespace dsphere::cli
