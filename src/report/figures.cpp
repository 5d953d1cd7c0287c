#include "report/figures.h"

#include "report/format.h"
#include "report/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

namespace dsphere::report {

namespace {

constexpr const char* kFloor = "smooth";

int styleOf(const std::string& family) {
    const char* families[] = {"exact", "naive", "lipschitz", kFloor, "grid", "triangles", "detail", "iterated"};
    for (int k = 0; k < int(std::size(families)); ++k)
        if (family == families[k]) return k;
    return 0;
}

// "naive 1e-4" of the family naive -> "1e-4"; the family's own name stands for its finest setting.
std::string settingOf(const MethodResult& method) {
    return method.method == method.family ? "full" : method.method.substr(method.family.size() + 1);
}

PlotSeries& seriesOf(Panel& panel, const std::string& family) {
    auto found = std::ranges::find(panel.series, family, &PlotSeries::name);
    if (found != panel.series.end()) return *found;
    return panel.series.emplace_back(PlotSeries{family, styleOf(family), {}});
}

const Spread& rateOf(const MethodResult& method, RayKind kind) {
    return kind == RayKind::Primary ? method.primary.device : method.shadow.device;
}

PlotPoint pointOf(double x, const Spread& rate, const std::string& label, const std::string& tooltip) {
    return {x, 1e-6 * rate.median, 1e-6 * rate.least, 1e-6 * rate.greatest, label, tooltip};
}

Panel speedPanel(const ViewResult& view, RayKind kind) {
    Panel panel;
    panel.title = fmt::format("{}, {:.0f} % of pixels hit", view.view, 100.0 * view.hit_share);
    for (const MethodResult& method : view.methods) {
        const Spread& rate = rateOf(method, kind);
        if (!rate.measured()) continue;
        double rays = 1e-6 * rate.median;
        if (method.family == kFloor) {
            panel.floor = rays;
            panel.floor_label = fmt::format("smooth sphere {}", megaRaysMedian(rate));
        }
        if (!method.accuracy || !(method.accuracy->distance_999 > 0.0)) continue;
        double error = method.accuracy->distance_999;
        seriesOf(panel, method.family)
            .points.push_back(pointOf(
                error, rate, settingOf(method),
                fmt::format("{}: {} million rays/s, 99.9 % within {:.2g} R", method.method, megaRays(rate), error)));
    }
    for (PlotSeries& series : panel.series)
        if (series.points.size() == 1) series.points[0].label.clear();
    return panel;
}

std::vector<std::string> familiesOf(const ViewResult& view) {
    std::vector<std::string> families;
    for (const MethodResult& method : view.methods)
        if (families.empty() || families.back() != method.family) families.push_back(method.family);
    return families;
}

/// A family's most exact method on a view.
const MethodResult* finest(const ViewResult& view, const std::string& family) {
    const MethodResult* best = nullptr;
    auto error = [](const MethodResult& method) { return method.accuracy ? method.accuracy->distance_999 : 0.0; };
    for (const MethodResult& method : view.methods)
        if (method.family == family && method.skipped.empty() && (!best || error(method) < error(*best)))
            best = &method;
    return best;
}

// Of one displacement there is one view a map: that whose set-up was measured.
std::vector<const ViewResult*> firstViews(const Results& results) {
    std::vector<const ViewResult*> views;
    std::set<std::string> maps;
    for (const CaseViews& of : casesOf(results))
        if (maps.insert(of.views[0]->map).second && views.size() < std::size_t(Svg::kStyles))
            views.push_back(of.views[0]);
    return views;
}

template <typename Value>
std::string dotFigure(const Results& results, const char* title, const char* label, Value value) {
    DotPlot plot{title, label, {}, {}};
    std::vector<const ViewResult*> views = firstViews(results);
    bool any = false;
    for (const ViewResult* view : views) plot.columns.push_back(view->map);
    for (std::size_t k = 0; k < views.size(); ++k)
        for (const MethodResult& method : views[k]->methods) {
            auto row = std::ranges::find(plot.rows, method.method, &DotPlot::Row::name);
            if (row == plot.rows.end())
                row = plot.rows.insert(row, {method.method, std::vector<double>(views.size(), 0.0)});
            if (method.skipped.empty()) row->values[k] = value(method);
            any = any || row->values[k] > 0.0;
        }
    return any ? drawDots(plot) : "";
}

}  // namespace

std::vector<CaseViews> casesOf(const Results& results) {
    std::vector<CaseViews> cases;
    for (const ViewResult& view : results.views) {
        if (cases.empty() || cases.back().name != caseName(view)) cases.push_back({caseName(view), {}});
        cases.back().views.push_back(&view);
    }
    return cases;
}

const CaseViews& mainCase(const std::vector<CaseViews>& cases) {
    std::set<int> widths;
    for (const CaseViews& of : cases) widths.insert(of.views[0]->map_width);
    int middle = *std::next(widths.begin(), std::ptrdiff_t(widths.size() / 2));
    return *std::ranges::find_if(cases, [&](const CaseViews& of) { return of.views[0]->map_width == middle; });
}

std::string speedFigure(const CaseViews& of, RayKind kind) {
    const char* rays = kind == RayKind::Primary ? "primary rays" : "shadow rays";
    PanelRow row{fmt::format("{}: {} against error", of.name, rays),
                 "distance to the true surface of 99.9 % of the hits (units of the radius R)",
                 fmt::format("{} (million a second)", rays),
                 {},
                 {}};
    bool any = false;
    for (const ViewResult* view : of.views) {
        row.panels.push_back(speedPanel(*view, kind));
        any = any || !row.panels.back().series.empty();
    }
    return any ? drawPanels(row) : "";
}

std::string sizeFigure(const Results& results) {
    if (results.views.empty()) return "";
    double percent = results.views[0].percent;
    PanelRow row{"Primary rays a second against the map's size",
                 "width of the map (texels)",
                 "primary rays (million a second)",
                 {},
                 {}};
    std::set<int> widths;
    for (const ViewResult& view : results.views) {
        if (view.percent != percent) continue;
        auto panel = std::ranges::find(row.panels, view.view, &Panel::title);
        if (panel == row.panels.end()) panel = row.panels.insert(panel, Panel{view.view, {}, 0.0, ""});
        for (const std::string& family : familiesOf(view)) {
            const MethodResult* method = finest(view, family);
            if (!method || !method->primary.device.measured()) continue;
            widths.insert(view.map_width);
            const Spread& rate = method->primary.device;
            seriesOf(*panel, family)
                .points.push_back(
                    pointOf(view.map_width, rate, "",
                            fmt::format("{}, {}: {} million rays/s", method->method, view.map, megaRays(rate))));
        }
    }
    if (widths.size() < 2) return "";
    row.x_ticks.assign(widths.begin(), widths.end());
    return drawPanels(row);
}

std::string setupFigure(const Results& results) {
    return dotFigure(results, "Time to the first image", "map in memory to first image (seconds)",
                     [](const MethodResult& method) { return method.setup_seconds.median; });
}

std::string memoryFigure(const Results& results) {
    return dotFigure(results, "Memory", "maps and bounds, or mesh, and film (MiB)",
                     [](const MethodResult& method) { return double(method.memory_bytes) / 1048576.0; });
}

}  // namespace dsphere::report
