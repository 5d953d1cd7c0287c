#include <imgui.h>

#include <algorithm>

#include "viewer/ui.h"

namespace dsphere::viewer {

namespace {

constexpr float kMostWide = 22.0f, kLeastWide = 9.0f, kGap = 0.5f;  // of the font's size

/// Where a tip goes, and how wide its lines may be.
struct TipPlace {
    ImVec2 corner;
    float wrap;
};

// Beside the window of the control, so that no row is under it, or else below or above it.
TipPlace placeTip(const Ui& ui, const char* tip) {
    const float font = ImGui::GetFontSize(), gap = kGap * font;
    const ImVec2 screen = ImGui::GetIO().DisplaySize, pad = ImGui::GetStyle().WindowPadding;
    const float begin = ImGui::GetWindowPos().x, end = begin + ImGui::GetWindowWidth();
    const float left = begin - 2.0f * gap, right = screen.x - end - 2.0f * gap;
    const float beside = std::min(kMostWide * font, std::max(left, right) - 2.0f * pad.x);
    const bool fits = beside >= kLeastWide * font;
    const float wrap = fits ? beside : std::min(kMostWide * font, screen.x - 2.0f * (gap + pad.x));
    const ImVec2 text = ImGui::CalcTextSize(tip, nullptr, false, wrap);
    const float wide = text.x + 2.0f * pad.x, high = text.y + 2.0f * pad.y;
    const auto within = [gap](float at, float size, float most) {
        return std::max(std::min(at, most - size - gap), gap);
    };
    const ImVec2 item = ImGui::GetItemRectMin();
    if (fits) {
        const float x = left >= wide ? begin - gap - wide : end + gap;
        const float least = x < ui.message_end[0] ? ui.message_end[1] + gap : 0.0f;  // nor does it cover the message
        return {{x, within(std::max(item.y, least), high, screen.y)}, wrap};
    }
    const float top = ImGui::GetWindowPos().y, below = top + ImGui::GetWindowHeight() + gap;
    return {{within(item.x, wide, screen.x), below + high <= screen.y ? below : std::max(top - gap - high, gap)}, wrap};
}

}  // namespace

void showTip(Ui& ui, const char* tip) {
    if (!ImGui::IsItemHovered()) return;
    const TipPlace place = placeTip(ui, tip);
    ImGui::SetNextWindowPos(place.corner);
    ImGui::BeginTooltip();
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + place.wrap);
    ImGui::TextUnformatted(tip);
    ImGui::PopTextWrapPos();
    const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
    ui.places.emplace_back("Tip", std::array{low.x, low.y, low.x + size.x, low.y + size.y});
    ImGui::EndTooltip();
}

}  // namespace dsphere::viewer
