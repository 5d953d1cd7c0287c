// What is chosen, and what is shown: files that are read, reliefs that are packed anew.

#include <cmath>
#include <filesystem>

#include <fmt/ranges.h>

#include "base/limits.h"
#include "viewer/app.h"

namespace dsphere::viewer {

// A file that is open already is read again, whatever name it goes by here: its changes stay.
void App::open(const std::string& path) {
    if (!stage_) return read(path);
    const std::string& present = stage_->document().path;
    std::error_code error;
    if (path == present || std::filesystem::equivalent(path, present, error)) return read(present);
    leave(path);
}

void App::read(const std::string& path) {
    if (ui_.message.stays()) ui_.message.text.clear();
    wanted_path_ = path;
}

// One piece of work at a time: the newest wish is what is done next. What only colours is done at once.
void App::follow() {
    if (loader_.packing()) return;
    Rework rework = Rework::Nothing;
    Scene wanted;
    const Levels levels =
        chosen_.view.method.detail > 0.0f ? Levels::All : (stage_ ? stage_->document().levels : Levels::Finest);
    const bool provisional = stage_ && stage_->document().provisional();
    if (stage_ && !provisional) {
        wanted = edited(stage_->document().original, chosen_.edits);
        rework = reworkBetween(stage_->document().scene, wanted);
    }
    if (rework == Rework::Look) {
        stage_->updateLook(wanted);
        shown_edits_ = chosen_.edits;
        viewChanged(true);
    }
    if (loader_.busy()) {
        if (!wanted_path_.empty()) loader_.cancel();
        return;
    }
    if (!wanted_path_.empty()) {
        const std::string path = std::exchange(wanted_path_, {});
        const bool same = stage_ && path == stage_->document().path;
        loader_.read(path, same ? std::optional(chosen_.edits) : std::nullopt, options_.exaggeration, levels);
    } else if (provisional && published_ && !incomplete_) {
        tried_edits_ = chosen_.edits;
        loader_.complete(stage_->document(), chosen_.edits, levels);
    } else if (rework == Rework::Reading || (stage_ && levels != stage_->document().levels)) {
        tried_edits_ = chosen_.edits;
        loader_.remake(stage_->document(), chosen_.edits, levels);
    } else if (rework == Rework::Relief) {
        tried_edits_ = chosen_.edits;
        loader_.retune(stage_->document(), wanted);
    } else {
        return;
    }
    busy_since_ = window_.now();
    frames_due_ = std::max(frames_due_, 1);
}

void App::finishWork() {
    const bool relief = loader_.packing();
    try {
        if (std::optional<Loaded> loaded = loader_.loaded()) show(std::move(*loaded));
        if (std::optional<PackedScene> packed = loader_.packed()) {
            stage_->updateRelief(std::move(*packed), loader_.packedScene());
            shown_edits_ = tried_edits_;
            takeBodies();
            display_.forget();
            begun_ = false;
            cameraMoved(true);
        }
    } catch (const Error& error) {
        if (error.code() == ExitCode::Interrupted) return;  // for a file that is read next
        const bool provisional = stage_ && stage_->document().provisional();
        const bool named = !options_.path.empty() && (!stage_ || stage_->document().path == options_.path);
        if (named && (!stage_ || provisional)) throw;
        if (!stage_) return say(error.what(), Message::Kind::Error);
        incomplete_ = provisional;
        if (relief)
            tellRefused(error);
        else
            say(error.what(), Message::Kind::Error);
        // Levels or images that could not be made must not be asked for again at once; what was chosen meanwhile may be
        // better. What changed on disk counts as seen, or the same error would come for ever.
        if (chosen_.edits == tried_edits_) chosen_.edits = shown_edits_;
        const bool no_levels = stage_->document().levels == Levels::Finest;
        if (no_levels) chosen_.view.method.detail = 0.0f;
        history_.amend([&](State& one) {
            if (one.edits == tried_edits_) one.edits = shown_edits_;
            if (no_levels) one.view.method.detail = 0.0f;
        });
    }
}

// Where the ground has risen past the eye, undo must not lead back into it.
void App::takeBodies() {
    const Camera before = control_->camera();
    const bool far = control_->setBodies(stage_->document().bodies);
    const Camera& now = control_->camera();
    history_.amend([&](State& one) {
        if (one.edits == shown_edits_ && one.camera == before) one.camera = now;
    });
    if (!far) return;
    const Globe& globe = control_->globe();
    const LengthUnit unit = lengthUnitOf(stage_->document(), globe, control_->target());
    say(fmt::format("The ground rose past the eye, which moved out to {} above it. Ctrl + Z goes back.",
                    unit.text(globe.clearance(control_->pose().eye))));
}

namespace {

/// Between which exaggerations of that sign the ground stays off the centre and within reach; nothing where the ground
/// that is shown does not tell.
std::string whatFits(const Document& document, std::size_t shape, const ShapeEdits& wanted, const ShapeEdits& shown) {
    const auto* sphere = std::get_if<DisplacedSphere>(&document.scene.shapes[shape].geometry);
    if (!sphere || shown.exaggeration == 0.0) return {};
    const Relief& relief = document.maps.reliefs[shape];
    const double sign = wanted.exaggeration < 0.0 ? -1.0 : 1.0, unit = sign / shown.exaggeration;
    const double one = unit * (relief.least_radius - sphere->radius),
                 other = unit * (relief.greatest_radius - sphere->radius);
    const double down = std::max(-std::min(one, other), 0.0), up = std::max(one, other);
    const double to_centre = sphere->radius / down, to_reach = (limits::kReach - 1.0) * sphere->radius / up;
    const double most = std::min(to_centre, up > 0.0 ? to_reach : to_centre);
    if (!std::isfinite(most)) return {};
    const double digits = std::pow(10.0, std::floor(std::log10(most)) - 3.0);
    return fmt::format("Its ground would {}. Up to {:.4g} fits, ",
                       most == to_centre ? "reach its centre" : "reach too far from it",
                       sign * std::floor(most / digits) * digits);
}

}  // namespace

void App::tellRefused(const Error& error) {
    for (std::size_t i = 0; i < tried_edits_.shapes.size(); ++i) {
        const ShapeEdits &wanted = tried_edits_.shapes[i], &shown = shown_edits_.shapes[i];
        if (wanted == shown) continue;
        const std::string name = shapeName(stage_->document().original, i);
        if (wanted.exaggeration != shown.exaggeration)
            return say(fmt::format("An exaggeration of {:.4g} is too much for the {}. {}{:.4g} stays.",
                                   wanted.exaggeration, name, whatFits(stage_->document(), i, wanted, shown),
                                   shown.exaggeration));
        return say(
            fmt::format("This zero level is too much for the {}: its ground would reach its centre. The last one "
                        "stays.",
                        name));
    }
    say(error.what());
}

// The same file again, changed on disk or with other images, keeps the camera; another one brings its own.
void App::show(Loaded loaded) {
    Document& document = *loaded.document;
    const bool same = stage_ && stage_->document().path == document.path;
    const bool completed = same && stage_->document().provisional();
    const bool notices_told = completed && !stage_->document().maps.coarse;
    const bool own_camera = !same || !(stage_->document().original.camera == document.original.camera);
    // Edits made while it was read stay too, unless those before them had to go.
    if (!same || !loaded.lost.empty())
        chosen_.edits = loaded.edits;
    else
        chosen_.edits = refit(chosen_.edits, document.original, options_.exaggeration, loaded.lost);
    if (same)
        history_.amend([&](State& one) {
            std::vector<std::string> told;
            one.edits = refit(one.edits, document.original, options_.exaggeration, told);
            one.target = std::min(one.target, document.original.shapes.size() - 1);
        });
    if (!same) {
        saved_edits_ = loaded.edits;
        chosen_.recorded.clear();
        playing_.reset();
    }
    watcher_.watch(document.files());
    auto stage = std::make_unique<Stage>(renders_, std::move(loaded.document), chosen_.view.method);
    presenter_.finish();
    display_.forget();
    stage_ = std::move(stage);
    incomplete_ = false;
    shown_edits_ = loaded.edits;
    const Document& now = stage_->document();
    Film film = now.scene.film;
    film.width = area()[0];
    film.height = area()[1];
    if (!same) chosen_.tone.exposure = 0.0f;
    if (own_camera)
        control_.emplace(now.original.camera, film, now.bodies, Globe::shapeOf(now.original));
    else
        takeBodies();
    window_.setTitle(std::filesystem::path(now.path).filename().string() + " - dsphere");
    if (!notices_told || !loaded.lost.empty()) {
        if (ui_.message.stays()) ui_.message.text.clear();
        tellNotices(loaded.lost);
    }
    if (!completed) {
        hand_.drag = Hand::Drag::None;
        flight_.reset();
    }
    begun_ = published_ = drawn_ = false;
    cameraMoved(now.provisional());  // coarse at first
    ui_.untouched.edits = noEdits(now.original, options_.exaggeration);
    fitted_area_ = area();
    if (same) return;
    recent_.add(now.path);
    history_.start(state());
    ui_.untouched = state();
}

void App::tellNotices(const std::vector<std::string>& lost) {
    const Document& document = stage_->document();
    Notices notices = document.original.notices;
    const Notices of_maps = document.maps.coarse ? Notices{} : document.maps.notices();  // of all of them, later
    notices.insert(notices.end(), of_maps.begin(), of_maps.end());
    std::vector<std::string> lines;
    bool warns = !lost.empty();
    if (!lost.empty()) lines.push_back(fmt::format("The file has changed. No longer fits: {}.", fmt::join(lost, "; ")));
    for (std::size_t i = 0; i < document.bodies->count(); ++i) {
        const Globe& globe = (*document.bodies)[i];
        if (!globe.solid() || globe.clearance(Pose::of(control_->camera()).eye) >= 0.0) continue;
        lines.push_back(fmt::format("The eye is inside the {}. Zoom out, or press 1.", shapeName(document.scene, i)));
        warns = true;
    }
    for (const Notice& notice : notices) {
        lines.push_back(notice.text);
        warns = warns || notice.kind == Notice::Kind::Warning;
    }
    if (!lines.empty())
        say(fmt::format("{}", fmt::join(lines, "\n")), warns ? Message::Kind::Warning : Message::Kind::Said);
}

void App::reloadIfChanged() {
    if (!stage_ || !watcher_.changed(window_.now())) return;
    open(stage_->document().path);
}

}  // namespace dsphere::viewer
