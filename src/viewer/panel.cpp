#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "scene/ramps.h"
#include "viewer/ui.h"

namespace dsphere::viewer {

namespace {

void heading(const char* text) {
    ImGui::Dummy(ImVec2(0.0f, 0.1f * ImGui::GetFontSize()));
    ImGui::TextColored(ImVec4(0.45f, 0.70f, 1.0f, 1.0f), "%s", text);
}

bool slider(const char* name, double& value, double low, double high, const char* format,
            ImGuiSliderFlags flags = ImGuiSliderFlags_None) {
    return ImGui::SliderScalar(name, ImGuiDataType_Double, &value, &low, &high, format, flags);
}

// Pixels that the surface may be off where texels are smaller than pixels.
void detailChoice(float& detail) {
    constexpr float kPixels[] = {0.0f, 0.5f, 1.0f, 2.0f};
    int chosen = int(std::ranges::lower_bound(kPixels, detail) - std::begin(kPixels));
    if (ImGui::Combo("detail", &chosen, "exact\0half a pixel\0one pixel\0two pixels\0")) detail = kPixels[chosen];
}

void marchSection(Ui& ui) {
    heading("Marcher");
    int marcher = int(ui.view.method.marcher);
    if (ImGui::Combo("marcher", &marcher, kMarcherNames, IM_ARRAYSIZE(kMarcherNames)))
        ui.view.method.marcher = Marcher(marcher);
    if (ui.view.method.marcher == Marcher::Exact) detailChoice(ui.view.method.detail);
    ImGui::Checkbox("split: naive | this", &ui.view.split);
    int show = int(ui.view.show);
    if (ImGui::Combo("value", &show, kShowNames, kShowCount)) ui.view.show = Show(show);
    if (ui.view.show == Show::Steps)
        ImGui::SliderFloat("red at", &ui.tone.most_steps, 5.0f, 5000.0f, "%.0f steps", ImGuiSliderFlags_Logarithmic);
}

void reliefSection(Ui& ui) {
    if (!ui.displaced) return;
    heading("Relief");
    slider("exaggeration", ui.tuning.exaggeration, 0.0, 10.0, "%.2f", ImGuiSliderFlags_None);
    slider("midlevel", ui.tuning.midlevel, -1.0, 1.0, "%.3f");
    if (ui.ripples) return;
    int filter = int(ui.tuning.filter);
    if (ImGui::Combo("filter", &filter, "bilinear\0bspline\0")) ui.tuning.filter = Filter(filter);
}

void lightSection(Ui& ui) {
    heading("Light");
    if (ui.sun) {
        slider("sun longitude", ui.sun->longitude, -180.0, 180.0, "%.1f°");
        slider("sun latitude", ui.sun->latitude, -90.0, 90.0, "%.1f°");
    } else {
        ImGui::TextDisabled("the scene has no distant light");
    }
    ImGui::SliderFloat("exposure", &ui.tone.exposure, -6.0f, 6.0f, "%+.2f stops");
}

void materialSection(Ui& ui) {
    if (!ui.material) return;
    heading("Material");
    Texture& texture = *ui.material;
    std::string current = "colour Kd";
    if (const auto* ramp = std::get_if<HeightRamp>(&texture)) current = ramp->ramp;
    if (std::holds_alternative<ImageMap>(texture)) current = "image";
    if (std::holds_alternative<Checkerboard>(texture)) current = "checkerboard";
    if (ImGui::BeginCombo("material", current.c_str())) {
        if (ImGui::Selectable("colour Kd", std::holds_alternative<ConstantColour>(texture))) texture = ConstantColour{};
        if (ui.displaced)
            for (const Ramp& ramp : ramps()) {
                std::string name(ramp.name);
                if (ImGui::Selectable(name.c_str(), name == current)) texture = HeightRamp{.ramp = name};
            }
        if (ui.image && ImGui::Selectable("image", current == "image")) texture = *ui.image;
        ImGui::EndCombo();
    }
    if (auto* constant = std::get_if<ConstantColour>(&texture)) {
        float rgb[3] = {float(constant->rgb.x), float(constant->rgb.y), float(constant->rgb.z)};
        if (ImGui::ColorEdit3("Kd", rgb, ImGuiColorEditFlags_Float))
            constant->rgb = {double(rgb[0]), double(rgb[1]), double(rgb[2])};
    }
}

void keepSection(Ui& ui) {
    heading("Keep");
    if (ImGui::Button("Screenshot")) ui.command = Command::Screenshot;
    ImGui::SameLine();
    if (ImGui::Button("Copy camera")) ui.command = Command::CopyCamera;
    if (ImGui::Button("Save scene")) ui.command = Command::SaveScene;
    ImGui::SameLine();
    if (ImGui::Button("Reset view")) ui.command = Command::Reset;
}

void figuresSection(const Figures& figures) {
    heading("Figures");
    ImGui::TextDisabled("%s",
                        fmt::format("{}\n{}x{}, sample {} of {}\n{:.1f} ms a frame, {:.1f} M rays/s", figures.device,
                                    figures.width, figures.height, figures.samples, figures.target_samples,
                                    1e3 * figures.frame_seconds, 1e-6 * figures.rays_per_second)
                            .c_str());
}

}  // namespace

void drawPanel(Ui& ui, int width, int height, double scale) {
    float pad = 12.0f * float(scale), wide = std::min(330.0f * float(scale), float(width) - 2.0f * pad);
    float most = float(height - statusHeight(scale)) - 2.0f * pad;
    ImGui::SetNextWindowPos(ImVec2(float(width) - pad, pad), ImGuiCond_Always, ImVec2(1.0f, 0.0f));
    ImGui::SetNextWindowSizeConstraints(ImVec2(wide, 0.0f), ImVec2(wide, most));
    ImGui::Begin("Panel", &ui.panel_open,
                 ImGuiWindowFlags_AlwaysAutoResize | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoCollapse |
                     ImGuiWindowFlags_NoSavedSettings);
    ImGui::PushItemWidth(0.58f * ImGui::GetContentRegionAvail().x);
    marchSection(ui);
    reliefSection(ui);
    lightSection(ui);
    materialSection(ui);
    keepSection(ui);
    figuresSection(ui.figures);
    ImGui::PopItemWidth();
    ImGui::End();
}

}  // namespace dsphere::viewer
