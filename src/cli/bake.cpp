#include "query/bakelayers.h"

#include "base/error.h"
#include "cli/commands.h"
#include "cli/outputs.h"
#include "cli/print.h"
#include "cli/readmaps.h"
#include "cli/sceneoptions.h"
#include "cli/signals.h"
#include "geo/layerwriter.h"
#include "image/greymap.h"
#include "image/picture.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace dsphere::cli {

namespace {

struct BakeCommand {
    CommonOptions common;
    SceneOptions scene;
    std::string outfile;
    std::vector<std::string> quantities, suns;
    std::string suns_file;
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
    if (const std::string fault = query::faultOf(sun); !fault.empty()) throwUsage("--sun {}: {}", text, fault);
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

enum class Output { Exr, Png, GeoTiff };

Output outputOf(const std::string& name) {
    const std::string ending = extensionOf(name);
    if (ending == ".exr") return Output::Exr;
    if (ending == ".png") return Output::Png;
    if (ending == ".tif" || ending == ".tiff") return Output::GeoTiff;
    throwUsage("{}: expected a name that ends in .exr, .tif or .png", name);
}

void bakePng(const BakeCommand& options, const query::BakeGrid& grid, const query::Layer& layer) {
    const std::vector<float> plane = layer.make();
    float low = layer.low, high = layer.high;
    if (std::isnan(low)) {
        const auto [least, greatest] = std::ranges::minmax_element(plane);
        low = *least;
        high = *greatest > *least ? *greatest : *least + 1.0f;
    }
    const auto level = [&](float value) {
        const float share = (value - low) / (high - low);
        return std::isnan(share) ? std::uint16_t(0)
                                 : std::uint16_t(std::lround(65535.0f * std::clamp(share, 0.0f, 1.0f)));
    };
    const auto fillRow = [&](int j, std::span<std::uint16_t> row) {
        const float* values = plane.data() + std::size_t(j) * row.size();
        std::transform(values, values + row.size(), row.begin(), level);
    };
    writeGreyMap(options.outfile, grid.width, grid.height, fillRow, [](double) { return caughtSignal() == 0; });
    if (!options.common.quiet) printErr("{}: {} from {} (0) to {} (65535)\n", options.outfile, layer.name, low, high);
}

void bakeExr(const BakeCommand& options, const query::BakeGrid& grid, const std::vector<query::Layer>& layers) {
    const Box box{0, 0, grid.width, grid.height};
    Image image{box, box, {}};
    for (const query::Layer& layer : layers) image.channels.push_back({layer.name, layer.make()});
    writeExr(options.outfile, image,
             {{"west", float(grid.west)},
              {"east", float(grid.east)},
              {"south", float(grid.south)},
              {"north", float(grid.north)}});
}

void bakeGeoTiff(const BakeCommand& options, const query::BakeGrid& grid, const MapFacts& facts,
                 const std::vector<query::Layer>& layers) {
    std::vector<geo::LayerInfo> infos;
    for (const query::Layer& layer : layers) infos.push_back({layer.name, layer.unit, layer.scale, layer.offset});
    geo::LayerWriter writer(
        options.outfile, {grid.width, grid.height, grid.west, grid.east, grid.south, grid.north, facts.radius}, infos);
    for (const query::Layer& layer : layers) writer.write(layer.make());
    writer.commit();
}

query::BakeWishes wishesOf(const BakeCommand& options) {
    query::BakeWishes wishes{.quantities = options.quantities,
                             .samples = options.samples,
                             .azimuths = options.azimuths,
                             .horizon_bound = options.horizon_bound};
    const std::vector<std::string>& known = query::bakeQuantities();
    for (const std::string& quantity : options.quantities) {
        if (std::ranges::find(known, quantity) == known.end())
            throwUsage("--quantities: unknown '{}', expected some of {}", quantity, fmt::join(known, ","));
        if (std::ranges::count(options.quantities, quantity) > 1)
            throwUsage("--quantities: '{}' stands twice", quantity);
    }
    if (!options.suns.empty() && !options.suns_file.empty()) throwUsage("--suns: goes without --sun");
    for (const std::string& sun : options.suns) wishes.suns.push_back(sunOf(sun));
    if (!options.suns_file.empty()) wishes.suns = query::readSuns(options.suns_file);
    const bool lit = std::ranges::count(options.quantities, "lit") > 0;
    if (lit && wishes.suns.empty()) throwUsage("--quantities lit: needs a --sun LON,LAT, or --suns FILE.csv");
    if (!lit && !wishes.suns.empty()) throwUsage("--sun: is for --quantities lit");
    return wishes;
}

std::uint64_t bakeMap(const BakeCommand& options, const query::BakeWishes& wishes, const Scene& scene,
                      const SceneMaps& maps, const query::BakeGrid& grid) {
    const PackedScene packed = packScene(scene, maps);
    gpu::Device device = openDevice(options.common);
    const DeviceScene device_scene(device, packed);
    ProgressLine line(options.common.progress, options.common.quiet, "bake");
    const Progress progress = [&](double share) { return line.update(share); };
    query::Baker baker(device, scene, maps, packed, device_scene, grid, progress);
    const std::vector<query::Layer> layers = query::planLayers(baker, wishes);
    switch (outputOf(options.outfile)) {
        case Output::Exr:
            bakeExr(options, grid, layers);
            break;
        case Output::GeoTiff:
            bakeGeoTiff(options, grid, baker.facts(), layers);
            break;
        case Output::Png:
            if (layers.size() > 1)
                throwUsage("{}: a PNG holds one plane, not {}; write an EXR or a GeoTIFF", options.outfile,
                           layers.size());
            bakePng(options, grid, layers[0]);
    }
    checkValidation(device);
    return baker.rays();
}

int runBake(const BakeCommand& options) {
    outputOf(options.outfile);
    const query::BakeWishes wishes = wishesOf(options);
    SceneOptions for_scene = options.scene;
    for_scene.resolution.clear();
    const Scene scene = loadScene(for_scene);
    std::vector<NamedFile> inputs = inputsOf(scene);
    if (!options.suns_file.empty()) inputs.push_back({options.suns_file, "the suns"});
    checkOutputs({{options.outfile, "the map"}}, inputs);
    const SceneMaps maps = readMaps(scene, options.scene, options.common);
    if (!options.common.quiet) printNotices(scene.notices), printNotices(maps.notices());
    const query::BakeGrid grid = gridOf(options, scene, maps);
    const auto start = std::chrono::steady_clock::now();
    const std::uint64_t rays = bakeMap(options, wishes, scene, maps, grid);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (!options.common.quiet) printErr("{} texels, {} rays in {:.2f} s\n", grid.count(), rays, seconds);
    return int(ExitCode::Ok);
}

}  // namespace

void addBake(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("bake", "Make maps of what holds at the surface: light, slopes, horizons");
    auto options = std::make_shared<BakeCommand>();
    command->add_option("scene", options->scene.scene, "Scene file (.pbrt), or - for standard input; or a heightmap")
        ->required();
    command
        ->add_option("-o,--outfile", options->outfile,
                     "Map to write: .exr, a GeoTIFF .tif, or .png of 16 bits for one plane")
        ->type_name("FILE")
        ->required();
    command
        ->add_option("--quantities", options->quantities, "Some of lit,normal,slope,aspect,height,colour,sky,horizon")
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
    command
        ->add_option("--suns", options->suns_file,
                     "lit: a CSV file of suns, one plane each: columns lon,lat and if wanted distance,radius,name")
        ->type_name("FILE.csv");
    command
        ->add_option("--samples", options->samples,
                     "lit: of a sun's disc; sky: of the half space; colour: of lights with an extent; default 64")
        ->check(CLI::Range(1, 65536))
        ->type_name("N");
    command->add_option("--azimuths", options->azimuths, "horizon: one plane each, clockwise from north; default 8")
        ->check(CLI::Range(1, 360))
        ->type_name("K");
    command->add_option("--horizon-bound", options->horizon_bound, "horizon: right to so many degrees; default 0.01")
        ->check(CLI::Range(1e-5, 45.0))
        ->type_name("DEGREES");
    command->add_option("--exaggeration", options->scene.exaggeration, "Multiply all displacements")->type_name("X");
    addMapOptions(*command, options->scene.map);
    addCommonOptions(*command, options->common);
    command->callback([options, &action] { action = [options] { return runBake(*options); }; });
}

}  // namespace dsphere::cli
