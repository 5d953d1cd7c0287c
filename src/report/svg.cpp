#include "report/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace dsphere::report {

double LogScale::at(double value) const {
    return from + (to - from) * std::log(value / low) / std::log(high / low);
}

LogScale logScale(const std::vector<double>& values, double from, double to) {
    double low = 0.0, high = 0.0;
    for (double value : values) {
        if (!(value > 0.0) || !std::isfinite(value)) continue;
        low = low > 0.0 ? std::min(low, value) : value;
        high = std::max(high, value);
    }
    if (low == 0.0) return {1.0, 10.0, from, to};
    constexpr double kRoom = 1.35, kLeastSpan = 10.0;
    low /= kRoom;
    high *= kRoom;
    double lacking = kLeastSpan / (high / low);
    if (lacking > 1.0) low /= std::sqrt(lacking), high *= std::sqrt(lacking);
    return {low, high, from, to};
}

std::vector<double> logTicks(const LogScale& scale) {
    std::vector<double> ticks;
    bool fine = scale.high / scale.low < 1000.0;
    for (int decade = int(std::floor(std::log10(scale.low))); decade <= int(std::log10(scale.high)) + 1; ++decade)
        for (double leading : {1.0, 2.0, 5.0}) {
            double value = leading * std::pow(10.0, decade);
            if ((fine || leading == 1.0) && value >= scale.low && value <= scale.high) ticks.push_back(value);
        }
    return ticks;
}

std::string tickLabel(double value) {
    if (value >= 0.00099 && value < 1e6) return fmt::format("{:.6g}", value);
    int power = int(std::lround(std::floor(std::log10(value) + 1e-9)));
    double leading = value / std::pow(10.0, power);
    std::string sign = power < 0 ? "\xE2\x88\x92" : "";
    std::string factor = leading > 1.5 ? fmt::format("{:.0f}·", leading) : "";
    return fmt::format("{}10<tspan dy=\"-4\" font-size=\"8\">{}{}</tspan>", factor, sign, std::abs(power));
}

std::string escapeXml(const std::string& text) {
    std::string result;
    for (char c : text) {
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (c == '"')
            result += "&quot;";
        else
            result += c;
    }
    return result;
}

Svg::Svg(double width, double height, const std::string& title)
    : text_(fmt::format("<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:g} {1:g}\" width=\"{0:g}\" "
                        "height=\"{1:g}\" role=\"img\">\n<title>{2}</title>\n",
                        width, height, escapeXml(title))) {}

void Svg::line(dvec2 a, dvec2 b, const std::string& css) {
    text_ += fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\" class=\"{}\"/>\n", a.x, a.y,
                         b.x, b.y, css);
}

void Svg::polyline(const std::vector<dvec2>& points, const std::string& css) {
    text_ += fmt::format("<polyline class=\"{}\" points=\"", css);
    for (const dvec2& p : points) text_ += fmt::format("{:.1f},{:.1f} ", p.x, p.y);
    text_ += "\"/>\n";
}

void Svg::rectangle(const Extent& extent, const std::string& css) {
    text_ += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" class=\"{}\"/>\n",
                         extent.x0, extent.y0, extent.x1 - extent.x0, extent.y1 - extent.y0, css);
}

void Svg::text(dvec2 at, Anchor anchor, const std::string& css, const std::string& markup, bool upward) {
    const char* words[] = {"start", "middle", "end"};
    std::string turn = upward ? fmt::format(" transform=\"rotate(-90 {:.1f} {:.1f})\"", at.x, at.y) : "";
    text_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"{}\" class=\"{}\"{}>{}</text>\n", at.x, at.y,
                         words[int(anchor)], css, turn, markup);
}

