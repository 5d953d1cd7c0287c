#include "base/limits.h"
#include "scene/directives.h"
#include "scene/shaperange.h"
#include "scene/transforms.h"

#include <cmath>

namespace dsphere {

namespace {

constexpr int kMaxInteger = std::numeric_limits<int>::max();
constexpr const char* kScalesPicture = "it would scale the picture; supported here: scale of the lights, --exposure";

// pbrt's rule: a crop keeps the pixels from ceil(from * size) to before ceil(to * size).
bool cropIsEmpty(double from, double to, int size) {
    return std::ceil(from * size) >= std::ceil(to * size);
}

Range exactly(double value) {
    return {value, value};
}

// A pinhole's shutter and focus show nothing, as long as nothing moves.
void ignoreLens(Parameters& p) {
    p.ignoreWithin("lensradius", exactly(0.0), "0, a pinhole");
    for (const char* name : {"focaldistance", "shutteropen", "shutterclose"}) p.ignore(name, {"float"});
}

// pbrt v3 may give half the angle.
void readFov(Camera& camera, Parameters& p) {
    const auto [least, greatest] = limits::kFov;
    const std::optional<double> fov = p.number("fov", {least, greatest});
    const std::optional<double> half = p.number("halffov", {0.5 * least, 0.5 * greatest});
    if (fov && half) p.attempt([&] { failAt(*p.placeOf("halffov"), "fov and halffov mean the same: give one"); });
    if (fov) camera.fov_degrees = *fov;
    if (half) camera.fov_degrees = 2.0 * *half;
}

}  // namespace

void requireOnce(Statement s) {
    auto [earlier, first] = s.state.given.emplace(s.word.text, s.word.where);
    if (!first) failAt(s.word.where, "{} is given twice, first at {}", s.word.text, earlier->second.text());
}

constexpr Range kWindow{-limits::kGreatestCoordinate, limits::kGreatestCoordinate};
constexpr Range kAspectRatio{1.0 / limits::kResolution, limits::kResolution};

void camera(Statement s) {
    requireOnce(s);
    auto [name, p] = readNamed(s, "camera", {"perspective", "orthographic"});
    Camera& camera = s.state.scene.camera;
    camera.projection = name.text == "orthographic" ? Projection::Orthographic : Projection::Perspective;
    camera.camera_from_world = s.state.attributes.ctm;
    if (!isInvertible(camera.camera_from_world)) failAt(s.word.where, "the camera's transform is singular");
    s.state.coordinate_systems["camera"] = glm::inverse(camera.camera_from_world);
    if (const auto fault = eyeOutOfRange(camera)) p.attempt([&] { failAt(s.word.where, "{}", *fault); });
    if (camera.projection == Projection::Perspective) readFov(camera, p);
    camera.screen_window = p.fourNumbers("screenwindow", kWindow);
    camera.frame_aspect_ratio = p.number("frameaspectratio", kAspectRatio);
    ignoreLens(p);
    p.finish();
    if (camera.screen_window && camera.frame_aspect_ratio)
        failAt(s.word.where, "screenwindow and frameaspectratio exclude each other: give one");
    if (!camera.screen_window) return;
    auto [x0, x1, y0, y1] = *camera.screen_window;
    if (!(x0 < x1 && y0 < y1))
        failAt(s.word.where, "screenwindow is empty; supported: [x0 x1 y0 y1], x0 < x1, y0 < y1");
}

namespace {

// What pbrt's films say of the sensor and of how the picture is stored.
void ignoreSensor(Parameters& p) {
    p.ignore("diagonal", {"float"});
    p.ignore("savefp16", {"bool"});
    p.ignoreWithin("scale", exactly(1.0), kScalesPicture);
    p.ignoreWithin("iso", exactly(100.0), kScalesPicture);
    p.ignoreWithin("exposuretime", exactly(1.0), kScalesPicture);
    p.ignoreWithin("imagingratio", exactly(1.0), kScalesPicture);
    p.ignoreWithin("whitebalance", exactly(0.0), "0, none");
    for (const char* name : {"maxsampleluminance", "maxcomponentvalue"})
        p.ignoreWithin(name, {1e5, kInfinity}, "at least 100000, as good as none; --clamp bounds samples");
    p.ignoreWord("sensor", {"cie1931"});
    p.ignoreWord("coordinatesystem", {"world"});
}

}  // namespace

void film(Statement s) {
    requireOnce(s);
    auto [name, p] = readNamed(s, "film", {"image", "rgb", "gbuffer"});
    Film& film = s.state.scene.film;
    if (auto filename = p.string("filename")) {
        if (filename->text.empty()) p.attempt([&] { failAt(filename->where, "the film's filename is empty"); });
        film.filename = filename->text;
    }
    film.width = p.integer("xresolution", 1, limits::kResolution).value_or(film.width);
    film.height = p.integer("yresolution", 1, limits::kResolution).value_or(film.height);
    film.crop = p.fourNumbers("cropwindow", kFraction).value_or(film.crop);
    ignoreSensor(p);
    p.finish();
    auto [x0, x1, y0, y1] = film.crop;
    if (cropIsEmpty(x0, x1, film.width) || cropIsEmpty(y0, y1, film.height))
        failAt(s.word.where,
               "cropwindow [{} {} {} {}] holds no pixel of {} x {}; supported: [x0 x1 y0 y1] within 0 to 1", x0, x1, y0,
               y1, film.width, film.height);
}

void sampler(Statement s) {
    requireOnce(s);
    auto [name, p] = readNamed(s, "sampler", {});
    Sampler& sampler = s.state.scene.sampler;
    const std::optional<int> samples = p.integer("pixelsamples", 1, limits::kPixelSamples);
    // The stratified sampler's.
    const std::optional<int> x = p.integer("xsamples", 1, 4096), y = p.integer("ysamples", 1, 4096);
    const std::optional<int> seed = p.integer("seed", 0, kMaxInteger);
    p.ignoreFlag("samplepixelcenter", false, "since samples spread over the pixel");
    p.ignore("dimensions", {"integer"});
    p.ignore("jitter", {"bool"});
    p.ignore("randomization", {"string"});
    p.finish();
    if (samples && (x || y)) failAt(s.word.where, "pixelsamples and xsamples times ysamples exclude each other");
    const int product = x.value_or(4) * y.value_or(4);
    if ((x || y) && product > limits::kPixelSamples)
        failAt(s.word.where, "xsamples times ysamples is {}; supported: at most {}", product, limits::kPixelSamples);
    sampler.pixel_samples = samples.value_or(x || y ? product : sampler.pixel_samples);
    sampler.seed = seed.value_or(s.state.default_seed.value_or(sampler.seed));
}

void integrator(Statement s) {
    requireOnce(s);
    auto [name, p] = readNamed(s, "integrator", {"directlighting", "path", "volpath"});
    Integrator& integrator = s.state.scene.integrator;
    // Without volumes volpath is path.
    integrator.kind = name.text == "directlighting" ? Integrator::Kind::DirectLighting : Integrator::Kind::Path;
    const std::optional<SourceLocation> where = p.placeOf("maxdepth");
    const int depth = p.integer("maxdepth", 0, kMaxInteger).value_or(integrator.max_depth);
    if (depth > limits::kMaxDepth)
        s.state.report.note(*where, "maxdepth",
                            fmt::format("{} counts as {}, the greatest one", depth, limits::kMaxDepth));
    integrator.max_depth = std::min(depth, limits::kMaxDepth);
    if (integrator.kind == Integrator::Kind::Path)
        integrator.regularize = p.boolean("regularize").value_or(integrator.regularize);
    // How pbrt spreads its rays: the mean of the samples stays.
    p.ignore("rrthreshold", {"float"});
    for (const char* name_of : {"lightsamplestrategy", "lightsampler", "strategy"}) p.ignore(name_of, {"string"});
    p.finish();
}

void accelerator(Statement s) {
    requireOnce(s);
    s.source.lexer.takeString("the accelerator");
    Parameters(s.source.lexer, "Accelerator", s.state.report).requireSound();
    s.state.report.note(s.word.where, "Accelerator", "changes nothing here");
}

void colorSpace(Statement s) {
    requireOneOf(s.source.lexer.takeString("a colour space"), "colour space", {"srgb"});
    s.state.report.note(s.word.where, "ColorSpace", "changes nothing here: it is the one that is used");
}

// pbrt v4: one parameter, without a name before it.
void option(Statement s) {
    Parameters p(s.source.lexer, "Option", s.state.report);
    const std::optional<int> seed = p.integer("seed", 0, kMaxInteger);
    p.ignoreFlag("disablepixeljitter", false, "since samples spread over the pixel");
    p.ignoreFlag("forcediffuse", false, "since materials are as they are said");
    for (const char* name : {"disabletexturefiltering", "disablewavelengthjitter", "pixelstats", "wavefront"})
        p.ignore(name, {"bool"});
    p.ignore("displacementedgescale", {"float"});
    for (const char* name : {"rendercoordsys", "msereferenceimage", "msereferenceout"}) p.ignore(name, {"string"});
    p.finish();
    if (!seed) return;
    s.state.default_seed = *seed;
    if (!s.state.given.contains("Sampler")) s.state.scene.sampler.seed = *seed;
}

}  // namespace dsphere
