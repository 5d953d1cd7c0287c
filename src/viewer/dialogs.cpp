// Windows that something is typed into: a path, a place; and the one that the program starts with.

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <optional>

#include "viewer/degrees.h"
#include "viewer/recent.h"
#include "viewer/ui.h"

namespace dsphere::viewer {

namespace {

constexpr ImGuiWindowFlags kDialog = ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                                     ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoNav;

void centreNext(const Extent& window, float share, float wide) {
    ImGui::SetNextWindowPos(ImVec2(0.5f * float(window.picture_width), share * float(window.height)), ImGuiCond_Always,
                            ImVec2(0.5f, 0.5f));
    const float most = float(window.picture_width) - 24.0f * float(window.scale);
    const float fitting = std::min(wide * float(window.scale), most);
    ImGui::SetNextWindowSizeConstraints(ImVec2(fitting, 0.0f), ImVec2(fitting, 0.9f * float(window.height)));
}

std::string shortName(const std::string& path) {
    return std::filesystem::path(path).filename().string();
}

void setText(PathBox& box, const std::string& text) {
    const std::size_t length = std::min(text.size(), box.text.size() - 1);
    std::memcpy(box.text.data(), text.data(), length);
    box.text[length] = '\0';
}

// Tab goes on as far as all completions agree.
int completeText(ImGuiInputTextCallbackData* data) {
    if (data->EventFlag != ImGuiInputTextFlags_CallbackCompletion) return 0;
    const std::string common = completionsOf(data->Buf).common;
    if (common == data->Buf || int(common.size()) + 1 > data->BufSize) return 0;
    data->DeleteChars(0, data->BufTextLen);
    data->InsertChars(0, common.c_str());
    return 0;
}

void choosePath(PathBox& box, const std::string& path) {
    if (path.ends_with('/'))
        setText(box, path);
    else
        box.chosen = expandedPath(path);
}

/// The field and what it may go on as.
void drawPathField(Ui& ui, bool focus, int most) {
    PathBox& box = ui.path;
    if (focus) ImGui::SetKeyboardFocusHere();
    ImGui::SetNextItemWidth(-1.0f);
    const bool entered =
        ImGui::InputTextWithHint("##path", "Path of a scene (.pbrt) or a heightmap", box.text.data(), box.text.size(),
                                 ImGuiInputTextFlags_CallbackCompletion | ImGuiInputTextFlags_EnterReturnsTrue |
                                     ImGuiInputTextFlags_AutoSelectAll,
                                 completeText);
    notePlace(ui, "Path");
    showTip(ui, "Tab completes the path, Enter opens it.");
    const std::string text = box.text.data();
    if (box.completed != text || box.completions.common.empty()) {
        box.completed = text;
        box.completions = completionsOf(text);
    }
    if (entered && !text.empty()) {
        std::error_code error;
        const bool folder = std::filesystem::is_directory(expandedPath(text), error);
        choosePath(box, folder && !text.ends_with('/') ? text + "/" : text);
    }
    for (int i = 0; i < std::min(most, int(box.completions.paths.size())); ++i) {
        const std::string& path = box.completions.paths[std::size_t(i)];
        if (ImGui::Selectable(path.c_str())) choosePath(box, path);
        notePlace(ui, "Path/" + path);
    }
    if (most > 0 && int(box.completions.paths.size()) > most)
        ImGui::TextDisabled("%s", fmt::format("... and {} more", int(box.completions.paths.size()) - most).c_str());
}

/// The label, and beside it the field that draw(id) draws; whether Enter ended what was typed there.
template <typename Draw>
bool drawField(Ui& ui, const char* label, const char* tip, const Draw& draw) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label);
    ImGui::SameLine(0.42f * ImGui::GetWindowWidth());
    ImGui::SetNextItemWidth(-1.0f);
    draw((std::string("##go ") + label).c_str());
    const auto pressed = [](ImGuiKey key) { return ImGui::IsKeyPressed(ImGui::GetKeyIndex(key)); };
    const bool entered = ImGui::IsItemDeactivated() && (pressed(ImGuiKey_Enter) || pressed(ImGuiKey_KeyPadEnter));
    notePlace(ui, label);
    showTip(ui, tip);
    return entered;
}

bool drawNumber(Ui& ui, const char* label, double& value, const char* format, const char* tip) {
    return drawField(ui, label, tip, [&](const char* id) {
        ImGui::InputDouble(id, &value, 0.0, 0.0, format, ImGuiInputTextFlags_AutoSelectAll);
    });
}

