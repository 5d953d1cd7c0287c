// What lies over the picture's edge: compass, scale bar and scales of colours.

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "base/srgb.h"
#include "scene/ramps.h"
#include "viewer/displayworld.h"
#include "viewer/ui.h"

namespace dsphere::viewer {

namespace {

constexpr ImU32 kWhite = IM_COL32(255, 255, 255, 235), kShade = IM_COL32(0, 0, 0, 220),
                kSun = IM_COL32(255, 205, 70, 255);

constexpr float kScaleLeft = 92.0f, kBarLeft = 290.0f,
                kLeastStrip = 180.0f;  // pixels at scale 1; the compass is left of the first two

void drawShadedText(const ImVec2& at, const std::string& text, double scale, float wrap = 0.0f) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const auto draw = [&](const ImVec2& corner, ImU32 colour) {
        list.AddText(ImGui::GetFont(), ImGui::GetFontSize(), corner, colour, text.c_str(), nullptr, wrap);
    };
    draw(ImVec2(at.x + float(scale), at.y + float(scale)), kShade);
    draw(at, kWhite);
}

void drawNeedle(ImDrawList& list, const ImVec2& middle, float radius, const dvec2& north) {
    const double length = glm::length(north);
    const dvec2 along = length > 1e-6 ? north / length : dvec2(0.0, 1.0);
    const float reach = 0.72f * radius * float(std::max(length, 0.25)), wide = 0.17f * radius;
    const ImVec2 tip(middle.x + reach * float(along.x), middle.y - reach * float(along.y));
    const ImVec2 tail(middle.x - reach * float(along.x), middle.y + reach * float(along.y));
    const ImVec2 left(middle.x - wide * float(along.y), middle.y - wide * float(along.x));
    const ImVec2 right(middle.x + wide * float(along.y), middle.y + wide * float(along.x));
    list.AddTriangleFilled(tip, left, right, IM_COL32(235, 90, 80, 255));
    list.AddTriangleFilled(tail, left, right, IM_COL32(225, 225, 230, 255));
}

/// On the compass's rim, hollow behind the window.
void drawSun(ImDrawList& list, const ImVec2& middle, float radius, const dvec3& sun) {
    const ImVec2 at(middle.x + 0.85f * radius * float(sun.x), middle.y - 0.85f * radius * float(sun.y));
    const float size = 0.16f * radius;
    if (sun.z >= 0.0)
        list.AddCircleFilled(at, size, kSun);
    else
        list.AddCircle(at, size, kSun, 0, 0.06f * radius);
}

/// The colours of display.comp's heat().
ImU32 heatCode(double share) {
    const auto channel = [&](double at) {
        return int(std::lround(255.0 * std::clamp(1.5 - std::abs(4.0 * std::clamp(share, 0.0, 1.0) - at), 0.0, 1.0)));
    };
    return IM_COL32(channel(3.0), channel(2.0), channel(1.0), 255);
}

ImU32 greyCode(double share) {
    const int code = int(std::lround(255.0 * (1.0 - 0.9 * share)));
    return IM_COL32(code, code, code, 255);
}

/// A scale of colours, with what its ends stand for.
struct ColourBar {
    std::string title, low, middle, high;
    std::function<ImU32(double)> code;
};

std::string withUnit(double value, const std::string& unit) {
    return fmt::format("{:.5g}{}{}", value, unit.empty() || unit == "°" ? "" : " ", unit);
}

ColourBar linearBar(const std::string& title, double low, double high, const std::string& unit,
                    std::function<ImU32(double)> code) {
    return {title, withUnit(low, unit), withUnit(0.5 * (low + high), unit), withUnit(high, unit), std::move(code)};
}

int srgbCode(double light) {
    return int(std::lround(255.0 * std::clamp(srgbFromLinear(light), 0.0, 1.0)));
}

ColourBar rampBar(const Figures::RampScale& scale) {
    const int index = findRamp(scale.ramp);
    return linearBar("Height", scale.low, scale.high, scale.unit, [index](double share) {
        const dvec3 light = rampColour(ramps()[std::size_t(std::max(index, 0))], share);
        return IM_COL32(srgbCode(light.x), srgbCode(light.y), srgbCode(light.z), 255);
    });
}

std::optional<ColourBar> barOf(const Ui& ui) {
    const Figures& figures = ui.figures;
    const ShownRange& range = figures.range;
    const ToneSettings& tone = ui.subject.state.tone;
    const double world = figures.gauges.unit.per_world;
    switch (ui.subject.state.view.show) {
        case Show::Heights:
            return linearBar(
                fmt::format("Height, a contour every {}", withUnit(range.contour_spacing, figures.height_unit)),
                range.least_height, range.greatest_height, figures.height_unit, heatCode);
        case Show::Slope:
            return linearBar("Slope of the ground as shown", 0.0, double(tone.most_slope), "°", heatCode);
        case Show::Distance:
            return linearBar("Distance from the eye", world * range.near, world * range.far, figures.gauges.unit.name(),
                             greyCode);
        case Show::Steps:
            return linearBar("Steps of the search", 0.0, double(tone.most_steps), "", heatCode);
        case Show::Residual:
            return ColourBar{"Distance of the hit from the surface", "1e-9 R", "1e-7 R", "1e-5 R", heatCode};
        case Show::Colour:
            if (figures.ramp) return rampBar(*figures.ramp);
            return {};
        default:
            return {};
    }
}

/// Where a scale of colours or a legend goes.
struct Strip {
    float left, right, bottom;
};

// Beside the scale bar, or above the compass where there is no room.
Strip stripOf(const Ui& ui, const Extent& window) {
    const float unit = float(window.scale), margin = 12.0f * unit;
    const float bottom = float(window.height - statusHeight(window.scale));
    const float right = freeRight(ui, window, bottom - 60.0f * unit) - margin;
    if (right - kBarLeft * unit >= kLeastStrip * unit) return {kBarLeft * unit, right, bottom};
    return {margin, freeRight(ui, window, bottom - 140.0f * unit) - margin, bottom - 78.0f * unit};
}

/// What text over the picture is read on.
void drawBacking(const ImVec2& low, const ImVec2& high, double scale) {
    const float pad = 5.0f * float(scale);
    ImGui::GetBackgroundDrawList()->AddRectFilled(ImVec2(low.x - pad, low.y - pad), ImVec2(high.x + pad, high.y + pad),
                                                  IM_COL32(20, 20, 24, 150), pad);
}

/// A text above `bottom`, and what it is read on, which holds what is beneath it, too: so wide, as far as `end`.
void drawLegend(const std::string& text, const Strip& strip, float bottom, float wide, float end, double scale) {
    const float wrap = std::max(strip.right - strip.left, kLeastStrip * float(scale));
    const ImVec2 size = ImGui::CalcTextSize(text.c_str(), nullptr, false, wrap);
    const ImVec2 corner(strip.left, bottom - size.y);
    drawBacking(corner, ImVec2(strip.left + std::max(size.x, wide), end), scale);
    drawShadedText(corner, text, scale, wrap);
}

void drawColourBar(const ColourBar& bar, const Strip& strip, double scale) {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    constexpr int kPieces = 64;
    const float unit = float(scale), high = 10.0f * unit, line = ImGui::GetFontSize(), left = strip.left;
    const float wide = std::clamp(strip.right - left, 60.0f * unit, 260.0f * unit);
    const float top = strip.bottom - line - high - 14.0f * unit;
    const float below = top + high + 3.0f * unit, gap = 8.0f * unit;
    drawLegend(bar.title, strip, top - 4.0f * unit, wide, below + line, scale);
    list.AddRectFilled(ImVec2(left - unit, top - unit), ImVec2(left + wide + unit, top + high + unit), kShade);
    for (int i = 0; i < kPieces; ++i) {
        const ImU32 begin = bar.code(double(i) / kPieces), end = bar.code(double(i + 1) / kPieces);
        list.AddRectFilledMultiColor(ImVec2(left + wide * float(i) / kPieces, top),
                                     ImVec2(left + wide * float(i + 1) / kPieces, top + high), begin, end, end, begin);
    }
    const auto width = [](const std::string& text) { return ImGui::CalcTextSize(text.c_str()).x; };
    const float outer = std::max(width(bar.low), width(bar.high));
    drawShadedText(ImVec2(left, below), bar.low, scale);
    if (2.0f * (outer + gap) + width(bar.middle) <= wide)
        drawShadedText(ImVec2(left + 0.5f * (wide - width(bar.middle)), below), bar.middle, scale);
    drawShadedText(ImVec2(left + wide - width(bar.high), below), bar.high, scale);
}

/// What the colours of a value mean that has no scale.
std::string legend(const Ui& ui) {
    switch (ui.subject.state.view.show) {
        case Show::Graticule:
            return fmt::format("A line every {:g}° of longitude and latitude", ui.figures.range.graticule_spacing);
        case Show::Normal:
            return "Normals: x, y and z as red, green and blue";
        case Show::Uv:
            return "Map coordinates: u as red, v as green";
        case Show::Albedo:
            return "Albedo: the share of light that the ground reflects";
        default:
            return {};
    }
}

}  // namespace

