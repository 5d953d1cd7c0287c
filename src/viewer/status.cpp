#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "viewer/overlay.h"
#include "viewer/ui.h"

namespace dsphere::viewer {

namespace {

// Whatever comes up, what is being typed goes on.
constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                                    ImGuiWindowFlags_NoFocusOnAppearing | ImGuiWindowFlags_NoBringToFrontOnFocus;

std::string progressText(const Figures& figures) {
    if (figures.target_samples == 0) return {};
    if (figures.moving)
        return fmt::format("{}x{}  {:.0f} frames/s", figures.width, figures.height,
                           figures.frame_seconds > 0.0 ? 1.0 / figures.frame_seconds : 0.0);
    return fmt::format("{}/{} samples", figures.samples, figures.target_samples);
}

float widthOf(const char* text) {
    return ImGui::CalcTextSize(text).x;
}

void drawLabel(ImVec2 at, const char* text, double scale) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    list.AddText(ImVec2(at.x + float(scale), at.y + float(scale)), IM_COL32(0, 0, 0, 220), text);
    list.AddText(at, IM_COL32(255, 255, 255, 235), text);
}

void drawDivider(const Ui& ui, int width, int height, double scale) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    float x = float(ui.subject.state.view.divider) * float(width), half = float(scale),
          bottom = float(height - statusHeight(scale));
    list.AddRectFilled(ImVec2(x - half, 0.0f), ImVec2(x + half, bottom), IM_COL32(255, 255, 255, 200));
    list.AddCircleFilled(ImVec2(x, 0.5f * bottom), 7.0f * half, IM_COL32(255, 255, 255, 230));
    float pad = 10.0f * half, top = pad;
    const char *left = "naive", *right = kMarcherNames[int(ui.subject.state.view.method.marcher)];
    drawLabel(ImVec2(x - pad - widthOf(left), top), left, scale);
    drawLabel(ImVec2(x + pad, top), right, scale);
}

/// What differs from the picture of `dsphere render`.
std::string modeText(const Ui& ui) {
    std::string text;
    if (ui.subject.state.view.method.marcher != Marcher::Exact && !ui.subject.state.view.split)
        text = std::string("   ") + kMarcherNames[int(ui.subject.state.view.method.marcher)];
    if (ui.subject.state.view.method.detail > 0.0f) text += "   detail";
    if (!ui.figures.busy.empty()) text += "   " + ui.figures.busy + " ...";
    if (ui.subject.state.view.show != Show::Colour)
        text += std::string("   ") + kShowNames[int(ui.subject.state.view.show)];
    return text;
}

}  // namespace

void drawStatusBar(Ui& ui, const Extent& window) {
    const int width = window.width, height = window.height;
    const double scale = window.scale;
    float bar = float(statusHeight(scale)), pad = 10.0f * float(scale);
    ImGui::SetNextWindowPos(ImVec2(0.0f, float(height) - bar));
    ImGui::SetNextWindowSize(ImVec2(float(width), bar));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(pad, 0.0f));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowRounding, 0.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0.0f);
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, ImVec2(1.0f, 1.0f));
    ImGui::Begin("status", nullptr, kFixed | ImGuiWindowFlags_NoScrollWithMouse);
    const ImGuiStyle& style = ImGui::GetStyle();
    const std::string progress = progressText(ui.figures) + modeText(ui);
    // Where there is no room for all, what the cursor points at goes before the buttons, and both before the rest.
    const float buttons =
        widthOf("Tab: panel") + widthOf("H: keys") + 4.0f * style.FramePadding.x + style.ItemSpacing.x;
    const float hover = ui.figures.hover.empty() ? 0.0f : widthOf(ui.figures.hover.c_str()) + 2.0f * pad;
    float room = float(width) - 2.0f * pad - hover;
    const auto fits = [&](float wide) {
        if (room < wide) return false;
        room -= wide + 2.0f * pad;
        return true;
    };
    const bool with_buttons = fits(buttons), with_progress = fits(widthOf(progress.c_str()));
    const bool with_file = fits(widthOf(ui.figures.file.c_str()));
    float left = pad;
    const auto place = [&](float x) {
        ImGui::SetCursorPos(ImVec2(x, 0.5f * (bar - ImGui::GetFrameHeight())));
        ImGui::AlignTextToFramePadding();
    };
    place(left);
    if (with_file) {
        ImGui::TextUnformatted(ui.figures.file.c_str());
        showTip(ui, "The file that is shown. Ctrl + O opens another.");
        left += widthOf(ui.figures.file.c_str()) + 2.0f * pad;
    }
    if (with_progress) {
        place(left);
        ImGui::TextDisabled("%s", progress.c_str());
        showTip(ui,
                "How many samples a pixel the picture has, of those that it will have; its size while the view moves.");
    }
    const float right = float(width) - pad - (with_buttons ? buttons + 2.0f * pad : 0.0f);
    if (hover > 0.0f) {
        place(std::max(pad, right - hover + 2.0f * pad));
        ImGui::TextUnformatted(ui.figures.hover.c_str());
        showTip(ui, "What is under the cursor.");
    }
    if (with_buttons) {
        place(float(width) - pad - buttons);
        if (ImGui::Button("Tab: panel")) ui.command = Command::Panel;
        showTip(ui, "All that can be changed: relief, light, colours, values.");
        ImGui::SameLine();
        if (ImGui::Button("H: keys")) ui.command = Command::Keys;
        showTip(ui, "What the mouse and every key do.");
    }
    ImGui::End();
    ImGui::PopStyleVar(4);
}

