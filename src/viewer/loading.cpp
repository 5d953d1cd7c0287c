#include <filesystem>

#include "viewer/app.h"

namespace dsphere::viewer {

void App::open(const std::string& path) {
    if (ui_.message_is_error) ui_.message.clear();
    wanted_path_ = path;
}

// One piece of work at a time: the newest wish is what is done next.
void App::startWork() {
    if (loading_.busy() || packing_.busy()) return;
    frames_due_ = std::max(frames_due_, wanted_path_.empty() && !wanted_scene_ ? 0 : 1);
    if (!wanted_path_.empty()) {
        loading_path_ = std::exchange(wanted_path_, {});
        loading_.start([open = options_.open, path = loading_path_] { return openDocument(open, path); });
    } else if (wanted_scene_) {
        loading_path_ = stage_->document().path;
        loading_.start([&old = stage_->document(), scene = *std::exchange(wanted_scene_, nullptr),
                        tuning = wanted_tuning_] { return remakeDocument(old, scene, tuning); });
    } else if (stage_ && !wanted_tuning_.fits(stage_->document().tuning)) {
        wanted_scene_ = std::make_unique<Scene>(stage_->document().scene);
        startWork();
    } else if (stage_ && wanted_tuning_ != stage_->document().tuning) {
        packing_tuning_ = wanted_tuning_;
        packing_.start([&document = stage_->document(), tuning = wanted_tuning_] { return retune(document, tuning); });
    }
}

void App::finishWork() {
    try {
        if (loading_.ready()) show(loading_.take());
        if (packing_.ready()) {
            PackedScene packed = packing_.take();
            stage_->updateRelief(std::move(packed), packing_tuning_);
            control_->setGlobe(stage_->document().globe());
            display_.forget();
            begun_ = look_changed_ = false;
            camera_is_new_ = true;
            viewChanged(true);
        }
    } catch (const Error& error) {
        if (!stage_) throw;
        wanted_tuning_ = stage_->document().tuning;
        // Levels that could not be made must not be asked for again at once.
        if (wanted_tuning_.levels == Levels::Finest) view_.method.detail = ui_.view.method.detail = 0.0f;
        say(error.what(), true);
        // What changed on disk counts as seen, or the same error would come for ever.
    }
    if (look_changed_ && !packing_.busy()) changeLook(true);
}

// The same file again, changed on disk or with other images, keeps the camera; another one brings its own.
void App::show(std::unique_ptr<Document> document) {
    const bool same = stage_ && stage_->document().path == document->path;
    const bool own_camera = !same || !(stage_->document().original.camera == document->original.camera);
    watcher_.watch(document->files());
    auto stage = std::make_unique<Stage>(renders_, std::move(document), view_.method);
    presenter_.finish();
    display_.forget();
    stage_ = std::move(stage);
    const Document& now = stage_->document();
    Film film = now.scene.film;
    film.width = std::max(1, window_.width());
    film.height = std::max(1, window_.height());
    if (!same) tone_.exposure = 0.0f;
    if (own_camera)
        control_.emplace(now.original.camera, film, now.globe());
    else
        control_->setGlobe(now.globe());
    wanted_tuning_ = now.tuning;
    window_.setTitle(std::filesystem::path(now.path).filename().string() + " - dsphere");
    if (ui_.message_is_error) ui_.message.clear();
    begun_ = look_changed_ = false;
    drag_ = Drag::None;
    camera_is_new_ = true;
    viewChanged(false);
}

void App::reloadIfChanged() {
    if (!stage_ || !watcher_.changed(window_.now())) return;
    open(stage_->document().path);
}

}  // namespace dsphere::viewer
