#include "report/plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace dsphere::report {

namespace {

using Anchor = Svg::Anchor;

constexpr double kLeft = 58.0, kGap = 22.0, kTop = 52.0, kBottom = 46.0, kPanelHeight = 250.0, kWidth = 1080.0;
constexpr double kLineHeight = 12.0;

/// Finds room for labels: no label covers a mark, another label or the frame.
class Labels {
  public:
    explicit Labels(const Extent& frame) : frame_(frame) {}

    void block(const Extent& extent) { taken_.push_back(extent); }

    void blockLine(const std::vector<dvec2>& line) {
        constexpr int kPieces = 16;
        for (std::size_t k = 1; k < line.size(); ++k)
            for (int piece = 0; piece <= kPieces; ++piece) {
                dvec2 p = glm::mix(line[k - 1], line[k], double(piece) / kPieces);
                block({p.x - 1.0, p.y - 1.0, p.x + 1.0, p.y + 1.0});
            }
    }

    /// Whether there was room.
    bool place(Svg& svg, dvec2 at, const std::string& label) {
        double width = textWidth(label), reach = 8.0;
        const Extent tries[] = {{at.x + reach, at.y - 6.0, at.x + reach + width, at.y + 6.0},
                                {at.x - reach - width, at.y - 6.0, at.x - reach, at.y + 6.0},
                                {at.x - 0.5 * width, at.y - reach - kLineHeight, at.x + 0.5 * width, at.y - reach},
                                {at.x - 0.5 * width, at.y + reach, at.x + 0.5 * width, at.y + reach + kLineHeight}};
        for (const Extent& extent : tries) {
            bool clash = std::ranges::any_of(taken_, [&](const Extent& other) { return extent.overlaps(other); });
            if (clash || !extent.within(frame_)) continue;
            svg.text({extent.x0, extent.y1 - 3.0}, Anchor::Start, "small faint", escapeXml(label));
            block(extent);
            return true;
        }
        return false;
    }

  private:
    Extent frame_;
    std::vector<Extent> taken_;
};

void drawLegend(Svg& svg, const std::vector<Panel>& panels) {
    double x = kLeft;
    std::vector<std::string> seen;
    for (const Panel& panel : panels)
        for (const PlotSeries& series : panel.series) {
            if (std::ranges::find(seen, series.name) != seen.end()) continue;
            seen.push_back(series.name);
            if (series.points.size() > 1) svg.polyline({{x, 14.0}, {x + 20.0, 14.0}}, fmt::format("l{}", series.style));
            svg.mark({x + 10.0, 14.0}, series.style, "");
            svg.text({x + 26.0, 18.0}, Anchor::Start, "", escapeXml(series.name));
            x += 26.0 + textWidth(series.name) * 1.15 + 22.0;
        }
}

void drawAxes(Svg& svg, const Extent& frame, const LogScale& x, const LogScale& y, const std::vector<double>& x_ticks,
              bool first) {
    for (double tick : x_ticks) {
        svg.line({x.at(tick), frame.y0}, {x.at(tick), frame.y1}, "grid");
        svg.text({x.at(tick), frame.y1 + 15.0}, Anchor::Middle, "small", tickLabel(tick));
    }
    for (double tick : logTicks(y)) {
        svg.line({frame.x0, y.at(tick)}, {frame.x1, y.at(tick)}, "grid");
        if (first) svg.text({frame.x0 - 6.0, y.at(tick) + 3.5}, Anchor::End, "small", tickLabel(tick));
    }
    svg.rectangle(frame, "frame");
}

void drawPanel(Svg& svg, const Panel& panel, const Extent& frame, const LogScale& x, const LogScale& y) {
    Labels labels(frame);
    svg.text({frame.x0, frame.y0 - 7.0}, Anchor::Start, "title", escapeXml(panel.title));
    if (panel.floor > 0.0) {
        double at = y.at(panel.floor);
        svg.line({frame.x0, at}, {frame.x1, at}, "floor l3");
        labels.block({frame.x0, at - 2.0, frame.x1, at + 2.0});
    }
    for (const PlotSeries& series : panel.series) {
        std::vector<dvec2> line;
        for (const PlotPoint& point : series.points) {
            line.push_back({x.at(point.x), y.at(point.y)});
            labels.block({line.back().x - 6.0, line.back().y - 6.0, line.back().x + 6.0, line.back().y + 6.0});
            if (!(point.y_low < point.y_high)) continue;
            Extent bar{line.back().x, y.at(point.y_high), line.back().x, y.at(point.y_low)};
            svg.line({bar.x0, bar.y0}, {bar.x1, bar.y1}, fmt::format("l{} bar", series.style));
            labels.block({bar.x0 - 2.0, bar.y0, bar.x1 + 2.0, bar.y1});
        }
        labels.blockLine(line);
        if (line.size() > 1) svg.polyline(line, fmt::format("l{}", series.style));
    }
    if (double at = y.at(panel.floor);
        panel.floor > 0.0 && !labels.place(svg, {frame.x0 - 4.0, at - 9.0}, panel.floor_label))
        labels.place(svg, {frame.x0 - 4.0, at + 9.0}, panel.floor_label);
    for (const PlotSeries& series : panel.series)
        for (const PlotPoint& point : series.points) {
            dvec2 at(x.at(point.x), y.at(point.y));
            svg.mark(at, series.style, point.tooltip);
            if (!point.label.empty()) labels.place(svg, at, point.label);
        }
}

}  // namespace

