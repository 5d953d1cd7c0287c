#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <utility>

#include "viewer/overlay.h"
#include "viewer/ui.h"

namespace dsphere::viewer {

namespace {

constexpr ImGuiWindowFlags kFixed = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove |
                                    ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav |
                                    ImGuiWindowFlags_NoBringToFrontOnFocus;

std::string progressText(const Figures& figures) {
    if (figures.busy) return "loading ...";
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
    float x = float(ui.view.divider) * float(width), half = float(scale), bottom = float(height - statusHeight(scale));
    list.AddRectFilled(ImVec2(x - half, 0.0f), ImVec2(x + half, bottom), IM_COL32(255, 255, 255, 200));
    list.AddCircleFilled(ImVec2(x, 0.5f * bottom), 7.0f * half, IM_COL32(255, 255, 255, 230));
    float pad = 10.0f * half, top = pad;
    const char *left = "naive", *right = kMarcherNames[int(ui.view.method.marcher)];
    drawLabel(ImVec2(x - pad - widthOf(left), top), left, scale);
    drawLabel(ImVec2(x + pad, top), right, scale);
}

/// What the colours of a value mean.
std::string legend(const Ui& ui) {
    switch (ui.view.show) {
        case Show::Steps:
            return fmt::format("steps: blue 0, red {:.0f} or more", ui.tone.most_steps);
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
    if (ui.view.method.marcher != Marcher::Exact && !ui.view.split)
        text = std::string("   ") + kMarcherNames[int(ui.view.method.marcher)];
    if (ui.view.method.detail > 0.0f) text += "   detail";
    if (ui.view.show != Show::Colour) text += std::string("   ") + kShowNames[int(ui.view.show)];
    return text;
}

}  // namespace

void drawStatusBar(Ui& ui, int width, int height, double scale) {
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
        if (ImGui::Button("Tab: panel")) ui.panel_open = !ui.panel_open;
        ImGui::SameLine();
        if (ImGui::Button("H: keys")) ui.keys_open = !ui.keys_open;
    }
    ImGui::End();
    ImGui::PopStyleVar(4);
}

void drawMessage(Ui& ui, int width, int, double scale) {
    if (ui.message.empty()) return;
    float pad = 12.0f * float(scale);
    ImGui::SetNextWindowPos(ImVec2(pad, pad));
    ImGui::SetNextWindowSizeConstraints(ImVec2(0.0f, 0.0f), ImVec2(0.6f * float(width), 1e6f));
    ImGui::PushStyleVar(ImGuiStyleVar_Alpha, float(ui.message_alpha));
    ImGui::Begin("message", nullptr, kFixed | ImGuiWindowFlags_AlwaysAutoResize);
    ImGui::PushTextWrapPos(0.58f * float(width));
    if (ui.message_is_error) ImGui::TextColored(ImVec4(1.0f, 0.55f, 0.45f, 1.0f), "Error");
    ImGui::TextUnformatted(ui.message.c_str());
    ImGui::PopTextWrapPos();
    if (ui.message_is_error && ImGui::Button("Dismiss")) ui.message.clear();
    ImGui::End();
    ImGui::PopStyleVar();
}

void layOut(Ui& ui, int width, int height, double scale) {
    // Without a window in focus no list is open and nothing is typed into.
    if (std::exchange(ui.let_go, false)) ImGui::SetWindowFocus(nullptr);
    if (ui.has_picture)
        ImGui::GetBackgroundDrawList()->AddImage(reinterpret_cast<ImTextureID>(Overlay::kPicture), ImVec2(0.0f, 0.0f),
                                                 ImVec2(float(width), float(height)), ImVec2(0.0f, 0.0f),
                                                 ImVec2(ui.figures.u, ui.figures.v));
    if (ui.view.split) drawDivider(ui, width, height, scale);
    if (const std::string text = legend(ui); !text.empty())
        drawLabel(ImVec2(10.0f * float(scale), float(height - statusHeight(scale)) - 2.0f * ImGui::GetFontSize()),
                  text.c_str(), scale);
    drawStatusBar(ui, width, height, scale);
    if (ui.panel_open) drawPanel(ui, width, height, scale);
    if (ui.keys_open) drawKeys(ui, width, height, scale);
    drawMessage(ui, width, height, scale);
}

}  // namespace dsphere::viewer
