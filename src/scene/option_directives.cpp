#include "scene/directives.h"
#include "scene/transforms.h"

#include <cmath>

namespace dsphere {

namespace {

constexpr int kMaxResolution = 65536;  // pixels a side
constexpr int kMaxPixelSamples = 1 << 20;
constexpr int kMaxInteger = std::numeric_limits<int>::max();
constexpr Range kFilterRadius{0.01, 8.0};  // pixels
// The falloff stays within 0.001 to 1000, in both spellings.
constexpr Range kFilterAlpha{0.001, 1000.0}, kFilterSigma{0.03, 20.0};

// pbrt's rule: a crop keeps the pixels from ceil(from * size) to before ceil(to * size).
bool cropIsEmpty(double from, double to, int size) {
    return std::ceil(from * size) >= std::ceil(to * size);
}

void requireOnce(Statement s) {
    auto [earlier, first] = s.state.given.emplace(s.word.text, s.word.where);
    if (!first) failAt(s.word.where, "{} is given twice, first at {}", s.word.text, earlier->second.text());
}

}  // namespace

void camera(Statement s) {
    requireOnce(s);
    auto [name, p] = readNamed(s, "camera", {"perspective", "orthographic"});
    Camera& camera = s.state.scene.camera;
    camera.projection = name.text == "orthographic" ? Projection::Orthographic : Projection::Perspective;
    camera.camera_from_world = s.state.attributes.ctm;
    if (!isInvertible(camera.camera_from_world)) failAt(s.word.where, "the camera's transform is singular");
    if (camera.projection == Projection::Perspective)
        camera.fov_degrees = p.number("fov", {0.0, 180.0, true}).value_or(camera.fov_degrees);
    camera.screen_window = p.fourNumbers("screenwindow", kAnyNumber);
    camera.frame_aspect_ratio = p.number("frameaspectratio", kPositive);
    p.finish();
    if (camera.screen_window && camera.frame_aspect_ratio)
        failAt(s.word.where, "screenwindow and frameaspectratio exclude each other: give one");
    if (!camera.screen_window) return;
    auto [x0, x1, y0, y1] = *camera.screen_window;
    if (!(x0 < x1 && y0 < y1))
        failAt(s.word.where, "screenwindow is empty; supported: [x0 x1 y0 y1], x0 < x1, y0 < y1");
}

void film(Statement s) {
    requireOnce(s);
    auto [name, p] = readNamed(s, "film", {"image", "rgb", "gbuffer"});
    Film& film = s.state.scene.film;
    if (auto filename = p.string("filename")) {
        if (filename->text.empty()) failAt(filename->where, "the film's filename is empty");
        film.filename = filename->text;
    }
    film.width = p.integer("xresolution", 1, kMaxResolution).value_or(film.width);
    film.height = p.integer("yresolution", 1, kMaxResolution).value_or(film.height);
    film.crop = p.fourNumbers("cropwindow", kFraction).value_or(film.crop);
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
    sampler.pixel_samples = p.integer("pixelsamples", 1, kMaxPixelSamples).value_or(sampler.pixel_samples);
    sampler.seed = p.integer("seed", 0, kMaxInteger).value_or(sampler.seed);
    p.finish();
}

void integrator(Statement s) {
    requireOnce(s);
    auto [name, p] = readNamed(s, "integrator", {"directlighting", "path", "volpath"});
    Integrator& integrator = s.state.scene.integrator;
    // Without volumes volpath is path.
    integrator.kind = name.text == "directlighting" ? Integrator::Kind::DirectLighting : Integrator::Kind::Path;
    integrator.max_depth = p.integer("maxdepth", 0, kMaxInteger).value_or(integrator.max_depth);
    if (integrator.kind == Integrator::Kind::Path)
        integrator.regularize = p.boolean("regularize").value_or(integrator.regularize);
    p.finish();
}

namespace {

// v3 says xwidth for what v4 calls xradius; the two cannot be mixed, since their defaults differ.
struct FilterSpelling {
    std::optional<double> x, y;
    std::optional<SourceLocation> where;  // of the first parameter that is given, alpha and sigma included
    std::string_view word;                // that parameter
};

FilterSpelling spelled(Parameters& p, std::initializer_list<std::string_view> words) {
    FilterSpelling result;
    for (std::string_view word : words) {
        std::optional<SourceLocation> where = p.placeOf(word);
        if (where && !result.where) result.where = where, result.word = word;
    }
    result.x = p.number(words.begin()[0], kFilterRadius);
    result.y = p.number(words.begin()[1], kFilterRadius);
    return result;
}

}  // namespace

void pixelFilter(Statement s) {
    requireOnce(s);
    auto [name, p] = readNamed(s, "pixel filter", {"box", "gaussian"});
    const bool gaussian = name.text == "gaussian";
    FilterSpelling v3 = spelled(p, {"xwidth", "ywidth", "alpha"}), v4 = spelled(p, {"xradius", "yradius", "sigma"});
    std::optional<double> alpha, sigma;
    if (gaussian) alpha = p.number("alpha", kFilterAlpha), sigma = p.number("sigma", kFilterSigma);
    p.finish();
    if (v3.where && v4.where)
        failAt(*v4.where, "{} is pbrt v4's, and {} (at {}) is pbrt v3's: give one spelling", v4.word, v3.word,
               v3.where->text());
    PixelFilter& filter = s.state.scene.pixel_filter;
    filter.kind = gaussian ? PixelFilter::Kind::Gaussian : PixelFilter::Kind::Box;
    const double radius = !gaussian ? 0.5 : v3.where ? 2.0 : 1.5;
    filter.radius = v3.where ? dvec2(v3.x.value_or(radius), v3.y.value_or(radius))
                             : dvec2(v4.x.value_or(radius), v4.y.value_or(radius));
    if (alpha) filter.falloff = *alpha;
    if (sigma) filter.falloff = 1.0 / (2.0 * *sigma * *sigma);
}

}  // namespace dsphere
