#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "viewer/degrees.h"
#include "viewer/rows.h"

namespace dsphere::viewer {

namespace {

constexpr float kLabelShare = 0.36f, kSliderShare = 0.34f;

/// What a row shows where nothing has been changed since the file was opened.
Subject untouched(const Ui& ui) {
    Subject subject = ui.subject;
    subject.state = ui.untouched;
    subject.state.target = ui.subject.state.target;
    return subject;
}

/// The field of a number; true: `value` is another one.
bool typedNumber(const char* id, const NumberRow& number, double& value) {
    if (!number.directions)
        return ImGui::InputScalar(id, ImGuiDataType_Double, &value, nullptr, nullptr, number.format,
                                  ImGuiInputTextFlags_CharsScientific | ImGuiInputTextFlags_AutoSelectAll);
    std::array<char, 32> text = {};
    degreesText(value, number.directions, 1).copy(text.data(), text.size() - 1);
    if (!ImGui::InputText(id, text.data(), text.size(), ImGuiInputTextFlags_AutoSelectAll)) return false;
    const std::optional<double> degrees = degreesIn(text.data(), number.directions, 360.0);
    if (degrees) value = *degrees;
    return degrees.has_value();
}

// The number stands beside the slider, so that the knob never covers it, and can be typed there.
void drawControl(Ui& ui, const Row& row, const NumberRow& number) {
    Subject& subject = ui.subject;
    const std::string id = row.label;
    double value = number.get(subject);
    const float wide = ImGui::GetContentRegionAvail().x;
    ImGui::SetNextItemWidth(kSliderShare / (1.0f - kLabelShare) * wide);
    const ImGuiSliderFlags flags = number.logarithmic ? ImGuiSliderFlags_Logarithmic : ImGuiSliderFlags_None;
    const bool slid = ImGui::SliderScalar(("##" + id).c_str(), ImGuiDataType_Double, &value, &number.low, &number.high,
                                          "", flags | ImGuiSliderFlags_NoInput);
    notePlace(ui, id);
    if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left)) ui.resetting = id;
    if (ui.resetting == id)
        number.set(subject, number.get(untouched(ui)));
    else if (slid)
        number.set(subject, value);
    showTip(ui, (std::string(row.tip) + "\nDouble click: as the file was opened.").c_str());
    ImGui::SameLine();
    value = number.get(subject);
    ImGui::SetNextItemWidth(-1.0f);
    if (typedNumber(("##value of " + id).c_str(), number, value)) number.set(subject, value);
    notePlace(ui, id + " value");
    showTip(ui, row.tip);
}

void drawControl(Ui& ui, const Row& row, const ChoiceRow& choice) {
    const std::vector<std::string> names = choice.names(ui.subject);
    const int chosen = choice.get(ui.subject);
    ImGui::SetNextItemWidth(-1.0f);
    const char* shown = chosen < int(names.size()) ? names[std::size_t(chosen)].c_str() : "";
    const bool open = ImGui::BeginCombo((std::string("##") + row.label).c_str(), shown);
    if (!open) {
        notePlace(ui, row.label);
        showTip(ui, row.tip);
        return;
    }
    for (int k = 0; k < int(names.size()); ++k) {
        if (ImGui::Selectable(names[std::size_t(k)].c_str(), k == chosen) && k != chosen) choice.set(ui.subject, k);
        notePlace(ui, std::string(row.label) + "/" + names[std::size_t(k)]);
    }
    ImGui::EndCombo();
}

void drawControl(Ui& ui, const Row& row, const SwitchRow& toggle) {
    bool on = toggle.get(ui.subject);
    if (ImGui::Checkbox((std::string("##") + row.label).c_str(), &on)) toggle.set(ui.subject, on);
    notePlace(ui, row.label);
    showTip(ui, row.tip);
}

void drawControl(Ui& ui, const Row& row, const ColourRow& colour) {
    const dvec3 value = colour.get(ui.subject);
    float rgb[3] = {float(value.x), float(value.y), float(value.z)};
    ImGui::SetNextItemWidth(-1.0f);
    if (ImGui::ColorEdit3((std::string("##") + row.label).c_str(), rgb, ImGuiColorEditFlags_Float))
        colour.set(ui.subject, dvec3(double(rgb[0]), double(rgb[1]), double(rgb[2])));
    notePlace(ui, row.label);
    showTip(ui, row.tip);
}

