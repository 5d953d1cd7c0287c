#include <imgui.h>

#define GLFW_INCLUDE_NONE
#include <volk.h>

#include <GLFW/glfw3.h>

#include <algorithm>
#include <cmath>

#include "viewer/app.h"

namespace dsphere::viewer {

namespace {

constexpr double kDividerReach = 8.0;  // pixels at scale 1
constexpr double kFaster = 5.0;
constexpr double kDoubleClick = 0.4, kDoubleClickReach = 6.0;  // seconds; pixels at scale 1
constexpr double kNearer = 0.35;                               // of the height that a double click flies from

}  // namespace

bool App::onDivider(const dvec2& cursor) const {
    return chosen_.view.split && std::abs(cursor.x - chosen_.view.divider * area()[0]) < kDividerReach * scale_;
}

std::optional<Hit> App::hitUnder(const dvec2& cursor) {
    syncCamera();
    std::optional<Pick> pick = stage_->pick(share(cursor));
    if (!pick) return {};
    return Hit{pick->point, std::size_t(pick->shape)};
}

// Whether the cursor is over a panel. ImGui knows of the place that it last laid a frame out with.
bool App::onPanel(const dvec2& cursor) {
    cursor_ = cursor;
    const ImVec2 known = ImGui::GetIO().MousePos;
    const bool moved = known.x != float(cursor.x) || known.y != float(cursor.y);
    if (moved && window_.visible()) {
        layOutFrame();
        applyUi();
    }
    return ImGui::GetIO().WantCaptureMouse;
}

void App::handle(const Event& event) {
    if (hand_.needsFrame(event) && window_.visible()) {
        layOutFrame();
        applyUi();
    }
    cursor_ = event.cursor;
    if (endsPlaying(event)) return;
    switch (event.kind) {
        case Event::Press: {
            const bool panel = onPanel(event.cursor);
            hand_.tell(event);
            if (stage_ && !panel) press(event);
            break;
        }
        case Event::Release:
            if (hand_.drag == Hand::Drag::None) onPanel(event.cursor);  // a slider or a panel comes as far as this
            hand_.tell(event);
            release();
            // A second click that became a drag is one.
            if (std::exchange(second_click_, false) && stage_ &&
                glm::length(event.cursor - hand_.from) < kDoubleClickReach * scale_)
                flyToCursor(event.cursor);
            break;
        case Event::LoseFocus:
            hand_.letGo();
            second_click_ = false;
            release();
            break;
        case Event::Move:
            if (hand_.drag != Hand::Drag::None && stage_) move(event);
            break;
        case Event::Leave:
            frames_due_ = std::max(frames_due_, 1);
            break;
        case Event::Scroll:
            if (!onPanel(event.cursor)) {
                if (stage_) scroll(event);
            } else {
                hand_.tell(event);
            }
            break;
        case Event::KeyDown:
        case Event::Character: {
            // WantTextInput stays for one frame more than the field has the keys.
            const bool closes = event.kind == Event::KeyDown && event.code == GLFW_KEY_ESCAPE &&
                                (ui_.path.open || ui_.go_to.open);  // with what is typed there
            const bool typed = ImGui::GetIO().WantTextInput && ImGui::IsAnyItemActive() && !closes;
            if (typed || event.kind == Event::KeyDown) hand_.tell(event);
            if (event.kind == Event::KeyDown && !typed && (!event.repeated || repeats(commandOf(event)))) key(event);
            break;
        }
        case Event::KeyUp:
            hand_.tell(event);
            hand_.keys.erase(event.code);
            break;
        case Event::Drop:
            open(event.path);
            break;
        case Event::Resize:
            resize();
            break;
    }
}

void App::press(const Event& event) {
    using Drag = Hand::Drag;
    if (hand_.drag != Drag::None) return;
    flight_.reset();
    hand_.from = event.cursor;
    const bool left = event.code == GLFW_MOUSE_BUTTON_LEFT;
    second_click_ = isDoubleClick(event);
    if (left && onDivider(event.cursor)) {
        hand_.drag = Drag::Divider;
        return;
    }
    if (left && hand_.keys.contains(GLFW_KEY_L)) {
        if (const DistantLight* sun = sunOf(stage_->document().scene)) {
            hand_.sun = anglesOf(control_->globe(), sun->direction);
            hand_.drag = Drag::Sun;
        } else {
            say("The scene has no distant light to move.");
        }
        return;
    }
    if (left && !event.shift && !event.control)
        hand_.drag = Drag::Orbit;
    else if (event.code == GLFW_MOUSE_BUTTON_RIGHT || (left && event.shift))
        hand_.drag = Drag::Pan;
    else if (event.code == GLFW_MOUSE_BUTTON_MIDDLE || (left && event.control))
        hand_.drag = Drag::Tilt;
    if (hand_.drag != Drag::None) control_->grab(event.cursor, hitUnder(event.cursor));
}

void App::release() {
    if (hand_.drag != Hand::Drag::None) schedule_.settle();
    hand_.drag = Hand::Drag::None;
}

void App::move(const Event& event) {
    using Drag = Hand::Drag;
    switch (hand_.drag) {
        case Drag::Orbit:
            control_->orbitTo(event.cursor);
            break;
        case Drag::Pan:
            control_->panTo(event.cursor);
            break;
        case Drag::Tilt:
            control_->tiltTo(event.cursor);
            break;
        case Drag::Sun:
            turnSun(event.cursor);
            return;
        case Drag::Divider:
            chosen_.view.divider = std::clamp(share(event.cursor).x, 0.02, 0.98);
            viewChanged(true);
            return;
        case Drag::None:
            return;
    }
    cameraMoved(true);
}

// Half a turn a window, as the camera sees it: rightward drags move the sun to the right.
void App::turnSun(const dvec2& cursor) {
    const auto [width, height] = area();
    dvec2 moved = (cursor - hand_.from) * (180.0 / std::min(width, height));
    Pose pose = Pose::of(control_->camera());
    const Globe& globe = control_->globe();
    double east = glm::dot(glm::cross(globe.north(), -pose.ahead), pose.right) >= 0.0 ? 1.0 : -1.0;
    SunAngles angles = hand_.sun;
    angles.longitude = std::remainder(angles.longitude + east * moved.x, 360.0);
    angles.latitude = std::clamp(angles.latitude - moved.y, -90.0, 90.0);
    chosen_.edits.sun_direction = directionOf(globe, angles);
}

bool App::isDoubleClick(const Event& event) {
    if (event.code != GLFW_MOUSE_BUTTON_LEFT || event.shift || event.control || !hand_.keys.empty()) return false;
    const bool twice = window_.now() - last_click_ < kDoubleClick &&
                       glm::length(event.cursor - last_click_at_) < kDoubleClickReach * scale_;
    last_click_ = twice ? -1e9 : window_.now();
    last_click_at_ = event.cursor;
    return twice;
}

void App::flyTo(const Pose& pose) {
    flight_.emplace(control_->pose(), pose, control_->globe().centre(), window_.now());
}

void App::flyToCursor(const dvec2& cursor) {
    const std::optional<Hit> hit = hitUnder(cursor);
    if (!hit) return;
    control_->setTarget(hit->shape);
    const Globe& globe = control_->globe();
    const dvec3 eye = control_->pose().eye;
    if (!globe.round() || eye == globe.centre() || control_->camera().projection == Projection::Orthographic)
        return zoomAt(cursor, 6.0);
    const Place place = globe.placeOf(hit->point);
    flyTo(control_->poseAbove(place.latitude, place.longitude, kNearer * std::abs(globe.altitude(eye))));
}

void App::zoomAt(const dvec2& cursor, double steps) {
    const std::optional<Hit> hit = hitUnder(cursor);
    const Camera before = control_->camera();
    control_->zoom(cursor, hit ? std::optional(hit->point) : std::nullopt, steps);
    if (steps > 0.0 && control_->camera() == before)
        return say(fmt::format("As near as the eye comes to the ground: {:g} R above it.", CameraControl::kLowest));
    cameraMoved(true);
}

void App::scroll(const Event& event) {
    flight_.reset();
    zoomAt(event.cursor, event.steps);
}

void App::key(const Event& event) {
    flight_.reset();
    if (ui_.leaving.asked) {  // nothing else is done before the answer
        const Command command = commandOf(event);
        const bool enter = event.code == GLFW_KEY_ENTER || event.code == GLFW_KEY_KP_ENTER;
        if (enter || command == Command::Escape) runCommand(enter ? Command::SaveAndLeave : command);
        return;
    }
    if (!event.control) hand_.keys.insert(event.code);
    if (const Command command = commandOf(event); command != Command::None) runCommand(command);
}

void App::resize() {
    presenter_.resize(window_.width(), window_.height());
    frames_due_ = std::max(frames_due_, 3);
    fitView();
}

// To the part of the window that the picture has: less beside a docked panel.
void App::fitView() {
    if (!control_ || !window_.visible() || fitted_area_ == area()) return;
    fitted_area_ = area();
    control_->resize(fitted_area_[0], fitted_area_[1]);
    cameraMoved(true);
}

bool App::flyStep(double seconds) {
    if (!stage_) return false;
    if (playing_) {
        playStep();
        return true;
    }
    if (flight_) {
        control_->setPose(flight_->at(last_poll_));
        if (flight_->over(last_poll_)) flight_.reset();
        cameraMoved(flight_.has_value());
        return true;
    }
    const auto pair = [&](int plus, int minus) {
        return double(hand_.keys.contains(plus)) - double(hand_.keys.contains(minus));
    };
    dvec3 along(pair(GLFW_KEY_D, GLFW_KEY_A), pair(GLFW_KEY_E, GLFW_KEY_Q), pair(GLFW_KEY_W, GLFW_KEY_S));
    if (along == dvec3(0.0)) return false;
    if (window_.isDown(GLFW_KEY_LEFT_SHIFT) || window_.isDown(GLFW_KEY_RIGHT_SHIFT)) along *= kFaster;
    control_->fly(along, seconds);
    cameraMoved(true);
    return true;
}

}  // namespace dsphere::viewer