void drawScaleBar(const Ui& ui, const Extent& window) {
    const Gauges& gauges = ui.figures.gauges;
    if (!(gauges.pixel > 0.0)) return;
    const float unit = float(window.scale), line = ImGui::GetFontSize();
    const double pixel = gauges.unit.per_world * gauges.pixel;
    const double length = roundStep(150.0 * window.scale * pixel);
    const float wide = float(length / pixel), bottom = float(window.height - statusHeight(window.scale)) - 16.0f * unit;
    const float left = kScaleLeft * unit, right = left + wide;
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    const std::string text = gauges.unit.text(length / gauges.unit.per_world);
    for (int pass = 0; pass < 2; ++pass) {
        const ImU32 colour = pass == 0 ? kShade : kWhite;
        const float thick = (pass == 0 ? 4.0f : 2.0f) * unit;
        list.AddLine(ImVec2(left, bottom), ImVec2(right, bottom), colour, thick);
        for (const float x : {left, right})
            list.AddLine(ImVec2(x, bottom - 5.0f * unit), ImVec2(x, bottom + 5.0f * unit), colour, thick);
    }
    drawShadedText(ImVec2(0.5f * (left + right - ImGui::CalcTextSize(text.c_str()).x), bottom - line - 7.0f * unit),
                   text, window.scale);
}