void drawRow(Ui& ui, const Row& row) {
    const float start = ImGui::GetCursorPosX(), wide = ImGui::GetContentRegionAvail().x;
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(row.label);
    showTip(ui, row.tip);
    ImGui::SameLine(start + kLabelShare * wide);
    std::visit([&](const auto& control) { drawControl(ui, row, control); }, row.control);
}

void drawSections(Ui& ui) {
    std::string_view section;
    bool open = false;
    for (const Row& row : panelRows()) {
        if (!row.applies(ui.subject)) continue;
        if (section != row.section) {
            section = row.section;
            const bool first = section != "Advanced";
            open =
                ImGui::CollapsingHeader(row.section, first ? ImGuiTreeNodeFlags_DefaultOpen : ImGuiTreeNodeFlags_None);
            notePlace(ui, row.section);
            showTip(ui, "Click: folds this section, or opens it.");
        }
        if (open) drawRow(ui, row);
    }
}

void commandButton(Ui& ui, const char* name, const char* tip, Command command) {
    if (buttonInRow(name)) ui.command = command;
    notePlace(ui, name);
    showTip(ui, tip);
}

void drawButtons(Ui& ui) {
    ImGui::Separator();
    beginButtonRow();
    commandButton(ui, "Open", "Another scene or heightmap, whose path is typed (Ctrl + O).", Command::OpenFile);
    commandButton(ui, "Go to", "A latitude, longitude and height that are typed (G).", Command::GoTo);
    commandButton(ui, "First view", "Back to where the view began (R).", Command::ResetView);
    commandButton(ui, "Full screen", "Fills the screen, or goes back to the window (F11).", Command::FullScreen);
    commandButton(ui, "Screenshot", "Writes the picture as `dsphere render` makes it (F12).", Command::Screenshot);
    commandButton(ui, "Save scene", "Writes a scene file with this camera and these settings (Ctrl + S).",
                  Command::SaveScene);
    commandButton(ui, "Copy camera", "Puts the camera on the clipboard as pbrt text (Ctrl + C).", Command::CopyCamera);
    beginButtonRow();
    commandButton(ui, "Undo", "Takes the last change back (Ctrl + Z).", Command::Undo);
    commandButton(ui, "Redo", "Does it again (Ctrl + Shift + Z).", Command::Redo);
    commandButton(ui, "Reset all", "All settings as the file was opened; the view stays.", Command::ResetAll);
}

void drawDockButton(Ui& ui) {
    const char* name = ui.docked ? "Undock" : "Dock";
    if (buttonInRow(name)) ui.docked = !ui.docked;
    notePlace(ui, "Dock");
    showTip(ui, ui.docked
                    ? "Lets the panel float over the picture."
                    : "Puts the panel beside the picture, at the window's right edge; dragging it there does, too.");
}

void drawFigures(const Figures& figures) {
    ImGui::Separator();
    ImGui::TextDisabled("%s", figures.device.c_str());
    ImGui::TextDisabled("%s", fmt::format("{}x{}, sample {} of {}", figures.width, figures.height, figures.samples,
                                          figures.target_samples)
                                  .c_str());
    ImGui::TextDisabled("%s", fmt::format("{:.1f} ms a frame, {:.1f} M rays/s", 1e3 * figures.frame_seconds,
                                          1e-6 * figures.rays_per_second)
                                  .c_str());
}

