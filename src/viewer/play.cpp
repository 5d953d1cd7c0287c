// Keys of the camera: recorded in a path file beside the scene, and played.

#include <cmath>

#define GLFW_INCLUDE_NONE
#include <volk.h>

#include <GLFW/glfw3.h>

#include "base/error.h"
#include "viewer/app.h"
#include "viewer/recordedpath.h"

namespace dsphere::viewer {

namespace {

std::string inWords(int keys) {
    return fmt::format("{} key{}", keys, keys == 1 ? "" : "s");
}

std::string whole(const std::filesystem::path& path) {
    std::error_code error;
    const std::filesystem::path absolute = std::filesystem::absolute(path, error);
    return error ? path.string() : absolute.lexically_normal().string();
}

std::string addedNote(const PathFile& file, const std::string& scene) {
    const int keys = file.keys.keys();
    const std::string note =
        fmt::format("Key {}, at frame {}, is in {}\n", keys, file.keys.lastFrame(), whole(file.path));
    if (keys == 1) return note + "Go to the next view and press K again.";
    return note + fmt::format("Shift + K plays it; dsphere render {} --path {} --frames 0-{} films it.", scene,
                              file.path.string(), std::floor(file.keys.lastFrame()));
}

}  // namespace

// Beside the scene or map. The samples lie in the cache folder, where nothing of the user's belongs.
PathFile App::pathFile() const {
    const std::filesystem::path scene = stage_->document().path;
    return findPathFile(isSample(scene.string()) ? std::filesystem::path() : scene.parent_path(),
                        scene.stem().string());
}

// The file is read anew each time, so that what was changed in it meanwhile stays. Undo takes the key back, and not the
// way to its view, however soon K was pressed.
void App::addKey() {
    const Scene& scene = stage_->document().original;
    const Camera& camera = control_->camera();
    PathFile file = pathFile();
    const int before = file.keys.keys();
    if (before > 0 && sameView(file.keys.at(scene, file.keys.lastFrame()), camera))
        return say(fmt::format("This view is the last key, {}, of {} already.", before, file.path.string()));
    const double distance = std::max(glm::length(control_->globe().centre() - control_->pose().eye), 1e-3);
    const std::string line = file.keys.lineOf(scene, camera, distance);
    file.keys = file.keys.with(line);
    writePathFile(file);
    history_.add(state());
    const bool first = chosen_.recorded.empty();
    chosen_.recorded.push_back(line);
    history_.add(state());
    std::string note = addedNote(file, stage_->document().path);
    if (first && before > 0) note += fmt::format("\nIt goes on from {} that the file had.", inWords(before));
    if (first && before == 0 && !file.passed_over.empty())
        note += fmt::format("\n{} holds something else and stays as it is.", file.passed_over.string());
    say(note);
}

// To the keys that undo or redo ask for: those at the end that differ leave the file or come back.
void App::restoreKeys(const std::vector<std::string>& wanted) {
    std::vector<std::string>& present = chosen_.recorded;
    const auto begins = [&] { return std::equal(present.begin(), present.end(), wanted.begin()); };
    while (present.size() > wanted.size() || !begins()) {
        PathFile file = pathFile();
        const int before = file.keys.keys();
        std::optional<RecordedPath> shorter = file.keys.without(present.back());
        if (!shorter) throwFailure("{} has changed: its last key is not the one to take back.", file.path.string());
        file.keys = std::move(*shorter);
        writePathFile(file);
        present.pop_back();
        say(fmt::format("Key {} is no longer in {}: {} left.", before, whole(file.path), inWords(before - 1)));
    }
    while (present.size() < wanted.size()) {
        PathFile file = pathFile();
        file.keys = file.keys.with(wanted[present.size()]);
        writePathFile(file);
        present.push_back(wanted[present.size()]);
        say(addedNote(file, stage_->document().path));
    }
}

void App::play() {
    PathFile file = pathFile();
    if (file.keys.keys() < 2) return say("K adds this view as a key of a path; two keys make one that can be played.");
    const int last = int(file.keys.lastFrame());
    say(fmt::format("{}: {}, frames 0 to {}. Any key or button stops.", file.path.filename().string(),
                    inWords(file.keys.keys()), last));
    playing_ = Playing{std::move(file.keys), window_.now()};
}

// Whole frames only: what `render --frames` makes of the same file.
void App::playStep() {
    const int last = int(playing_->keys.lastFrame());
    const double passed = RecordedPath::kRate * std::max(0.0, window_.now() - playing_->since);
    playing_->frame = int(std::min(std::floor(passed), double(last)));
    const bool over = playing_->frame == last;
    try {
        control_->setCamera(playing_->keys.at(stage_->document().original, playing_->frame));
    } catch (const Error& error) {
        stopPlaying();
        return say(error.what(), Message::Kind::Error);
    }
    cameraMoved(!over);
    if (over) playing_.reset();
}

void App::stopPlaying() {
    if (!playing_) return;
    playing_.reset();
    cameraMoved(false);
}

// True if the event means nothing else: Esc would close the window, and Shift + K play again.
bool App::endsPlaying(const Event& event) {
    if (!playing_) return false;
    const bool modifier = event.code >= GLFW_KEY_LEFT_SHIFT && event.code <= GLFW_KEY_RIGHT_SUPER;
    const bool key = event.kind == Event::KeyDown && !modifier;
    if (!key && event.kind != Event::Press && event.kind != Event::Scroll && event.kind != Event::Drop) return false;
    stopPlaying();
    const Command command = key ? commandOf(event) : Command::None;
    return command == Command::Escape || command == Command::PlayPath;
}

}  // namespace dsphere::viewer
