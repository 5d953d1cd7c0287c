#include "base/atomicfile.h"
#include "base/srgb.h"
#include "image/picture.h"
#include "viewer/app.h"
#include "viewer/scenewriter.h"

namespace dsphere::viewer {

namespace {

/// The codes of a picture as the light that writePng() encodes to the same codes.
Image decoded(const std::vector<std::uint32_t>& codes, int width, int height) {
    Image image{{0, 0, width, height}, {0, 0, width, height}, {}};
    const char* const names[] = {"R", "G", "B"};
    for (int c = 0; c < 3; ++c) {
        std::vector<float>& plane = image.addFloat(names[c]).floats();
        for (std::size_t i = 0; i < plane.size(); ++i)
            plane[i] = float(linearFromSrgb(double((codes[i] >> (8 * c)) & 0xffu) / 255.0));
    }
    return image;
}

/// With the range of heights said that the map itself had given.
Scene explicitScene(const Document& document) {
    Scene scene = document.scene;
    for (std::size_t i = 0; i < scene.shapes.size(); ++i) {
        auto* sphere = std::get_if<DisplacedSphere>(&scene.shapes[i].geometry);
        if (!sphere || !sphere->own_range) continue;
        const Heightmap& map = *document.maps.maps[std::size_t(document.maps.map_of_shape[i])];
        if (const std::optional<TrueScale> scale = trueScaleOf(*sphere, map)) {
            sphere->height_scale = scale->height_scale;
            sphere->midlevel = scale->midlevel;
        }
        if (!sphere->height_min) sphere->height_min = map.storedLeast();
        if (!sphere->height_max) sphere->height_max = map.ownTop();
        sphere->own_range = sphere->true_scale = false;
    }
    return scene;
}

/// ", heights of planet 2 times 3": those that are not the file's.
std::string exaggerations(const Document& document, const Edits& edits) {
    std::string text;
    for (std::size_t i = 0; i < edits.shapes.size(); ++i)
        if (const double times = edits.shapes[i].exaggeration; times != 1.0)
            text += fmt::format(", heights of the {} times {}", shapeName(document.original, i), times);
    return text;
}

}  // namespace

// NAME-1, NAME-2 ... in the working folder: the first that neither a picture nor a scene has, so that what a saved
// scene renders to is never there already.
std::string App::freeName() const {
    std::string stem = std::filesystem::path(stage_->document().path).stem().string();
    if (stem.empty() || stem == "-") stem = "scene";
    for (int n = 1;; ++n) {
        std::string name = fmt::format("{}-{}", stem, n);
        const auto is_free = [&](const char* extension) {
            std::error_code error;
            return !std::filesystem::exists(std::filesystem::symlink_status(name + extension, error));
        };
        if (is_free(".png") && is_free(".exr") && is_free(".pbrt")) return name;
    }
}

void App::takeScreenshot() {
    screenshot_.reset();
    try {
        const std::filesystem::path path = freeName() + ".png";
        ProgressiveFilm& film = stage_->film();
        if (chosen_.view.show == Show::Colour) {
            writePng(path, film.read(), {.exposure = double(chosen_.tone.exposure)});
        } else {
            publish();
            std::vector<std::uint32_t> codes(std::size_t(film.width()) * std::size_t(film.height()));
            display_.pixels().download(0, 4 * codes.size(), codes.data());
            writePng(path, decoded(codes, film.width(), film.height()));
        }
        options_.wrote(std::filesystem::current_path() / path);
        say(fmt::format("Wrote {}, {} sample{} a pixel, into {}", path.string(), film.samples(),
                        film.samples() == 1 ? "" : "s", std::filesystem::current_path().string()));
    } catch (const Error& error) {
        say(error.what(), Message::Kind::Error);
    }
}

void App::saveScene() {
    const std::filesystem::path path = freeName() + ".pbrt";
    Scene scene = explicitScene(stage_->document());
    scene.camera = control_->camera();
    scene.film.width = pictureSize()[0];
    scene.film.height = pictureSize()[1];
    scene.film.filename = path.stem().string() + ".png";
    scene.sampler.pixel_samples = pictureSamples();
    // What scene files have no word for.
    std::string options;
    if (chosen_.tone.exposure != 0.0f) options += fmt::format(" --exposure {}", chosen_.tone.exposure);
    if (chosen_.view.method.marcher != Marcher::Exact)
        options += fmt::format(" --marcher {}", kMarcherNames[int(chosen_.view.method.marcher)]);
    else if (chosen_.view.method.detail > 0.0f)
        options += fmt::format(" --detail {}", chosen_.view.method.detail);
    const std::string command = fmt::format("dsphere render {}{}", path.string(), options);
    AtomicFile file(path);
    const std::string text = fmt::format("# Saved by dsphere view from {}{}. Rendered as it was seen by\n#     {}\n{}",
                                         stage_->document().path, exaggerations(stage_->document(), shown_edits_),
                                         command, sceneText(scene, std::filesystem::current_path()));
    file.write(text.data(), text.size());
    file.commit();
    saved_edits_ = shown_edits_;
    options_.wrote(std::filesystem::current_path() / path);
    say(fmt::format("Wrote {} into {}\nTo render it: {}", path.string(), std::filesystem::current_path().string(),
                    command));
}

void App::copyCamera() {
    window_.copyText(cameraText(control_->camera()));
    say("The camera is on the clipboard, as pbrt text.");
}

}  // namespace dsphere::viewer