void drawMessage(Ui& ui, const Extent& window) {
    ui.message_end = {};
    if (ui.message.text.empty()) return;
    const float unit = float(window.scale), pad = 12.0f * unit, width = float(window.width);
    const float free = freeRight(ui, window, 0.0f) - 2.0f * pad, usual = std::max(0.6f * width, 420.0f * unit);
    const float wide = std::min(free > 200.0f * unit ? free : width - 2.0f * pad, usual);
    const float high = float(window.height - statusHeight(window.scale)) - 2.0f * pad;
    ImGui::SetNextWindowPos(ImVec2(pad, pad));
    ImGui::SetNextWindowSizeConstraints(ImVec2(0.0f, 0.0f), ImVec2(wide, high));
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, float(ui.message.alpha));
    ImGui::Begin("message", nullptr, (kFixed & ~ImGuiWindowFlags_NoScrollbar) | ImGuiWindowFlags_AlwaysAutoResize);
    ImGui::PushTextWrapPos(wide - ImGui::GetStyle().WindowPadding.x - ImGui::GetStyle().ScrollbarSize);
    if (ui.message.kind == Message::Kind::Error) ImGui::TextColored(ImVec4(1.0f, 0.55f, 0.45f, 1.0f), "Error");
    if (ui.message.kind == Message::Kind::Warning) ImGui::TextColored(ImVec4(1.0f, 0.80f, 0.35f, 1.0f), "Warning");
    ImGui::TextUnformatted(ui.message.text.c_str());
    ImGui::PopTextWrapPos();
    if (ui.message.stays()) {
        if (ImGui::Button("Dismiss")) ui.message.text.clear();
        notePlace(ui, "Dismiss");
        showTip(ui, "Takes this message away (Esc).");
    }
    ui.message_end = {pad + ImGui::GetWindowWidth(), pad + ImGui::GetWindowHeight()};
    ImGui::End();
    ImGui::PopStyleVar();
}