void drawCompass(Ui& ui, const Extent& window) {
    const float unit = float(window.scale), size = 64.0f * unit, pad = 10.0f * unit;
    const float bottom = float(window.height - statusHeight(window.scale));
    ImGui::SetNextWindowPos(ImVec2(pad, bottom - size - pad));
    ImGui::SetNextWindowSize(ImVec2(size, size));
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0.0f, 0.0f));
    ImGui::Begin("compass", nullptr,
                 ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoBackground | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoFocusOnAppearing |
                     ImGuiWindowFlags_NoBringToFrontOnFocus);
    if (ImGui::InvisibleButton("north up", ImVec2(size, size))) ui.command = Command::NorthUp;
    notePlace(ui, "Compass");
    showTip(
        ui,
        "The red end points north, the yellow dot to the sun: hollow where it stands behind the picture. Click: north "
        "up (N).");
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 corner = ImGui::GetWindowPos();
    const ImVec2 middle(corner.x + 0.5f * size, corner.y + 0.5f * size);
    const float radius = 0.46f * size;
    list.AddCircleFilled(middle, radius, IM_COL32(20, 20, 24, ImGui::IsItemHovered() ? 220 : 150));
    list.AddCircle(middle, radius, IM_COL32(255, 255, 255, 120), 0, unit);
    drawNeedle(list, middle, radius, ui.figures.gauges.north);
    if (ui.figures.gauges.sun) drawSun(list, middle, radius, *ui.figures.gauges.sun);
    ImGui::End();
    ImGui::PopStyleVar();
}

void drawInstruments(Ui& ui, const Extent& window) {
    if (!ui.subject.original || !ui.has_picture) return;
    const Strip strip = stripOf(ui, window);
    const float foot = strip.bottom - ImGui::GetFontSize();
    if (const auto bar = barOf(ui))
        drawColourBar(*bar, strip, window.scale);
    else if (const std::string text = legend(ui); !text.empty())
        drawLegend(text, strip, foot, 0.0f, foot, window.scale);
    drawScaleBar(ui, window);
    drawCompass(ui, window);
}

}  // namespace dsphere::viewer
