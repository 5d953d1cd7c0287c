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

}  // namespace

dvec2 App::share(const dvec2& cursor) const {
    return cursor / dvec2(std::max(1, window_.width()), std::max(1, window_.height()));
}

bool App::onDivider(const dvec2& cursor) const {
    return view_.split && std::abs(cursor.x - view_.divider * window_.width()) < kDividerReach * scale_;
}

std::optional<dvec3> App::pointUnder(const dvec2& cursor) {
    syncCamera();
    std::optional<Pick> pick = stage_->pick(share(cursor));
    if (!pick) return {};
    return pick->point;
}

// Whether the cursor is over a panel. ImGui knows of the place that it last laid a frame out with.
bool App::onPanel() {
    const ImVec2 known = ImGui::GetIO().MousePos;
    const bool moved = known.x != float(window_.cursor().x) || known.y != float(window_.cursor().y);
    if (moved && window_.visible()) {
        layOutFrame();
        applyUi();
    }
    return ImGui::GetIO().WantCaptureMouse;
}

void App::handle(const Event& event) {
    switch (event.kind) {
        case Event::Press:
            if (stage_ && !onPanel()) press(event);
            break;
        case Event::Release:
        case Event::LoseFocus:
            if (event.kind == Event::LoseFocus) held_.clear();
            if (drag_ != Drag::None) schedule_.settle();
            drag_ = Drag::None;
            break;
        case Event::Move:
            if (drag_ != Drag::None && stage_) move(event);
            break;
        case Event::Scroll:
            if (stage_ && !onPanel()) scroll(event);
            break;
        case Event::KeyDown:
            if (!ImGui::GetIO().WantTextInput)
                key(event);
            else if (event.code >= 0)
                typed_.push_back(event.code);
            break;
        case Event::KeyUp:
            held_.erase(event.code);
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
    if (drag_ != Drag::None) return;
    grabbed_cursor_ = event.cursor;
    const bool left = event.code == GLFW_MOUSE_BUTTON_LEFT;
    if (left && onDivider(event.cursor)) {
        drag_ = Drag::Divider;
        return;
    }
    if (left && held_.contains(GLFW_KEY_L)) {
        if (std::optional<SunAngles> sun = sunAngles()) {
            grabbed_sun_ = *sun;
            drag_ = Drag::Sun;
        } else {
            say("The scene has no distant light to move.");
        }
        return;
    }
    if (left && !event.shift && !event.control)
        drag_ = Drag::Orbit;
    else if (event.code == GLFW_MOUSE_BUTTON_RIGHT || (left && event.shift))
        drag_ = Drag::Pan;
    else if (event.code == GLFW_MOUSE_BUTTON_MIDDLE || (left && event.control))
        drag_ = Drag::Tilt;
    if (drag_ != Drag::None) control_->grab(event.cursor, pointUnder(event.cursor));
}

void App::move(const Event& event) {
    switch (drag_) {
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
            view_.divider = std::clamp(share(event.cursor).x, 0.02, 0.98);
            viewChanged(true);
            return;
        case Drag::None:
            return;
    }
    camera_is_new_ = true;
    viewChanged(true);
}

// Half a turn a window, as the camera sees it: rightward drags move the sun to the right.
void App::turnSun(const dvec2& cursor) {
    dvec2 moved = (cursor - grabbed_cursor_) * (180.0 / std::min(window_.width(), window_.height()));
    Pose pose = Pose::of(control_->camera());
    const Globe& globe = stage_->document().globe();
    double east = glm::dot(glm::cross(globe.north(), -pose.ahead), pose.right) >= 0.0 ? 1.0 : -1.0;
    SunAngles angles = grabbed_sun_;
    angles.longitude = std::remainder(angles.longitude + east * moved.x, 360.0);
    angles.latitude = std::clamp(angles.latitude - moved.y, -90.0, 90.0);
    setSun(angles);
}

void App::scroll(const Event& event) {
    std::optional<dvec3> hit = pointUnder(event.cursor);
    control_->zoom(event.cursor, hit, event.steps);
    camera_is_new_ = true;
    viewChanged(true);
}

// What is open in the window goes first.
void App::escape() {
    if (ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel))
        ui_.let_go = true;
    else if (ui_.keys_open)
        ui_.keys_open = false;
    else
        runCommand(Command::Close);
}

void App::key(const Event& event) {
    const int code = event.code;
    if (event.control) {
        if (code == GLFW_KEY_C) runCommand(Command::CopyCamera);
        if (code == GLFW_KEY_S) runCommand(Command::SaveScene);
        return;
    }
    held_.insert(code);
    if (code == GLFW_KEY_ESCAPE) escape();
    if (code == GLFW_KEY_H || code == GLFW_KEY_SLASH || code == GLFW_KEY_F1) ui_.keys_open = !ui_.keys_open;
    if (code == GLFW_KEY_TAB) ui_.panel_open = !ui_.panel_open;
    if (!stage_) return;
    if (code == GLFW_KEY_F12) runCommand(Command::Screenshot);
    if (code == GLFW_KEY_R || code == GLFW_KEY_ENTER || code == GLFW_KEY_KP_ENTER) runCommand(Command::Reset);
    for (int digit : {1, 3, 7, 9}) {
        if (code != GLFW_KEY_0 + digit && code != GLFW_KEY_KP_0 + digit) continue;
        control_->axisView(digit);
        camera_is_new_ = true;
        viewChanged(false);
    }
    if (code == GLFW_KEY_M) {
        int next = (int(view_.method.marcher) + 1) % 4;
        if (view_.split && Marcher(next) == Marcher::Naive) ++next;  // that is the left half already
        view_.method.marcher = Marcher(next);
        viewChanged(false);
    }
    if (code == GLFW_KEY_X) {
        view_.split = !view_.split;
        viewChanged(false);
    }
    if (code == GLFW_KEY_V) {
        view_.show = Show((int(view_.show) + (event.shift ? kShowCount - 1 : 1)) % kShowCount);
        viewChanged(false);
    }
}

void App::resize() {
    presenter_.resize(window_.width(), window_.height());
    frames_due_ = std::max(frames_due_, 3);
    if (!control_ || !window_.visible()) return;
    control_->resize(window_.width(), window_.height());
    camera_is_new_ = true;
    viewChanged(true);
}

bool App::flyStep(double seconds) {
    if (!stage_) return false;
    auto pair = [&](int plus, int minus) { return double(held_.contains(plus)) - double(held_.contains(minus)); };
    dvec3 along(pair(GLFW_KEY_D, GLFW_KEY_A), pair(GLFW_KEY_E, GLFW_KEY_Q), pair(GLFW_KEY_W, GLFW_KEY_S));
    if (along == dvec3(0.0)) return false;
    if (window_.isDown(GLFW_KEY_LEFT_SHIFT) || window_.isDown(GLFW_KEY_RIGHT_SHIFT)) along *= kFaster;
    control_->fly(along, seconds);
    camera_is_new_ = true;
    viewChanged(true);
    return true;
}

}  // namespace dsphere::viewer