std::string drawPanels(const PanelRow& row) {
    Svg svg(kWidth, kTop + kPanelHeight + kBottom, row.title);
    std::vector<double> xs, ys;
    for (const Panel& panel : row.panels) {
        if (panel.floor > 0.0) ys.push_back(panel.floor);
        for (const PlotSeries& series : panel.series)
            for (const PlotPoint& point : series.points) {
                xs.push_back(point.x);
                ys.insert(ys.end(), {point.y, point.y_low, point.y_high});
            }
    }
    drawLegend(svg, row.panels);
    double count = double(std::max<std::size_t>(row.panels.size(), 1));
    // A lone panel as wide as the page would be all grid.
    double width = std::min((kWidth - kLeft - 8.0 - (count - 1.0) * kGap) / count, 640.0);
    LogScale y = logScale(ys, kTop + kPanelHeight, kTop);
    for (std::size_t k = 0; k < row.panels.size(); ++k) {
        double left = kLeft + double(k) * (width + kGap);
        Extent frame{left, kTop, left + width, kTop + kPanelHeight};
        LogScale x = logScale(xs, frame.x0, frame.x1);
        drawAxes(svg, frame, x, y, row.x_ticks.empty() ? logTicks(x) : row.x_ticks, k == 0);
        drawPanel(svg, row.panels[k], frame, x, y);
    }
    double middle = kLeft + 0.5 * (count * (width + kGap) - kGap);
    svg.text({middle, kTop + kPanelHeight + 38.0}, Anchor::Middle, "", escapeXml(row.x_label));
    svg.text({14.0, kTop + 0.5 * kPanelHeight}, Anchor::Middle, "", escapeXml(row.y_label), true);
    return svg.finish();
}

std::string drawDots(const DotPlot& plot) {
    constexpr double kNames = 96.0, kRow = 21.0, kDotWidth = 540.0;
    double height = kRow * double(plot.rows.size());
    Svg svg(kDotWidth, kTop + height + kBottom, plot.title);
    Extent frame{kNames, kTop - 14.0, kDotWidth - 12.0, kTop - 14.0 + height};
    std::vector<double> values;
    for (const DotPlot::Row& row : plot.rows) values.insert(values.end(), row.values.begin(), row.values.end());
    LogScale x = logScale(values, frame.x0, frame.x1);
    double legend = kNames;
    for (std::size_t k = 0; k < plot.columns.size(); ++k) {
        svg.mark({legend + 6.0, 14.0}, int(k), "");
        svg.text({legend + 16.0, 18.0}, Anchor::Start, "", escapeXml(plot.columns[k]));
        legend += 16.0 + textWidth(plot.columns[k]) * 1.15 + 22.0;
    }
    for (double tick : logTicks(x)) {
        svg.line({x.at(tick), frame.y0}, {x.at(tick), frame.y1}, "grid");
        svg.text({x.at(tick), frame.y1 + 15.0}, Anchor::Middle, "small", tickLabel(tick));
    }
    svg.rectangle(frame, "frame");
    for (std::size_t j = 0; j < plot.rows.size(); ++j) {
        const DotPlot::Row& row = plot.rows[j];
        double y = frame.y0 + (double(j) + 0.5) * kRow;
        svg.text({kNames - 8.0, y + 4.0}, Anchor::End, "", escapeXml(row.name));
        svg.line({frame.x0, y}, {frame.x1, y}, "grid");
        for (std::size_t k = 0; k < row.values.size(); ++k)
            if (row.values[k] > 0.0)
                svg.mark({x.at(row.values[k]), y}, int(k),
                         fmt::format("{}, {}: {:.4g}", row.name, plot.columns[k], row.values[k]));
    }
    svg.text({0.5 * (frame.x0 + frame.x1), frame.y1 + 38.0}, Anchor::Middle, "", escapeXml(plot.x_label));
    return svg.finish();
}

}  // namespace dsphere::report