namespace {

/// A bar with a share of it filled; negative: a piece that goes to and fro.
void drawBar(ImDrawList& list, const ImVec2& low, const ImVec2& high, double share, double seconds) {
    const float wide = high.x - low.x, round = 0.5f * (high.y - low.y);
    list.AddRectFilled(low, high, IM_COL32(255, 255, 255, 60), round);
    float begin = low.x, end = low.x + wide * float(std::max(share, 0.02));
    if (share < 0.0) {
        const double phase = std::fmod(0.5 * seconds, 1.0);
        begin = low.x + 0.75f * wide * float(phase < 0.5 ? 2.0 * phase : 2.0 - 2.0 * phase);
        end = begin + 0.25f * wide;
    }
    list.AddRectFilled(ImVec2(begin, low.y), ImVec2(end, high.y), IM_COL32(92, 160, 255, 255), round);
}

/// What is waited for, and how much of it is done; negative: unknown.
struct Progress {
    std::string text;
    double share;
};

std::optional<Progress> progressOf(const Figures& figures, bool has_picture) {
    if (!figures.busy.empty() && (figures.busy_seconds > 0.3 || !has_picture)) {
        const std::string done = figures.busy_share < 0.0 ? fmt::format("{:.0f} s", figures.busy_seconds)
                                                          : fmt::format("{:.0f} %", 100.0 * figures.busy_share);
        return Progress{fmt::format("{} ...  {}", figures.busy, done), figures.busy_share};
    }
    if (figures.screenshot_waits)
        return Progress{fmt::format("Screenshot after {} samples, {} so far.  F12: now, Esc: none",
                                    figures.target_samples, figures.samples),
                        double(figures.samples) / double(std::max(figures.target_samples, 1))};
    if (figures.sample_share < 0.0 && has_picture) return {};
    const double share = std::max(figures.sample_share, 0.0);
    return Progress{fmt::format("Rendering the first sample ...  {:.0f} %", 100.0 * share), share};
}

}  // namespace

// In the middle while there is no picture yet, else at its foot.
void drawProgress(const Ui& ui, const Extent& window) {
    const std::optional<Progress> progress = progressOf(ui.figures, ui.has_picture);
    if (ui.starting || !progress) return;
    const std::string& line = progress->text;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const float unit = float(window.scale), size = (ui.has_picture ? 1.0f : 1.3f) * ImGui::GetFontSize();
    const ImVec2 text_size = ImGui::GetFont()->CalcTextSizeA(size, 1e6f, 0.0f, line.c_str());
    const float wide = std::max(260.0f * unit, text_size.x), middle = 0.5f * float(window.picture_width);
    const float bottom = float(window.height - statusHeight(window.scale));
    const float y = ui.has_picture ? bottom - 22.0f * unit : 0.5f * bottom;
    const ImVec2 low(middle - 0.5f * wide, y), high(middle + 0.5f * wide, y + 6.0f * unit);
    const float pad = 12.0f * unit;
    list.AddRectFilled(ImVec2(low.x - pad, low.y - 1.6f * size - pad), ImVec2(high.x + pad, high.y + pad),
                       IM_COL32(20, 20, 22, 215), 6.0f * unit);
    list.AddText(ImGui::GetFont(), size, ImVec2(middle - 0.5f * text_size.x, low.y - 1.5f * size),
                 IM_COL32(255, 255, 255, 235), line.c_str());
    drawBar(list, low, high, progress->share, ui.figures.busy_seconds);
}

// A window that appears is laid out once unseen, to learn its size.
void notePlace(Ui& ui, const std::string& label) {
    if (ImGui::IsWindowAppearing()) return;
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ui.places.emplace_back(label, std::array{low.x, low.y, high.x, high.y});
}

void layOut(Ui& ui, const Extent& window) {
    const auto [width, height, scale, picture_width] = window;
    ui.places.clear();
    // Without a window in focus no list is open and nothing is typed into.
    if (std::exchange(ui.let_go, false)) ImGui::SetWindowFocus(nullptr);
    const float bottom = float(height - statusHeight(scale));
    if (ui.has_picture)
        ImGui::GetBackgroundDrawList()->AddImage(reinterpret_cast<ImTextureID>(Overlay::kPicture), ImVec2(0.0f, 0.0f),
                                                 ImVec2(float(picture_width), bottom), ImVec2(0.0f, 0.0f),
                                                 ImVec2(ui.figures.u, ui.figures.v));
    if (ui.subject.state.view.split) drawDivider(ui, picture_width, height, scale);
    drawInstruments(ui, window);
    drawProgress(ui, window);
    drawStatusBar(ui, window);
    if (ui.starting) drawStart(ui, window);
    if (ui.panel_open) drawPanel(ui, window);
    if (ui.go_to.open) drawGoTo(ui, window);
    if (ui.path.open) drawPathBox(ui, window);
    if (ui.keys_open) drawKeys(ui, window);
    drawMessage(ui, window);
    if (ui.leaving.asked) drawLeaving(ui, window);
}

}  // namespace dsphere::viewer
