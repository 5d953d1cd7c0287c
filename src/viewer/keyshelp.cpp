#include <imgui.h>

#include <algorithm>
#include <string_view>

#include "viewer/ui.h"

namespace dsphere::viewer {

void drawKeys(Ui& ui, const Extent& window) {
    const float width = float(window.width), height = float(window.height - statusHeight(window.scale));
    ImGui::SetNextWindowPos(ImVec2(0.5f * width, 0.5f * height), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
    ImGui::SetNextWindowSize(ImVec2(std::min(width, 760.0f * float(window.scale)), 0.0f));
    ImGui::SetNextWindowSizeConstraints(ImVec2(0.0f, 0.0f), ImVec2(width, height));
    ImGui::SetNextWindowBgAlpha(1.0f);  // it lies over the panel
    ImGui::Begin("Keys", &ui.keys_open,
                 ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings |
                     ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoNav);
    const float column = ImGui::CalcTextSize("middle drag, Ctrl + drag").x + 24.0f * float(window.scale);
    std::string_view section;
    for (const KeyLine& line : keyLines()) {
        if (section != line.section) {
            if (!section.empty()) ImGui::Dummy(ImVec2(0.0f, 2.0f * float(window.scale)));
            ImGui::TextColored(ImVec4(0.45f, 0.70f, 1.0f, 1.0f), "%s", line.section);
            section = line.section;
        }
        ImGui::TextUnformatted(line.keys);
        ImGui::SameLine(column);
        ImGui::PushTextWrapPos(0.0f);
        ImGui::TextColored(ImVec4(0.75f, 0.75f, 0.77f, 1.0f), "%s", line.does);
        ImGui::PopTextWrapPos();
    }
    ImGui::End();
}

}  // namespace dsphere::viewer
