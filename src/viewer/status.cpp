#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "viewer/overlay.h"
#include "viewer/ui.h"

namespace dsphere::viewer {

namespace {

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                                    ImGuiWindowFlags_NoBringToFrontOnFocus;

std::string progressText(const Figures& figures) {
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

/// What the colours of a value mean.
std::string legend(const Ui& ui) {
    switch (ui.subject.state.view.show) {
        case Show::Steps:
            return fmt::format("steps: blue 0, red {:.0f} or more", ui.subject.state.tone.most_steps);
        case Show::Distance:
            return "distance: near light, far dark";
        case Show::Normal:
            return "normal: x, y, z as red, green, blue";
        case Show::Uv:
            return "u as red, v as green";
        case Show::Albedo:
            return "albedo";
        case Show::Residual:
            return "residual: blue 1e-9 R, red 1e-5 R or more";
        case Show::Colour:
            break;
    }
    return {};
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
    const auto [width, height, scale] = window;
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
        left += widthOf(ui.figures.file.c_str()) + 2.0f * pad;
    }
    if (with_progress) {
        place(left);
        ImGui::TextDisabled("%s", progress.c_str());
    }
    const float right = float(width) - pad - (with_buttons ? buttons + 2.0f * pad : 0.0f);
    if (hover > 0.0f) {
        place(std::max(pad, right - hover + 2.0f * pad));
        ImGui::TextUnformatted(ui.figures.hover.c_str());
    }
    if (with_buttons) {
        place(float(width) - pad - buttons);
        if (ImGui::Button("Tab: panel")) ui.command = Command::Panel;
        ImGui::SameLine();
        if (ImGui::Button("H: keys")) ui.command = Command::Keys;
    }
    ImGui::End();
    ImGui::PopStyleVar(4);
}

void drawMessage(Ui& ui, const Extent& window) {
    if (ui.message.text.empty()) return;
    const float pad = 12.0f * float(window.scale), wide = 0.6f * float(window.width);
    ImGui::SetNextWindowPos(ImVec2(pad, pad));
    ImGui::SetNextWindowSizeConstraints(ImVec2(0.0f, 0.0f), ImVec2(wide, 1e6f));
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, float(ui.message.alpha));
    ImGui::Begin("message", nullptr, kFixed | ImGuiWindowFlags_AlwaysAutoResize);
    ImGui::PushTextWrapPos(0.97f * wide);
    if (ui.message.kind == Message::Kind::Error) ImGui::TextColored(ImVec4(1.0f, 0.55f, 0.45f, 1.0f), "Error");
    if (ui.message.kind == Message::Kind::Warning) ImGui::TextColored(ImVec4(1.0f, 0.80f, 0.35f, 1.0f), "Warning");
    ImGui::TextUnformatted(ui.message.text.c_str());
    ImGui::PopTextWrapPos();
    if (ui.message.stays()) {
        if (ImGui::Button("Dismiss")) ui.message.text.clear();
        notePlace(ui, "Dismiss");
    }
    ImGui::End();
    ImGui::PopStyleVar();
}

namespace {

/// What is being done while there is no picture yet, where one looks for it.
void drawProgress(const Ui& ui, const Extent& window) {
    const std::string text = ui.figures.busy.empty() ? "Preparing the picture" : ui.figures.busy;
    const std::string line = fmt::format("{} ...  {:.0f} s", text, ui.figures.busy_seconds);
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const float wide = 260.0f * float(window.scale), high = 4.0f * float(window.scale);
    const ImVec2 middle(0.5f * float(window.width), 0.5f * float(window.height - statusHeight(window.scale)));
    const float size = 1.3f * ImGui::GetFontSize();
    const ImVec2 text_size = ImGui::GetFont()->CalcTextSizeA(size, 1e6f, 0.0f, line.c_str());
    list.AddText(ImGui::GetFont(), size, ImVec2(middle.x - 0.5f * text_size.x, middle.y - 2.0f * size),
                 IM_COL32(255, 255, 255, 235), line.c_str());
    const float left = middle.x - 0.5f * wide;
    list.AddRectFilled(ImVec2(left, middle.y), ImVec2(left + wide, middle.y + high), IM_COL32(255, 255, 255, 40), high);
    const float share = float(ui.figures.busy_seconds - std::floor(ui.figures.busy_seconds));
    const float begin = left + 0.75f * wide * (share < 0.5f ? 2.0f * share : 2.0f - 2.0f * share);
    list.AddRectFilled(ImVec2(begin, middle.y), ImVec2(begin + 0.25f * wide, middle.y + high),
                       IM_COL32(92, 160, 255, 255), high);
}

}  // namespace

void drawClosing(Ui& ui, const Extent& window) {
    ImGui::SetNextWindowPos(ImVec2(0.5f * float(window.width), 0.4f * float(window.height)), ImGuiCond_Always,
                            ImVec2(0.5f, 0.5f));
    ImGui::SetNextWindowFocus();
    ImGui::Begin("Unsaved changes", nullptr,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoMove);
    ImGui::TextUnformatted("The panel's changes are in no scene file yet.");
    const auto choice = [&](const char* name, Command command) {
        if (ImGui::Button(name)) ui.command = command, ui.closing = false;
        notePlace(ui, name);
    };
    choice("Save and close", Command::SaveAndQuit);
    ImGui::SameLine();
    choice("Close without saving", Command::QuitUnsaved);
    ImGui::SameLine();
    choice("Go on", Command::None);
    ImGui::End();
}

// A window that appears is laid out once unseen, to learn its size.
void notePlace(Ui& ui, const std::string& label) {
    if (ImGui::IsWindowAppearing()) return;
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ui.places.emplace_back(label, std::array{low.x, low.y, high.x, high.y});
}

void layOut(Ui& ui, const Extent& window) {
    const auto [width, height, scale] = window;
    ui.places.clear();
    // Without a window in focus no list is open and nothing is typed into.
    if (std::exchange(ui.let_go, false)) ImGui::SetWindowFocus(nullptr);
    const float bottom = float(height - statusHeight(scale));
    if (ui.has_picture)
        ImGui::GetBackgroundDrawList()->AddImage(reinterpret_cast<ImTextureID>(Overlay::kPicture), ImVec2(0.0f, 0.0f),
                                                 ImVec2(float(width), bottom), ImVec2(0.0f, 0.0f),
                                                 ImVec2(ui.figures.u, ui.figures.v));
    else
        drawProgress(ui, window);
    if (ui.subject.state.view.split) drawDivider(ui, width, height, scale);
    if (const std::string text = legend(ui); !text.empty())
        drawLabel(ImVec2(10.0f * float(scale), bottom - 2.0f * ImGui::GetFontSize()), text.c_str(), scale);
    drawStatusBar(ui, window);
    if (ui.panel_open) drawPanel(ui, window);
    if (ui.keys_open) drawKeys(ui, window);
    drawMessage(ui, window);
    if (ui.closing) drawClosing(ui, window);
}

}  // namespace dsphere::viewer