/// Where the panel is, docked or floating.
ImGuiWindowFlags placePanel(const Ui& ui, const Extent& window) {
    const float pad = 12.0f * float(window.scale), width = float(window.width);
    const float bottom = float(window.height - statusHeight(window.scale));
    if (ui.docked) {
        const float wide = float(panelWidth(window.scale));
        ImGui::SetNextWindowPos(ImVec2(width - wide, 0.0f));
        ImGui::SetNextWindowSize(ImVec2(wide, bottom));
        ImGui::SetNextWindowCollapsed(false);
        return ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse;
    }
    const float wide = std::min(float(panelWidth(window.scale)), width - 2.0f * pad);
    ImGui::SetNextWindowPos(ImVec2(width - pad, pad), ImGuiCond_Appearing, ImVec2(1.0f, 0.0f));
    // In a smaller window it stays in sight.
    const auto& [x0, y0, x1, y1] = ui.panel_box;
    if (x1 > 0.0f && (window.width < ui.panel_window[0] || window.height < ui.panel_window[1]))
        ImGui::SetNextWindowPos(ImVec2(std::clamp(x0, pad, std::max(pad, width - pad - wide)),
                                       std::clamp(y0, pad, std::max(pad, bottom - pad - (y1 - y0)))));
    ImGui::SetNextWindowSizeConstraints(ImVec2(wide, 0.0f), ImVec2(wide, bottom - 2.0f * pad));
    return ImGuiWindowFlags_AlwaysAutoResize;
}

// A floating panel that is let go at the window's right edge.
void dockAtEdge(Ui& ui, const Extent& window) {
    const ImVec2 low = ImGui::GetWindowPos(), grabbed = ImGui::GetIO().MouseClickedPos[0];
    const float title = ImGui::GetFrameHeight();
    const bool moved = ImGui::IsMouseReleased(ImGuiMouseButton_Left) && ImGui::IsWindowFocused() &&
                       ImGui::GetIO().MousePos.y < low.y + title + 4.0f && grabbed.x != ImGui::GetIO().MousePos.x;
    if (moved && low.x + ImGui::GetWindowWidth() > float(window.width) + 20.0f * float(window.scale)) ui.docked = true;
}

}  // namespace

void beginButtonRow() {
    ImGui::Dummy(ImVec2(ImGui::GetContentRegionAvail().x, 0.0f));
}

bool buttonInRow(const char* name) {
    const float right = ImGui::GetWindowPos().x + ImGui::GetWindowContentRegionMax().x;
    const float wide = ImGui::CalcTextSize(name).x + 2.0f * ImGui::GetStyle().FramePadding.x;
    if (ImGui::GetItemRectMax().x + ImGui::GetStyle().ItemSpacing.x + wide < right) ImGui::SameLine();
    return ImGui::Button(name);
}

float freeRight(const Ui& ui, const Extent& window, float top) {
    const auto& [x0, y0, x1, y1] = ui.panel_box;
    const float width = float(window.picture_width);
    const bool covers = ui.panel_open && !ui.docked && y1 > top && x0 > 0.25f * width && x1 > 0.85f * width;
    return covers ? std::min(x0, width) : width;
}

int panelWidth(double scale) {
    return int(std::round(380.0 * scale));
}

void drawPanel(Ui& ui, const Extent& window) {
    const std::string title =
        ui.subject.original ? "Panel: " + shapeName(*ui.subject.original, ui.subject.state.target) : "Panel";
    if (!ImGui::IsMouseDown(ImGuiMouseButton_Left)) ui.resetting.clear();
    const ImGuiWindowFlags placed = placePanel(ui, window);
    if (ImGui::Begin((title + "###panel").c_str(), &ui.panel_open, placed | ImGuiWindowFlags_NoSavedSettings)) {
        if (ui.subject.original) drawSections(ui);
        drawButtons(ui);
        drawDockButton(ui);
        drawFigures(ui.figures);
    }
    const ImVec2 corner = ImGui::GetWindowPos();
    const float title_height = ImGui::GetFrameHeight(), bottom = corner.y + title_height;
    ui.places.emplace_back("Title", std::array{corner.x, corner.y, corner.x + ImGui::GetWindowWidth(), bottom});
    ui.places.emplace_back("Fold", std::array{corner.x, corner.y, corner.x + 1.3f * title_height, bottom});
    ui.panel_box = {corner.x, corner.y, corner.x + ImGui::GetWindowWidth(), corner.y + ImGui::GetWindowHeight()};
    ui.panel_window = {window.width, window.height};
    if (!ui.docked) dockAtEdge(ui, window);
    ImGui::End();
}

}  // namespace dsphere::viewer
