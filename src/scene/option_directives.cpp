#include "scene/directives.h"
#include "scene/transforms.h"

#include <cmath>

namespace dsphere {

namespace {

constexpr int kMaxResolution = 65536;  // pixels a side
constexpr int kMaxPixelSamples = 1 << 20;
constexpr int kMaxInteger = std::numeric_limits<int>::max();

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
    auto [name, p] = readNamed(s, "integrator", {"directlighting"});
    p.integer("maxdepth", 1, kMaxInteger);  // checked, and of no effect while no material reflects the scene
    p.finish();
}

}  // namespace dsphere