/// What cannot be understood leaves the value as it was.
bool drawDegrees(Ui& ui, const char* label, double& value, std::array<char, 32>& text, Directions directions,
                 double most, const char* tip) {
    return drawField(ui, label, tip, [&](const char* id) {
        ImGui::InputText(id, text.data(), text.size(), ImGuiInputTextFlags_AutoSelectAll);
        if (ImGui::IsItemDeactivatedAfterEdit())
            if (const std::optional<double> degrees = degreesIn(text.data(), directions, most)) value = *degrees;
        if (!ImGui::IsItemActive()) text[degreesText(value, directions).copy(text.data(), text.size() - 1)] = '\0';
    });
}

}  // namespace

void drawPathBox(Ui& ui, const Extent& window) {
    centreNext(window, 0.35f, 620.0f);
    if (ImGui::Begin("Open a scene or a heightmap", &ui.path.open, kDialog))
        drawPathField(ui, ImGui::IsWindowAppearing(), 10);
    ImGui::End();
}

void drawGoTo(Ui& ui, const Extent& window) {
    GoTo& place = ui.go_to;
    centreNext(window, 0.35f, 360.0f);
    // Tab goes from field to field where ImGui may navigate.
    if (ImGui::Begin("Go to a place", &place.open, kDialog & ~ImGuiWindowFlags_NoNavInputs)) {
        if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
        const std::string height = std::string("%.6g ") + ui.figures.gauges.unit.name();
        bool entered = drawDegrees(ui, "Latitude", place.latitude, place.latitude_text, "NS", 90.0,
                                   "Degrees: 45.5, 45.5 S or -45.5.");
        entered |= drawDegrees(ui, "Longitude", place.longitude, place.longitude_text, "EW", 360.0,
                               "Degrees: 20, 20 W or -20.");
        entered |= drawNumber(ui, "Above the ground", place.altitude, height.c_str(),
                              "How high the eye is: metres where the map knows its radius, else radii (R).");
        if (ImGui::Button("Go") || entered) place.go = true;
        notePlace(ui, "Go");
        showTip(ui, "Flies there and looks straight down, north up.");
    }
    ImGui::End();
}

// It stays in front, and the picture's keys wait: what is asked about must not be missed.
void drawLeaving(Ui& ui, const Extent& window) {
    Leaving& leaving = ui.leaving;
    const bool closes = leaving.file.empty();
    const std::string title = closes ? "Close the window?" : "Open " + shortName(leaving.file) + "?";
    centreNext(window, 0.4f, 480.0f);
    ImGui::SetNextWindowFocus();
    ImGui::Begin((title + "###leaving").c_str(), nullptr, kDialog | ImGuiWindowFlags_NoMove);
    ImGui::TextWrapped(
        "%s", fmt::format("Changes to {} that no scene file has yet: {}.", ui.figures.file, leaving.changes).c_str());
    ImGui::TextWrapped("%s", fmt::format("Saving writes {}.", leaving.save_as).c_str());
    const auto choice = [&](const char* id, const char* name, Command command, const char* tip) {
        if (buttonInRow(name)) ui.command = command;
        notePlace(ui, id);
        showTip(ui, tip);
    };
    beginButtonRow();
    choice("Leaving/Save", closes ? "Save and close" : "Save and open", Command::SaveAndLeave,
           "Writes the new scene file first (Enter).");
    choice("Leaving/Discard", closes ? "Close without saving" : "Open without saving", Command::LeaveUnsaved,
           "The changes are lost.");
    choice("Leaving/Stay", "Keep editing", Command::Stay, "Nothing is saved or lost (Esc).");
    ImGui::End();
}

void drawStart(Ui& ui, const Extent& window) {
    centreNext(window, 0.47f, 640.0f);
    ImGui::Begin("dsphere###start", nullptr,
                 kDialog | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoBringToFrontOnFocus);
    ImGui::TextWrapped("Drop a scene or a heightmap on this window, or type its path:");
    drawPathField(ui, false, ui.path.text[0] == '\0' ? 0 : 6);
    if (!ui.recent.empty()) {
        ImGui::Separator();
        ImGui::TextDisabled("Opened lately");
        for (const std::string& path : ui.recent) {
            if (ImGui::Selectable(path.c_str())) ui.path.chosen = path;
            notePlace(ui, "Recent/" + shortName(path));
            showTip(ui, "Opens it again.");
        }
    }
    ImGui::Separator();
    ImGui::TextDisabled("Or look at a sample");
    for (std::size_t i = 0; i < std::size(kSamples); ++i) {
        if (i > 0) ImGui::SameLine();
        if (ImGui::Button(kSamples[i].name)) ui.path.chosen = samplePath(i);
        notePlace(ui, kSamples[i].name);
        showTip(ui, kSamples[i].tells);
    }
    ImGui::Separator();
    ImGui::TextDisabled("Then: drag to turn, scroll to zoom, Tab for the panel, H for all keys.");
    ImGui::End();
}

}  // namespace dsphere::viewer
