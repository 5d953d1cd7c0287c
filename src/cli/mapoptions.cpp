#include "cli/mapoptions.h"

#include "base/error.h"
#include "cli/commands.h"
#include "scene/parameters.h"

#include <cmath>

namespace dsphere::cli {

namespace {

const char* const kGroup = "For a map in place of a scene (a scene file says these itself)";

/// An option that takes a number of `range`, as the scene's parameter of that name does.
void addNumber(CLI::App& command, const std::string& name, std::optional<double>& value, const Range& range,
               const std::string& help, const std::string& word, bool or_nan = false) {
    const auto read = [&value, name, range, or_nan](const std::string& given) {
        double number = 0.0;
        if (!CLI::detail::lexical_cast(given, number))
            throw CLI::ValidationError(name, fmt::format("'{}' is not a number", given));
        if (!std::isfinite(number) && !(or_nan && std::isnan(number)))
            throw CLI::ValidationError(name, fmt::format("'{}' is not a finite number", given));
        if (std::isfinite(number) && !range.holds(number))
            throw CLI::ValidationError(name, fmt::format("{} is not {}", given, range.text()));
        value = number;
    };
    command.add_option_function<std::string>(name, read, help)->type_name(word)->group(kGroup);
}

}  // namespace

void addMapOptions(CLI::App& command, MapOptions& options) {
    addNumber(command, "--nodata", options.nodata, kStoredValue, "The stored value that means unknown", "X|nan", true);
    addNumber(command, "--lonorigin", options.longitude_origin, kLongitudeOrigin,
              "Longitude of the map's left edge, in degrees", "DEG");
    addChoice<std::optional<Registration>>(
        command, "--registration", options.registration,
        {{"texel", Registration::Texel}, {"gridline", Registration::Gridline}},
        "Whether values are means of texels or stand on lines of longitude and latitude", "texel|gridline")
        ->group(kGroup);
    addNumber(command, "--radius", options.radius, kPositive, "Radius of the sphere; default: 1", "X");
    addNumber(command, "--maxdispl", options.max_displacement, kAnyNumber,
              "Displacement of the greatest height, in percent of the radius; default: 5", "PERCENT");
    addNumber(command, "--heightscale", options.height_scale, kAnyNumber,
              "Instead of --maxdispl, for true scale: units of the radius for each stored unit", "X");
    addNumber(command, "--midlevel", options.midlevel, kAnyNumber,
              "The height that leaves the sphere as it is: a share of the range, with --heightscale a stored value",
              "X");
    addNumber(command, "--heightmin", options.height_min, kAnyNumber,
              "The stored value that is not displaced; default: the map's least", "X");
    addNumber(command, "--heightmax", options.height_max, kAnyNumber,
              "The stored value that --maxdispl is of; default: the map's greatest", "X");
    addChoice<std::optional<Filter>>(command, "--filter", options.filter,
                                     {{"bilinear", Filter::Bilinear}, {"bspline", Filter::BSpline}},
                                     "How heights run between the map's values", "bilinear|bspline")
        ->group(kGroup);
    addNumber(command, "--blur", options.blur, kBlur, "Sigma of a Gaussian over the map, in texels", "SIGMA");
    command.add_option("--band", options.band, "Which band of a file with several, from 1")
        ->check(CLI::Range(1, kMostBands).description(""))
        ->type_name("N")
        ->group(kGroup);
}

void requireNone(const MapOptions& options, const std::string& scene) {
    const auto refuse = [&](const auto& value, const char* name) {
        if (value)
            throwUsage("--{} is for a map in place of a scene; {} says it itself, as {} of its Shape", name, scene,
                       name);
    };
    refuse(options.nodata, "nodata");
    refuse(options.longitude_origin, "lonorigin");
    refuse(options.registration, "registration");
    refuse(options.radius, "radius");
    refuse(options.max_displacement, "maxdispl");
    refuse(options.height_scale, "heightscale");
    refuse(options.midlevel, "midlevel");
    refuse(options.height_min, "heightmin");
    refuse(options.height_max, "heightmax");
    refuse(options.filter, "filter");
    refuse(options.blur, "blur");
    refuse(options.band, "band");
}

void applyTo(DisplacedSphere& sphere, const MapOptions& options) {
    if (options.max_displacement && options.height_scale)
        throwUsage("--maxdispl and --heightscale exclude each other: give one");
    if (options.height_min && options.height_min == options.height_max) throwUsage("--heightmin equals --heightmax");
    const auto take = [](auto& value, const auto& option) {
        if (option) value = *option;
    };
    take(sphere.nodata, options.nodata);
    take(sphere.longitude_origin, options.longitude_origin);
    take(sphere.registration, options.registration);
    take(sphere.radius, options.radius);
    take(sphere.max_displacement, options.max_displacement);
    take(sphere.height_scale, options.height_scale);
    take(sphere.midlevel, options.midlevel);
    take(sphere.height_min, options.height_min);
    take(sphere.height_max, options.height_max);
    take(sphere.filter, options.filter);
    take(sphere.blur, options.blur);
    take(sphere.band, options.band);
    // Who says how high heights are drawn means that, and no exaggeration that suits the map.
    if (options.max_displacement || options.height_scale || options.midlevel || options.height_min ||
        options.height_max)
        sphere.true_scale = false;
}

void applyTo(Scene& scene, const MapOptions& options) {
    auto& planet = std::get<DisplacedSphere>(scene.shapes[0].geometry);
    const double radius = planet.radius;
    applyTo(planet, options);
    dmat4 world_from_camera = glm::inverse(scene.camera.camera_from_world);
    world_from_camera[3] = dvec4(dvec3(world_from_camera[3]) * (planet.radius / radius), 1.0);
    scene.camera.camera_from_world = glm::inverse(world_from_camera);
}

}  // namespace dsphere::cli
