#include <imgui.h>

#include <cmath>
#include <filesystem>
#include <initializer_list>

#include "viewer/ui.h"

namespace dsphere::viewer {

namespace {

// Where systems keep a plain sans serif. Without any, ImGui's own bitmap font serves, enlarged by whole steps.
constexpr const char* kFonts[] = {
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
    "/usr/share/fonts/TTF/DejaVuSans.ttf",
    "/usr/share/fonts/truetype/noto/NotoSans-Regular.ttf",
    "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
    "/System/Library/Fonts/Helvetica.ttc",
    "C:/Windows/Fonts/segoeui.ttf",
};
constexpr float kFontPixels = 15.0f, kBitmapPixels = 13.0f;

void loadFont(double scale) {
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    for (const char* path : kFonts) {
        std::error_code error;
        if (!std::filesystem::is_regular_file(path, error)) continue;
        if (atlas.AddFontFromFileTTF(path, std::round(kFontPixels * float(scale)))) return;
    }
    ImFontConfig config;
    config.SizePixels = kBitmapPixels * float(std::max(1.0, std::round(scale)));
    atlas.AddFontDefault(&config);
}

void setColours(ImGuiStyle& style) {
    ImGui::StyleColorsDark(&style);
    const ImVec4 accent(0.24f, 0.52f, 0.88f, 1.0f), faint(1.0f, 1.0f, 1.0f, 0.07f);
    style.Colors[ImGuiCol_WindowBg] = ImVec4(0.09f, 0.09f, 0.10f, 1.0f);
    style.Colors[ImGuiCol_PopupBg] = ImVec4(0.13f, 0.13f, 0.14f, 1.0f);  // no text through text
    style.Colors[ImGuiCol_Border] = ImVec4(1.0f, 1.0f, 1.0f, 0.10f);
    style.Colors[ImGuiCol_FrameBg] = faint;
    style.Colors[ImGuiCol_FrameBgHovered] = ImVec4(1.0f, 1.0f, 1.0f, 0.13f);
    style.Colors[ImGuiCol_FrameBgActive] = ImVec4(1.0f, 1.0f, 1.0f, 0.18f);
    style.Colors[ImGuiCol_Button] = ImVec4(1.0f, 1.0f, 1.0f, 0.10f);
    style.Colors[ImGuiCol_ButtonHovered] = ImVec4(0.24f, 0.52f, 0.88f, 0.55f);
    style.Colors[ImGuiCol_ButtonActive] = accent;
    style.Colors[ImGuiCol_SliderGrab] = style.Colors[ImGuiCol_CheckMark] = accent;
    style.Colors[ImGuiCol_SliderGrabActive] = ImVec4(0.36f, 0.64f, 1.0f, 1.0f);
    style.Colors[ImGuiCol_Header] = faint;
}

}  // namespace

int statusHeight(double scale) {
    return int(std::round(27.0 * scale));
}

void applyStyle(double scale) {
    ImGuiStyle style;
    setColours(style);
    style.WindowPadding = ImVec2(12.0f, 10.0f);
    style.FramePadding = ImVec2(8.0f, 4.0f);
    style.ItemSpacing = ImVec2(8.0f, 6.0f);
    style.ItemInnerSpacing = ImVec2(8.0f, 4.0f);
    style.WindowRounding = 6.0f;
    style.FrameRounding = style.GrabRounding = 4.0f;
    style.GrabMinSize = 12.0f;
    style.ScrollbarSize = 12.0f;
    style.WindowBorderSize = 1.0f;
    style.ScaleAllSizes(float(scale));
    ImGui::GetStyle() = style;
    loadFont(scale);
}

}  // namespace dsphere::viewer
