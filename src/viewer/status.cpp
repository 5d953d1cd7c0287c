#include <fmt/format.h>
#include <imgui.h>

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

void drawDivider(const Ui& ui, int width, int height, double scale) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    float x = float(ui.view.divider) * float(width), half = float(scale), bottom = float(height - statusHeight(scale));
    list.AddRectFilled(ImVec2(x - half, 0.0f), ImVec2(x + half, bottom), IM_COL32(255, 255, 255, 200));
    list.AddCircleFilled(ImVec2(x, 0.5f * bottom), 7.0f * half, IM_COL32(255, 255, 255, 230));
    float pad = 10.0f * half, top = pad;
    const char *left = "naive", *right = ui.view.method.marcher == Marcher::Exact ? "exact" : "chosen marcher";
    auto label = [&](float at, const char* text) {
        list.AddText(ImVec2(at + half, top + half), IM_COL32(0, 0, 0, 220), text);
        list.AddText(ImVec2(at, top), IM_COL32(255, 255, 255, 235), text);
    };
    label(x - pad - widthOf(left), left);
    label(x + pad, right);
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
    ImGui::SetCursorPosY(0.5f * (bar - ImGui::GetFrameHeight()));
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(ui.figures.file.c_str());
    ImGui::SameLine(0.0f, 2.0f * pad);
    ImGui::TextDisabled("%s", progressText(ui.figures).c_str());
    const ImGuiStyle& style = ImGui::GetStyle();
    float buttons = widthOf("Tab: panel") + widthOf("H: keys") + 4.0f * style.FramePadding.x + style.ItemSpacing.x;
    float right = float(width) - pad - buttons;
    float hover = widthOf(ui.figures.hover.c_str());
    if (!ui.figures.hover.empty() && right - hover - 2.0f * pad > ImGui::GetItemRectMax().x) {
        ImGui::SameLine(right - hover - 2.0f * pad);
        ImGui::TextUnformatted(ui.figures.hover.c_str());
    }
    if (right > ImGui::GetItemRectMax().x) {
        ImGui::SameLine(right);
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
    if (ui.has_picture)
        ImGui::GetBackgroundDrawList()->AddImage(reinterpret_cast<ImTextureID>(Overlay::kPicture), ImVec2(0.0f, 0.0f),
                                                 ImVec2(float(width), float(height)), ImVec2(0.0f, 0.0f),
                                                 ImVec2(ui.figures.u, ui.figures.v));
    if (ui.view.split) drawDivider(ui, width, height, scale);
    drawStatusBar(ui, width, height, scale);
    if (ui.panel_open) drawPanel(ui, width, height, scale);
    if (ui.keys_open) drawKeys(ui, width, height, scale);
    drawMessage(ui, width, height, scale);
}

}  // namespace dsphere::viewer
