#include "viewer/hand.h"

#include <imgui.h>

#define GLFW_INCLUDE_NONE
#include <volk.h>

#include <GLFW/glfw3.h>

#include <algorithm>
#include <iterator>
#include <limits>

namespace dsphere::viewer {

Hand::Pending Hand::kindOf(const Event& event) {
    switch (event.kind) {
        case Event::Press:
        case Event::Release:
            return Pending::Button;
        case Event::KeyDown:
        case Event::KeyUp:
            return Pending::Key;
        case Event::Character:
            return Pending::Text;
        case Event::Scroll:
            return Pending::Wheel;
        default:
            return Pending::Nothing;
    }
}

// ImGui 1.86 keeps one state of the mouse and the keys, and looks at it once a frame: a press is where the mouse is
// then.
bool Hand::needsFrame(const Event& event) const {
    const Pending kind = kindOf(event);
    if (pending_ == Pending::Nothing) return false;
    if (pending_ == Pending::Button && event.kind == Event::Move) return true;
    if (kind == Pending::Nothing) return false;
    if (pending_ == Pending::Button || kind == Pending::Button) return true;
    return ImGui::GetIO().WantTextInput && !(kind == Pending::Text && pending_ == Pending::Text);
}

void Hand::tell(const Event& event) {
    ImGuiIO& io = ImGui::GetIO();
    const bool down = event.kind == Event::Press || event.kind == Event::KeyDown;
    switch (kindOf(event)) {
        case Pending::Button:
            down ? (void)buttons_.insert(event.code) : (void)buttons_.erase(event.code);
            break;
        case Pending::Key:
            if (event.code < 0 || event.code >= int(std::size(io.KeysDown))) return;
            io.KeysDown[event.code] = down;
            io.KeyCtrl = io.KeysDown[GLFW_KEY_LEFT_CONTROL] || io.KeysDown[GLFW_KEY_RIGHT_CONTROL];
            io.KeyShift = io.KeysDown[GLFW_KEY_LEFT_SHIFT] || io.KeysDown[GLFW_KEY_RIGHT_SHIFT];
            io.KeyAlt = io.KeysDown[GLFW_KEY_LEFT_ALT] || io.KeysDown[GLFW_KEY_RIGHT_ALT];
            break;
        case Pending::Text:
            io.AddInputCharacter(unsigned(event.code));
            break;
        case Pending::Wheel:
            io.MouseWheel += float(event.steps);
            break;
        case Pending::Nothing:
            return;
    }
    pending_ = kindOf(event);
}

void Hand::letGo() {
    keys.clear();
    buttons_.clear();
    ImGuiIO& io = ImGui::GetIO();
    std::fill(std::begin(io.KeysDown), std::end(io.KeysDown), false);
    io.KeyCtrl = io.KeyShift = io.KeyAlt = false;
}

void Hand::prepare(const dvec2& cursor, bool within) {
    ImGuiIO& io = ImGui::GetIO();
    constexpr float kNowhere = -std::numeric_limits<float>::max();
    io.MousePos = within || anyButton() ? ImVec2(float(cursor.x), float(cursor.y)) : ImVec2(kNowhere, kNowhere);
    for (int button = 0; button < int(std::size(io.MouseDown)); ++button)
        io.MouseDown[button] = buttons_.contains(button);
}

}  // namespace dsphere::viewer