namespace {

// The outline of each style's mark, of a radius of 1: shapes tell methods apart where colours do not.
const std::vector<dvec2>& outline(int style) {
    static const std::vector<std::vector<dvec2>> kOutlines = {
        {},                                                            // a circle
        {{-0.88, -0.88}, {0.88, -0.88}, {0.88, 0.88}, {-0.88, 0.88}},  // square
        {{0.0, -1.25}, {1.25, 0.0}, {0.0, 1.25}, {-1.25, 0.0}},        // diamond
        {{0.0, -1.2}, {1.1, 0.8}, {-1.1, 0.8}},                        // triangle
        {{0.0, 1.2}, {1.1, -0.8}, {-1.1, -0.8}},                       // triangle, point down
        {{-0.4, -1.2},
         {0.4, -1.2},
         {0.4, -0.4},
         {1.2, -0.4},
         {1.2, 0.4},
         {0.4, 0.4},  // cross
         {0.4, 1.2},
         {-0.4, 1.2},
         {-0.4, 0.4},
         {-1.2, 0.4},
         {-1.2, -0.4},
         {-0.4, -0.4}},
        {{0.0, -1.15}, {1.09, -0.36}, {0.68, 0.93}, {-0.68, 0.93}, {-1.09, -0.36}},  // pentagon
        {{-1.2, -0.5}, {1.2, -0.5}, {1.2, 0.5}, {-1.2, 0.5}},                        // bar
    };
    return kOutlines[std::size_t(style)];
}

}  // namespace

void Svg::mark(dvec2 at, int style, const std::string& tooltip, double size) {
    std::string title = tooltip.empty() ? "" : "<title>" + escapeXml(tooltip) + "</title>";
    const std::vector<dvec2>& shape = outline(style % kStyles);
    if (shape.empty()) {
        text_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:g}\" class=\"m f{}\">{}</circle>\n", at.x, at.y,
                             size, style % kStyles, title);
        return;
    }
    text_ += fmt::format("<polygon class=\"m f{}\" points=\"", style % kStyles);
    for (const dvec2& p : shape) text_ += fmt::format("{:.1f},{:.1f} ", at.x + size * p.x, at.y + size * p.y);
    text_ += fmt::format("\">{}</polygon>\n", title);
}

// The palette of Okabe and Ito, which colour-blind readers can tell apart; lighter on dark ground.
std::string plotStyle() {
    const char* light[] = {"#0072b2", "#d55e00", "#b8860b", "#6b6b6b", "#009e73", "#b0558a", "#7b5bd6", "#8a3b12"};
    const char* dark[] = {"#56b4e9", "#f0884a", "#e6c229", "#a8a8a8", "#2fc99b", "#dd8fbb", "#b49cf5", "#c98f6b"};
    std::string css =
        "svg text{font:11px system-ui,sans-serif;fill:var(--ink)}svg .small{font-size:10px}"
        "svg .title{font-size:12px;font-weight:600}svg .faint{fill:var(--faint)}"
        "svg .grid{stroke:var(--grid);stroke-width:1}svg .frame{fill:none;stroke:var(--faint);stroke-width:1}"
        "svg .m{stroke:var(--paper);stroke-width:1;fill-opacity:.9}svg .bar{stroke-width:1.5;stroke-opacity:.45}svg "
        "polyline{fill:none;stroke-width:1.5}"
        "svg .floor{stroke-dasharray:5 4;stroke-width:1.5}\n";
    auto variables = [&](const char* const* colours, const char* ink, const char* faint, const char* grid,
                         const char* paper) {
        std::string list = fmt::format("--ink:{};--faint:{};--grid:{};--paper:{};", ink, faint, grid, paper);
        for (int k = 0; k < Svg::kStyles; ++k) list += fmt::format("--c{}:{};", k, colours[k]);
        return list;
    };
    css += ":root{" + variables(light, "#1b1b1b", "#666666", "#e3e3e3", "#ffffff") + "}\n";
    css += "@media(prefers-color-scheme:dark){:root{" + variables(dark, "#e8e8e8", "#a0a0a0", "#3a3a3a", "#17191c") +
           "}}\n";
    for (int k = 0; k < Svg::kStyles; ++k)
        css += fmt::format("svg .f{0}{{fill:var(--c{0})}}svg .l{0}{{stroke:var(--c{0})}}", k);
    return css + "\n";
}

double textWidth(const std::string& text) {
    return 5.6 * double(text.size());
}

}  // namespace dsphere::report
