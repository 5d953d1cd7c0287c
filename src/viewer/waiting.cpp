// What waits: a file to be written for what it holds to be shown, leaving a scene for the answer about its changes.

#include <filesystem>

#include "viewer/app.h"

namespace dsphere::viewer {

// To open a file, or to close the window if there is none: asks before changes are lost.
void App::leave(const std::string& file) {
    ui_.leaving = {stage_ && !(chosen_.edits == saved_edits_), file, {}, {}};
    frames_due_ = std::max(frames_due_, 2);
    if (!ui_.leaving.asked) return leaveNow();
    ui_.path.open = ui_.go_to.open = false;
}

void App::leaveNow() {
    const std::string file = ui_.leaving.file;
    dropWaiting();
    if (file.empty())
        closing_ = true;
    else
        read(file);
}

void App::dropWaiting() {
    ui_.leaving = {};
    screenshot_.reset();
    save_waits_ = leaves_then_ = false;
}

void App::fillLeaving() {
    Leaving& leaving = ui_.leaving;
    if (!leaving.asked) return;
    leaving.changes = inWords(chosen_.edits, saved_edits_);
    leaving.save_as = (std::filesystem::current_path() / (freeName() + ".pbrt")).string();
}

void App::wantSaved() {
    ui_.leaving.asked = false;
    if (incomplete_) return say("The scene cannot be saved: its map could not be read as a whole.");
    save_waits_ = true;
    if (stage_->document().maps.coarse) say("The scene is saved once the map is surveyed. Esc: not at all.");
}

void App::saveIfDue() {
    if (!save_waits_ || stage_->document().maps.coarse || !(chosen_.edits == shown_edits_)) return;
    save_waits_ = false;
    const bool leaves = std::exchange(leaves_then_, false);
    try {
        saveScene();
        if (leaves) leaveNow();
    } catch (const Error& error) {
        say(error.what(), Message::Kind::Error);
    }
}

// The second time it is taken at the next sample.
void App::wantScreenshot() {
    const Document& document = stage_->document();
    if (screenshot_)
        screenshot_->at_once = true;
    else
        screenshot_.emplace();
    if (document.maps.coarse) say("The screenshot is made once the map is surveyed.");
    const bool still = begun_ && !schedule_.draft() && schedule_.current() && !document.provisional();
    screenshot_->begun = still;
    if (still && stage_->film().between() && screenshotIsDue()) takeScreenshot();
}

bool App::screenshotIsDue() const {
    const int samples = stage_->film().samples();
    return screenshot_ && samples > 0 && (screenshot_->at_once || samples >= targetSamples()) && !schedule_.draft() &&
           !stage_->document().provisional();
}

// It is of the picture that was there when it was asked for, or of the next still one after a motion.
void App::screenshotBegins(bool draft) {
    if (!screenshot_) return;
    if (screenshot_->begun) {
        screenshot_.reset();
        return say("No screenshot was made: the picture has changed. F12 twice does not wait.");
    }
    screenshot_->begun = !draft && !stage_->document().provisional();
}

}  // namespace dsphere::viewer
