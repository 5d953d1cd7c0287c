#include "base/error.h"
#include "cli/commands.h"
#include "cli/describe.h"
#include "cli/describemap.h"
#include "cli/print.h"
#include "cli/sceneoptions.h"
#include "scene/parser.h"
#include "surface/scenemaps.h"

#include <algorithm>

namespace dsphere::cli {

namespace {

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
    if (value.is_string()) return printable(value.get<std::string>());
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

int runInfo(const std::string& path, const MapOptions& options, bool scan, bool as_json) {
    const bool is_map = isHeightmap(path);
    if (!is_map) requireNone(options, path);
    if (!is_map && scan) throwUsage("--scan reads the texels of a map; {} is a scene", path);
    Json json = is_map ? describeMapFile(path, scan) : describeSceneFile(path);
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
    auto scan = std::make_shared<bool>(false);
    auto options = std::make_shared<MapOptions>();
    command->add_flag("--scan", *scan,
                      "Read all texels of a map of more than 67 million, too: least, greatest, mean and unknown ones");
    command->add_flag("--json", *json, "Print as JSON");
    addMapOptions(*command, *options);
    command->callback([=, &action] { action = [=] { return runInfo(*path, *options, *scan, *json); }; });
}

}  // namespace dsphere::cli
