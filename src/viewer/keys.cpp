#include <imgui.h>

#include "viewer/ui.h"

namespace dsphere::viewer {

namespace {

struct Line {
    const char *keys, *does;  ///< a heading if `does` is null
};

constexpr Line kLines[] = {
    {"Mouse", nullptr},
    {"drag", "turn the planet: what you grabbed stays under the cursor"},
    {"right drag, Shift + drag", "move sideways"},
    {"middle drag, Ctrl + drag", "turn and tilt about the point under the cursor"},
    {"wheel, two fingers", "zoom to the cursor, down to the ground"},
    {"L + drag", "move the sun"},
    {"point", "latitude, longitude, height in the map's units and distance in the scene's, in the bar below"},
    {"drop a file", "open a heightmap or a scene; a changed file reloads itself"},
    {"Move", nullptr},
    {"W A S D, Q E", "fly: ahead, left, back, right, down, up; Shift: faster"},
    {"R, Enter", "back to the first view"},
    {"1 3 7 9", "front, right, pole, corner"},
    {"Look", nullptr},
    {"Tab", "panel: relief, sun, exposure, material, values, camera, scene"},
    {"M", "next marcher: exact, naive ..."},
    {"X", "split: naive on the left; drag the divider"},
    {"V", "next value: colour, steps heat map, t, normal, u/v, albedo, residual"},
    {"Keep", nullptr},
    {"F12", "screenshot, as `dsphere render` makes it"},
    {"Ctrl + C", "copy the camera as pbrt text"},
    {"Ctrl + S", "save the scene with this camera and these settings"},
    {"H, ?", "these keys"},
    {"Esc", "close an open list or these keys, else the window"},
};

}  // namespace

void drawKeys(Ui& ui, int width, int height, double scale) {
    ImGui::SetNextWindowPos(ImVec2(0.5f * float(width), 0.5f * float(height - statusHeight(scale))), ImGuiCond_Always,
                            ImVec2(0.5f, 0.5f));
    ImGui::SetNextWindowSizeConstraints(ImVec2(0.0f, 0.0f), ImVec2(float(width), float(height - statusHeight(scale))));
    ImGui::Begin("Keys", &ui.keys_open,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav);
    float column = ImGui::CalcTextSize("middle drag, Ctrl + drag").x + 24.0f * float(scale);
    for (const Line& line : kLines) {
        if (!line.does) {
            if (&line != kLines) ImGui::Dummy(ImVec2(0.0f, 2.0f * float(scale)));
            ImGui::TextColored(ImVec4(0.45f, 0.70f, 1.0f, 1.0f), "%s", line.keys);
            continue;
        }
        ImGui::TextUnformatted(line.keys);
        ImGui::SameLine(column);
        ImGui::TextColored(ImVec4(0.75f, 0.75f, 0.77f, 1.0f), "%s", line.does);
    }
    ImGui::End();
}

}  // namespace dsphere::viewer
