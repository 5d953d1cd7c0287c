// Between what is chosen and the panels.

#include <imgui.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <vector>

#include <glm/gtc/type_ptr.hpp>

#include "viewer/app.h"
#include "viewer/degrees.h"
#include "viewer/displayworld.h"

namespace dsphere::viewer {

namespace {

constexpr double kLongSample = 0.5;  // seconds after which a progress is shown

}  // namespace

State App::state() const {
    State state = chosen_;
    if (!control_) return state;
    state.camera = control_->camera();
    state.target = control_->target();
    return state;
}

// What differs in the scene is followed by the next turn of the loop.
void App::adopt(const State& wanted) {
    const State present = state();
    if (wanted.recorded != present.recorded) restoreKeys(wanted.recorded);
    const bool view_changed = !(wanted.view == present.view), tone_changed = !(wanted.tone == present.tone);
    chosen_ = wanted;
    control_->setTarget(std::min(wanted.target, stage_->document().bodies->count() - 1));
    if (!(wanted.camera == present.camera)) {
        control_->setCamera(wanted.camera);
        cameraMoved(false);
    }
    if (view_changed) viewChanged(false);
    // What is shown is recoloured without a ray.
    if (tone_changed && !view_changed) recolour();
    frames_due_ = std::max(frames_due_, 2);
}

// Shaders of its own, which take long to make, trace the cursor's ray: not before there is a picture, nor for a
// stand-in.
std::string App::hoverText() {
    if (!stage_ || stage_->document().stand_in || !drawn_ || !begun_ || hand_.drag != Hand::Drag::None ||
        loader_.packing() || !window_.cursorWithin())
        return {};
    const dvec2 place = share(window_.cursor());
    if (place.x >= 1.0 || place.y >= 1.0) return {};
    std::optional<Pick> pick = stage_->pick(place);
    if (!pick) return {};
    const Document& document = stage_->document();
    const std::size_t shape = std::size_t(pick->shape);
    const Globe& globe = (*document.bodies)[shape];
    std::string text;
    if (document.scene.shapes.size() > 1) text = shapeName(document.scene, shape) + "   ";
    if (globe.round()) {
        const Place at = globe.placeOf(pick->point);
        text += degreesText(at.latitude, "NS", 4) + "  " + degreesText(at.longitude, "EW", 4) + "   ";
        const HeightUnit unit = heightUnitOf(document, shape);
        if (at.stored)
            text += fmt::format("height {}{:.6g}{}   ", document.maps.coarse ? "about " : "", unit.of(*at.stored),
                                unit.name.empty() ? " map units" : " " + unit.name);
    }
    return text + "distance " + lengthUnitOf(document, globe, shape).text(pick->distance);
}

void App::fillFigures(Figures& figures) const {
    const Document& document = stage_->document();
    const std::size_t target = control_->target();
    figures.target_samples = targetSamples();
    figures.moving = schedule_.draft();
    figures.gauges = gaugesOf(*control_, document, area()[0], area()[1]);
    figures.range = shown_range_;
    figures.height_unit = heightUnitOf(document, target).name;
    figures.ramp.reset();
    const auto* ramp = textureAs<HeightRamp>(document.scene.shapes[target].material);
    const Relief& relief = document.maps.reliefs[target];
    if (ramp && control_->globe().solid() && relief.h_scale != 0.0) {
        const HeightUnit unit = heightUnitOf(document, target);
        const auto heightOf = [&](double h) { return unit.of((h - relief.h_offset) / relief.h_scale); };
        figures.ramp = {ramp->ramp, unit.name, heightOf(0.0), heightOf(1.0)};
    }
    figures.screenshot_waits = screenshot_.has_value();
    figures.sample_share = -1.0;
    if (!begun_) return;
    const bool first = !schedule_.draft() && stage_->film().samples() == 0;
    if (first && draft_seconds_ > kLongSample) figures.sample_share = stage_->film().share();
    figures.samples = schedule_.draft() ? 0 : stage_->film().samples();
    figures.width = stage_->film().width();
    figures.height = stage_->film().height();
    const double seconds = stage_->film().sampleSeconds();
    figures.rays_per_second = seconds > 0.0 ? double(figures.width) * figures.height / seconds : 0.0;
}

void App::fillUi() {
    ui_.subject = {state(), nullptr, nullptr};
    fillLeaving();
    ui_.has_picture = presenter_.hasPicture();
    const bool starting = !stage_ && !loader_.busy() && wanted_path_.empty();
    if (starting && !ui_.starting) ui_.recent = recent_.list();
    ui_.starting = starting;
    Figures& figures = ui_.figures;
    figures.u = presenter_.u();
    figures.v = presenter_.v();
    figures.busy = loader_.doing();
    figures.busy_share = loader_.share();
    figures.busy_seconds = window_.now() - busy_since_;
    figures.device = renders_.info().name;
    figures.frame_seconds = frame_seconds_;
    figures.file = std::filesystem::path(stage_ ? stage_->document().path : loader_.path()).filename().string();
    if (!stage_) return;
    ui_.subject.original = &stage_->document().original;
    ui_.subject.globe = &control_->globe();
    fillFigures(figures);
}

void App::applyUi() {
    const Command command = std::exchange(ui_.command, Command::None);
    if (stage_ && !(ui_.subject.state == state())) adopt(ui_.subject.state);
    if (command != Command::None) runCommand(command);
    applyDialogs();
    fitView();
}

void App::applyDialogs() {
    if (const std::string path = std::exchange(ui_.path.chosen, {}); !path.empty()) {
        ui_.path.open = false;
        open(path);
    }
    if (!std::exchange(ui_.go_to.go, false) || !stage_ || !control_->globe().round()) return;
    ui_.go_to.open = false;
    const double unit = lengthUnitOf(stage_->document(), control_->globe(), control_->target()).per_world;
    flyTo(control_->poseAbove(std::clamp(ui_.go_to.latitude, -90.0, 90.0), ui_.go_to.longitude,
                              std::max(ui_.go_to.altitude, 0.0) / unit));
}

void App::noteState(nlohmann::json& line) const {
    const State now = state();
    line["marcher"] = int(now.view.method.marcher);
    line["detail"] = now.view.method.detail;
    line["split"] = now.view.split;
    line["divider"] = now.view.divider;
    line["value"] = int(now.view.show);
    if (!stage_) return;
    const dvec3 eye = Pose::of(now.camera).eye;
    const ShapeEdits& edits = now.edits.shapes[now.target];
    const auto* relief = std::get_if<DisplacedSphere>(&stage_->document().original.shapes[now.target].geometry);
    line["altitude"] = control_->altitude();
    const double* numbers = glm::value_ptr(now.camera.camera_from_world);
    line["camera"] = std::vector<double>(numbers, numbers + 16);
    const Gauges gauges = gaugesOf(*control_, stage_->document(), area()[0], area()[1]);
    line["north"] = {gauges.north.x, gauges.north.y};
    line["night_light"] = now.edits.night_light;
    line["exposure"] = now.tone.exposure;
    if (const DistantLight* sun = sunOf(stage_->document().scene)) {
        const SunAngles angles = anglesOf(control_->globe(), sun->direction);
        line["sun"] = {angles.latitude, angles.longitude};
    }
    line["target_shape"] = now.target;
    line["exaggeration"] = edits.exaggeration;
    line["filter"] = int(edits.filter.value_or(relief ? relief->filter : Filter::Bilinear));
    if (control_->globe().round() && eye != control_->globe().centre()) {
        const Place place = control_->globe().placeOf(eye);
        line["eye"] = {place.latitude, place.longitude};
    }
}

void App::note(bool shown) {
    const bool settled = !stage_ || (published_ && schedule_.current());
    const double latency = shown ? latency_.shown(window_.now(), settled) : -1.0;
    if (!journal_.on()) return;
    const Figures& figures = ui_.figures;
    const dvec2 at = share(window_.cursor());
    nlohmann::json line = {{"time", window_.now()},
                           {"shown", shown},
                           {"file", figures.file},
                           {"busy", !figures.busy.empty()},
                           {"samples", figures.samples},
                           {"target", figures.target_samples},
                           {"draft", schedule_.draft()},
                           {"film", {figures.width, figures.height}},
                           {"window", {window_.width(), window_.height()}},
                           {"picture", pictureSize()},
                           {"has_picture", ui_.has_picture},
                           {"stand_in", stage_ && stage_->document().stand_in},
                           {"coarse", stage_ && stage_->document().maps.coarse},
                           {"busy_share", figures.busy_share},
                           {"shadows", !stage_ || !begun_ || stage_->shadows()},
                           {"frame_ms", 1e3 * frame_seconds_},
                           {"draw_ms", 1e3 * draw_seconds_},
                           {"latency_ms", latency < 0.0 ? -1.0 : 1e3 * latency},
                           {"render_ms", 1e3 * draft_seconds_},
                           {"device_ms", stage_ && begun_ ? 1e3 * stage_->film().sampleSeconds() : 0.0},
                           {"panel", ui_.panel_open},
                           {"keys", ui_.keys_open},
                           {"docked", ui_.docked},
                           {"starting", ui_.starting},
                           {"path_box", ui_.path.open},
                           {"go_to", ui_.go_to.open},
                           {"flying", flight_.has_value()},
                           {"playing", playing_ ? playing_->frame : -1},
                           {"asks", ui_.leaving.asked},
                           {"waits", screenshot_.has_value()},
                           {"hover", figures.hover},
                           {"message", ui_.message.text},
                           {"error", ui_.message.kind == Message::Kind::Error},
                           {"cursor", {at.x, at.y}},
                           {"scale", scale_},
                           {"capture", ImGui::GetIO().WantCaptureMouse},
                           {"typing", ImGui::GetIO().WantTextInput}};
    noteState(line);
    for (const auto& [label, place] : ui_.places) line["places"][label] = place;
    journal_.write(line);
}

}  // namespace dsphere::viewer
