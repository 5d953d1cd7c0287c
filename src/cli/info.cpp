#include "base/error.h"
#include "cli/commands.h"
#include "cli/describe.h"
#include "cli/print.h"
#include "cli/sceneoptions.h"
#include "image/rawmap.h"
#include "scene/parser.h"
#include "surface/bounds.h"
#include "surface/scenemaps.h"

#include <bit>
#include <cmath>

namespace dsphere::cli {

namespace {

const char* nameOf(Registration registration) {
    return registration == Registration::Texel ? "texel" : "gridline";
}

constexpr std::uint64_t kHeightBytes = 4, kSplineBytes = 16;  // a node

// Of a node of the map's grid on the device, by what the shapes with that map read of it.
std::uint64_t bytesPerNode(const SceneMaps& maps, int map) {
    bool heights = false, spline = false;
    for (std::size_t k = 0; k < maps.map_of_shape.size(); ++k) {
        if (maps.map_of_shape[k] != map) continue;
        const Relief& relief = maps.reliefs[k];
        heights = heights || relief.filter == Filter::Bilinear;
        spline = spline || relief.filter == Filter::BSpline || relief.smooth_normals;
    }
    return (heights ? kHeightBytes : 0) + (spline ? kSplineBytes : 0);
}

// What the marcher reads of a map: its nodes, the bounds of one relief (six faces of a cube and their pyramids), and
// two rows of edge directions.
void addDevice(Json& json, const NodeGrid& nodes, std::uint64_t node_bytes) {
    std::uint64_t side = std::uint64_t(boundsSide(nodes.width()));
    bool ripples = nodes.map().ripples.has_value();
    std::uint64_t node_count = ripples ? 0 : std::uint64_t(nodes.width()) * std::uint64_t(nodes.rows() + 1);
    std::uint64_t edges = (ripples ? 4 : 2) * std::uint64_t(std::max(nodes.width(), nodes.rows()));
    json["bounds"] = {{"side", side}, {"levels", std::bit_width(side)}, {"bytes", 4 * 9 * side * side}};
    json["device_bytes"] = node_bytes * node_count + 4 * 9 * side * side + 16 * edges;
}

// A texel by its place in the file and on the planet, degrees.
Json placeOf(const RawMap& map, std::size_t index, double longitude_origin) {
    std::size_t i = index % std::size_t(map.width), j = index / std::size_t(map.width);
    double shift = map.gridline ? 0.0 : 0.5;
    double steps = map.gridline ? std::max(map.height - 1, 1) : map.height;
    double longitude = longitude_origin + (double(i) + shift) * 360.0 / map.width;
    return {{"value", map.samples[index]},
            {"column", i},
            {"row", j},
            {"latitude", 90.0 - (double(j) + shift) * 180.0 / steps},
            {"longitude", longitude - 360.0 * std::floor((longitude + 180.0) / 360.0)}};
}

Json describeSamples(const RawMap& map, double longitude_origin) {
    std::size_t least = map.samples.size(), greatest = least, finite = 0;
    double sum = 0.0;
    for (std::size_t k = 0; k < map.samples.size(); ++k) {
        float value = map.samples[k];
        if (!std::isfinite(value)) continue;
        ++finite;
        sum += double(value);
        if (least == map.samples.size() || value < map.samples[least]) least = k;
        if (greatest == map.samples.size() || value > map.samples[greatest]) greatest = k;
    }
    Json json = {{"least", nullptr}, {"greatest", nullptr}, {"mean", nullptr}};
    if (finite > 0)
        json = {{"least", placeOf(map, least, longitude_origin)},
                {"greatest", placeOf(map, greatest, longitude_origin)},
                {"mean", sum / double(finite)}};
    json["non_finite_texels"] = map.samples.size() - finite;
    return json;
}

Json describeMapFile(const std::string& path) {
    RawMap map = readRawMap(path);
    double longitude_origin = map.longitude_origin.value_or(-180.0);
    Json json = {{"map", path}, {"type", map.type}, {"width", map.width}, {"height", map.height}};
    json.update(describeSamples(map, longitude_origin));
    json["full_scale"] = map.full_scale;
    json["registration"] = nameOf(map.gridline ? Registration::Gridline : Registration::Texel);
    json["longitude_origin"] = longitude_origin;
    // Their values do not matter to the nodes' number, which is what is asked here.
    std::replace_if(
        map.samples.begin(), map.samples.end(), [](float value) { return !std::isfinite(value); }, 0.0f);
    DisplacedSphere shape;
    shape.map_path = path;
    const Heightmap heightmap = makeHeightmap(std::move(map), shape);
    addDevice(json, NodeGrid(heightmap), kHeightBytes);
    return json;
}

Json describeMap(const SceneMaps& maps, int index) {
    const Heightmap& map = *maps.maps[std::size_t(index)];
    Json json = {{"path", map.path.empty() ? Json(nullptr) : Json(map.path)},
                 {"type", map.type},
                 {"width", map.width},
                 {"height", map.height},
                 {"least", map.least},
                 {"greatest", map.greatest},
                 {"nodata_texels", map.nodata_count},
                 {"registration", nameOf(map.registration)},
                 {"longitude_origin", map.longitude_origin}};
    addDevice(json, NodeGrid(map), bytesPerNode(maps, index));
    return json;
}

// A word a texel for 8-bit codes, three for floats; the table of the codes' light comes once for all.
Json describeImage(const ColourMap& image) {
    std::uint64_t words =
        std::uint64_t(image.width()) * std::uint64_t(image.height()) * (image.raw().srgb.empty() ? 3 : 1);
    return {{"path", image.path()},
            {"type", image.raw().type},
            {"width", image.width()},
            {"height", image.height()},
            {"device_bytes", 4 * words}};
}

Json describeSceneFile(const std::string& path) {
    Scene scene = parseSceneFile(path);
    SceneMaps maps = loadSceneMaps(scene);
    Json json = {{"scene", scene.name},
                 {"film",
                  {{"filename", scene.film.filename},
                   {"resolution", {scene.film.width, scene.film.height}},
                   {"crop", scene.film.crop},
                   {"pixel_samples", scene.sampler.pixel_samples}}},
                 {"integrator", describeIntegrator(scene.integrator)},
                 {"pixel_filter", describePixelFilter(scene.pixel_filter)},
                 {"camera", describeCamera(scene.camera)},
                 {"shapes", Json::array()},
                 {"maps", Json::array()},
                 {"images", Json::array()},
                 {"lights", Json::array()}};
    for (std::size_t k = 0; k < scene.shapes.size(); ++k) json["shapes"].push_back(describeShape(scene, maps, k));
    for (int k = 0; k < int(maps.maps.size()); ++k) json["maps"].push_back(describeMap(maps, k));
    for (const auto& image : maps.images) json["images"].push_back(describeImage(*image));
    for (const Light& light : scene.lights) json["lights"].push_back(describeLight(light, maps));
    return json;
}

std::string plainText(const Json& value) {
    if (value.is_string()) return value.get<std::string>();
    if (value.is_null()) return "none";
    if (value.is_number_float()) return fmt::format("{:.8g}", value.get<double>());
    return value.dump();
}

// The JSON as lines of "key value", parts indented, a list of numbers on one line.
void printLines(const Json& json, int indent) {
    for (const auto& [key, value] : json.items()) {
        std::string label = fmt::format("{:{}}{}", "", indent, key);
        std::replace(label.begin(), label.end(), '_', ' ');
        if (value.is_array() && !value.empty() && value[0].is_number()) {
            std::string line;
            for (const Json& item : value) line += plainText(item) + " ";
            print("{:<24}{}\n", label, line.substr(0, line.size() - 1));
        } else if (value.is_structured() && !value.empty()) {
            print("{}\n", label);
            printLines(value, indent + 2);
        } else {
            print("{:<24}{}\n", label, value.is_array() ? "none" : plainText(value));
        }
    }
}

// The map as a scene would show it of which these things are said.
Json describeShown(const std::string& path, const MapOptions& options) {
    SceneOptions shown;
    shown.scene = path;
    shown.map = options;
    const Scene scene = loadScene(shown);
    const SceneMaps maps = loadSceneMaps(scene);
    Json json = describeShape(scene, maps, 0);
    json["map"] = describeMap(maps, 0);
    return json;
}

int runInfo(const std::string& path, const MapOptions& options, bool as_json) {
    const bool is_map = isHeightmap(path);
    if (!is_map) requireNone(options, path);
    Json json = is_map ? describeMapFile(path) : describeSceneFile(path);
    if (is_map && options != MapOptions()) json["shown"] = describeShown(path, options);
    if (as_json)
        printText(jsonText(json));
    else
        printLines(json, 0);
    return int(ExitCode::Ok);
}

}  // namespace

void addInfo(CLI::App& app, Action& action) {
    CLI::App* command = app.add_subcommand("info", "Say what a scene or a map holds; needs no device");
    auto path = std::make_shared<std::string>();
    auto json = std::make_shared<bool>(false);
    command->add_option("file", *path, "Scene, or - for standard input, or map")->type_name("FILE")->required();
    auto options = std::make_shared<MapOptions>();
    command->add_flag("--json", *json, "Print as JSON");
    addMapOptions(*command, *options);
    command->callback(
        [path, options, json, &action] { action = [path, options, json] { return runInfo(*path, *options, *json); }; });
}

}  // namespace dsphere::cli
